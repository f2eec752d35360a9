/// Which bricks go to the GPU in a frame.
#pragma once

#include "AtlasAllocator.h"
#include "BlockBorders.h"
#include "LodSelector.h"

#include <cstdint>
#include <vector>

namespace flatblock
{
struct BrickUpload
{
  std::int64_t Block = 0;
  int Level = 0;
  BlockBorder Border = {};
  BrickPlace Place;
};

/// What turns the atlas of the last frame into that of this one.
struct FramePlan
{
  bool NewAtlas = false;      ///< the texture is allocated anew, with nothing in it
  bool NewPlaces = false;     ///< the index texture has to be written
  std::vector<BoxMove> Moves; ///< within the atlas, in this order, before the uploads
  std::vector<BrickUpload> Uploads;
};

/// What lies where in the atlas, as the GPU has it once a plan was carried out.
class Residency
{
public:
  /// Forgets everything: the GPU holds nothing.
  void Clear();

  /// Plans the frame in which exactly the blocks that have a level are resident, at that level, and
  /// takes it as carried out. A brick that keeps its level is uploaded again only if its border
  /// changes; where there is room in narrow gaps only, bricks move closer together. The atlas is
  /// made anew where it is too small for these bricks, too large for the shape, or more than twice
  /// too large for the bricks.
  ///
  /// @param levels       of every block, which together fit the shape
  /// @param continuity   whether borders follow coarser neighbours
  FramePlan Plan(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
    const AtlasShape& shape, bool continuity);

  const AtlasAllocator& GetAtlas() const { return this->Atlas; }
  const std::vector<std::int8_t>& GetLevels() const { return this->Levels; }
  const std::vector<BrickPlace>& GetPlaces() const { return this->Places; }

private:
  bool CanKeepAtlas(const std::vector<std::int64_t>& bricks, const AtlasShape& shape) const;
  void StartAnew(std::size_t blocks, const std::vector<std::int64_t>& bricks,
    const AtlasShape& shape, FramePlan& plan);
  void Place(const std::vector<std::int8_t>& levels, FramePlan& plan);
  void Compact(FramePlan& plan);

  AtlasAllocator Atlas;
  std::vector<std::int8_t> Levels;
  std::vector<BlockBorder> Borders;
  std::vector<BrickPlace> Places;
  bool Continuity = false;
};
} // namespace flatblock
