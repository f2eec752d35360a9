/// How bricks get from one layout of the atlas to another.
#pragma once

#include "AtlasAllocator.h"

#include <cstdint>
#include <vector>

namespace flatblock
{
struct Relocation
{
  std::vector<BoxMove> Moves; ///< to be carried out in this order

  /// Blocks whose bricks are in each other's way. They are to be uploaded again, after the moves.
  std::vector<std::int64_t> Dropped;
};

/// Brings each brick from its place in one layout to that in another one of the same texture. No
/// move overwrites a brick that has yet to move.
///
/// @param stays  for every block whether its brick is to be kept; all others may be overwritten
Relocation Relocate(const AtlasAllocator& from, const std::vector<BrickPlace>& fromPlaces,
  const AtlasAllocator& to, const std::vector<BrickPlace>& toPlaces,
  const std::vector<std::uint8_t>& stays);
} // namespace flatblock
