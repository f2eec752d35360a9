/// How coarse the border of a block has to be so that it meets its neighbours.
#pragma once

#include "BlockGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace flatblock
{
/// Levels by which a border is coarser than its block, for each direction (x, y, z), each -1, 0 or
/// 1, at x + 1 + 3 * (y + 1) + 9 * (z + 1): faces have one direction that is not 0, edges two,
/// corners three. The middle is 0.
using BlockBorder = std::array<std::int8_t, 27>;

/// How blocks meet neighbours of other levels.
enum class Continuity : std::uint8_t
{
  Off,
  Nested,  ///< faces and edges follow coarser neighbours; corners are the same at every level
  Filtered ///< corners too, since each level has values of its own
};

/// Faces take the coarser of the two levels that meet there, edges the coarsest of four, corners of
/// eight. Blocks of which nothing is drawn do not count.
///
/// @param levels  of every block of the grid
BlockBorder GetBlockBorder(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
  std::int64_t block, Continuity continuity);

/// For every block whether its border may differ: those whose level does, and all around them.
std::vector<std::uint8_t> FindTouched(const BlockGrid& grid, const std::vector<std::int8_t>& before,
  const std::vector<std::int8_t>& after);

/// Directions of a BlockBorder, one bit each; the middle stands for the whole brick.
using BrickParts = std::uint32_t;
constexpr BrickParts WholeBrick = 1U << 13;

/// What two bricks that differ in their border alone don't have in common. An edge is left out
/// where a face brings it along, a corner where a face or an edge does.
BrickParts GetChangedParts(const BlockBorder& before, const BlockBorder& after);

/// Texels of a brick.
struct BrickBox
{
  Index3 First = { 0, 0, 0 };
  Index3 Size = { 0, 0, 0 };
};

/// The boxes of these parts of a brick; together they hold each texel of a part. The apron belongs
/// to the whole brick alone.
///
/// @param side  samples, without the apron
std::vector<BrickBox> GetBoxes(BrickParts parts, int side, int apron = 0);

std::int64_t CountTexels(BrickParts parts, int side);
} // namespace flatblock
