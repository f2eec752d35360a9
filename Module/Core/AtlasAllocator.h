/// Where bricks of one size lie in the atlas.
#pragma once

#include "BlockGrid.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace flatblock
{
/// Hands out places for bricks in a 3D texture. A place is a number, counted x fastest.
class AtlasAllocator
{
public:
  /// The bricks an axis of the smallest atlas that holds `bricks` bricks of `side` texels a side,
  /// none where the texture may not be larger than `largestTexture` texels a side.
  static std::optional<Index3> FindShape(std::int64_t bricks, int side, int largestTexture);

  /// An atlas without a place.
  AtlasAllocator() = default;

  /// @param shape  bricks an axis
  /// @param side   texels a brick's side
  AtlasAllocator(const Index3& shape, int side);

  std::int64_t GetCapacity() const;
  std::int64_t GetNumberOfFreePlaces() const;

  /// Texels an axis.
  Index3 GetTextureSize() const;

  /// A free place, the one freed last first; there must be one.
  int Allocate();
  void Free(int place);

  /// The first texel of the brick at this place.
  Index3 GetOrigin(int place) const;

private:
  Index3 Shape = { 0, 0, 0 };
  int Side = 0;
  std::vector<int> FreePlaces;
};
} // namespace flatblock
