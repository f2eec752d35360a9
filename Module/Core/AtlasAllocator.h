/// Where bricks lie in the atlas.
#pragma once

#include "AtlasShape.h"
#include "BlockGrid.h"

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace flatblock
{
/// Where a brick lies: which slab, and which of its bricks.
struct BrickPlace
{
  int Slab = -1;
  int Brick = -1;

  bool IsResident() const { return this->Slab >= 0; }
  bool operator==(const BrickPlace& other) const
  {
    return this->Slab == other.Slab && this->Brick == other.Brick;
  }
  bool operator<(const BrickPlace& other) const
  {
    return std::make_pair(this->Slab, this->Brick) < std::make_pair(other.Slab, other.Brick);
  }
};

/// A box of texels that goes to another place of the same texture. Where the two overlap they are
/// apart along z and nowhere else.
struct BoxMove
{
  Index3 From = { 0, 0, 0 };
  Index3 To = { 0, 0, 0 };
  Index3 Size = { 0, 0, 0 };
};

/// What closes the gaps: moves to be carried out in order, and the bricks that have a new place by
/// them. Bricks of slabs that move as a whole keep theirs.
struct Compaction
{
  std::vector<BoxMove> Moves;
  std::int64_t Texels = 0; ///< that move
  std::vector<std::pair<BrickPlace, BrickPlace>> NewPlaces;
};

/// Hands out places for bricks. Slabs come and go with the bricks of their level.
class AtlasAllocator
{
public:
  /// An atlas without a place.
  AtlasAllocator() = default;

  /// @param depth  texels along z, at most shape.GetDepth()
  AtlasAllocator(const AtlasShape& shape, int depth);

  const AtlasShape& GetShape() const { return this->Shape; }

  /// Texels an axis.
  Index3 GetTextureSize() const;

  /// A place in the lowest slab of the level that has one, or in a new slab in the lowest gap that
  /// is wide enough; nothing where there is none.
  std::optional<BrickPlace> Allocate(int level);
  void Free(const BrickPlace& place);

  /// Fills the slabs of each level from its emptiest one, and then moves slabs down to where there
  /// is no gap below them. Once there is nothing more to move, whatever fits the shape beside the
  /// present bricks can be allocated.
  ///
  /// @param mostTexels  that may move, but for the first move: so it ends when called often enough
  Compaction Compact(std::int64_t mostTexels);

  int GetLevel(const BrickPlace& place) const { return this->Slabs[place.Slab].Level; }
  int GetNumberOfSlabs() const { return static_cast<int>(this->Slabs.size()); }

  /// The first texel of the brick at this place.
  Index3 GetOrigin(const BrickPlace& place) const;

  /// Places, with a brick or without, that have a texel in this box.
  std::vector<BrickPlace> FindPlaces(const Index3& first, const Index3& size) const;

  /// Texels that lie in bricks, and in all.
  std::int64_t GetUsedTexels() const;
  std::int64_t GetTexels() const;

  /// Texels that can hold bricks of these levels, once the gaps are closed: in begun slabs, and in
  /// layers without a slab.
  ///
  /// @param wanted  by level
  std::int64_t GetFreeTexels(const std::vector<bool>& wanted) const;

private:
  struct Slab
  {
    int Level = -1; ///< -1: there is no such slab now
    int FirstLayer = 0;
    std::vector<int> FreeBricks;
  };

  bool MergeSlabs(int level, std::int64_t mostTexels, Compaction& compaction);
  void CloseGaps(std::int64_t mostTexels, Compaction& compaction);
  int FindEmptiest(int level) const;
  std::optional<int> FindGap(int thickness) const;
  int AddSlab(int level, int firstLayer);

  AtlasShape Shape;
  int Depth = 0;
  std::vector<Slab> Slabs;
  std::vector<std::set<std::pair<int, int>>> OpenSlabs; ///< by level: first layer and number
};
} // namespace flatblock
