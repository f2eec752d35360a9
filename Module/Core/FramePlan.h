/// Which bricks go to the GPU in a frame.
#pragma once

#include "AtlasAllocator.h"
#include "BlockBorders.h"
#include "Refinement.h"

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
  BrickParts Parts = WholeBrick;
};

/// What turns the atlas of the last frame into that of this one.
struct FramePlan
{
  bool NewAtlas = false;      ///< the texture is allocated anew, with nothing in it
  bool NewPlaces = false;     ///< the index texture has to be written
  std::vector<BoxMove> Moves; ///< within the atlas, in this order, before the uploads
  std::vector<BrickUpload> Uploads;

  bool IsEmpty() const
  {
    return !this->NewAtlas && !this->NewPlaces && this->Moves.empty() && this->Uploads.empty();
  }
};

/// What lies where in the atlas, as the GPU has it once a plan was carried out.
class Residency
{
public:
  /// Forgets everything: the GPU holds nothing.
  void Clear();

  /// Plans the frame in which exactly the blocks that have a level are resident, at that level, and
  /// takes it as carried out. Size of the atlas and places of the bricks depend on the arguments
  /// alone, so that every bit of the picture does. Bricks that are there already are moved, and
  /// where only the border changes, only that is uploaded.
  ///
  /// @param levels  of every block, which together fit the shape
  FramePlan PlanStill(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
    const AtlasShape& shape, Continuity continuity);

  /// Plans a frame on the way to these levels, within a budget, and takes it as carried out. Bricks
  /// keep their places as far as they can. Where there is room in narrow gaps only, a frame moves
  /// bricks closer together, no more texels than it may upload, and changes nothing else.
  FramePlan PlanStep(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
    const std::vector<std::uint16_t>& order, const AtlasShape& shape, Continuity continuity,
    const RefinementBudget& budget);

  const AtlasAllocator& GetAtlas() const { return this->Atlas; }
  const std::vector<std::int8_t>& GetLevels() const { return this->Levels; }
  const std::vector<BrickPlace>& GetPlaces() const { return this->Places; }

private:
  void StartAnew(std::size_t blocks, int depth, const AtlasShape& shape, FramePlan& plan);
  void TakeCanonicalPlaces(const std::vector<std::int8_t>& levels, FramePlan& plan);
  bool TakePlaces(
    const std::vector<std::int8_t>& levels, std::int64_t mostTexelsToMove, FramePlan& plan);
  void Compact(std::int64_t mostTexels, FramePlan& plan);
  void PlanUploads(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
    Continuity continuity, FramePlan& plan);

  AtlasAllocator Atlas;
  std::vector<std::int8_t> Levels;
  std::vector<BrickPlace> Places;
  std::vector<std::int64_t> Dropped; ///< bricks that are to be uploaded though their level stays
  Continuity Borders = Continuity::Off;
  bool IsCanonical = false; ///< places are those of a still
};
} // namespace flatblock
