/// Which bricks go to the GPU in a frame.
#pragma once

#include "AtlasAllocator.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace flatblock
{
struct BrickUpload
{
  std::int64_t Block = 0;
  int Place = 0;
};

/// What turns the atlas of the last frame into that of this one.
struct FramePlan
{
  bool NewAtlas = false;  ///< the texture is allocated anew, with nothing in it
  bool NewPlaces = false; ///< the index texture has to be written
  std::vector<BrickUpload> Uploads;
};

/// What lies where in the atlas, as the GPU has it once a plan was carried out.
class Residency
{
public:
  static constexpr int NotResident = -1;

  /// Forgets everything: the GPU holds nothing.
  void Clear();

  /// Plans the frame in which exactly the blocks with wanted[block] != 0 are resident, and takes it
  /// as carried out. Bricks that stay are not touched. Places that fell free are kept for later;
  /// the atlas is made anew only where it is too small or more than twice too large.
  ///
  /// @return nothing where the bricks don't fit a texture of `largestTexture` texels a side; then
  /// nothing has changed
  std::optional<FramePlan> Plan(
    const std::vector<std::uint8_t>& wanted, int brickSide, int largestTexture);

  const AtlasAllocator& GetAtlas() const { return this->Atlas; }

  /// Place of each block, or NotResident.
  const std::vector<int>& GetPlaces() const { return this->Places; }

private:
  AtlasAllocator Atlas;
  std::vector<int> Places;
};
} // namespace flatblock
