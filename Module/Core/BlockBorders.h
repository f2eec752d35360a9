/// How coarse the border of a block has to be so that it meets its neighbours.
#pragma once

#include "BlockGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace flatblock
{
/// Levels by which a border is coarser than its block, for each direction (x, y, z), each -1, 0 or
/// 1, at x + 1 + 3 * (y + 1) + 9 * (z + 1). Corners and the middle are 0.
using BlockBorder = std::array<std::int8_t, 27>;

/// Faces take the coarser of the two levels that meet there, edges the coarsest of four. Blocks of
/// which nothing is drawn do not count.
///
/// @param levels  of every block of the grid
BlockBorder GetBlockBorder(
  const BlockGrid& grid, const std::vector<std::int8_t>& levels, std::int64_t block);
} // namespace flatblock
