#include "BlockBorders.h"

#include <algorithm>
#include <cstdlib>

namespace flatblock
{
namespace
{
int ToIndex(int x, int y, int z)
{
  return x + 1 + 3 * (y + 1) + 9 * (z + 1);
}

// Levels of the block and its neighbours; the block's own where there is no neighbour, or a finer
// one.
BlockBorder GetCoarserNeighbours(
  const BlockGrid& grid, const std::vector<std::int8_t>& levels, std::int64_t block)
{
  const Index3 position = grid.GetPosition(block);
  const Index3& blocks = grid.GetBlocks();
  BlockBorder around;
  for (int z = -1; z <= 1; ++z)
  {
    for (int y = -1; y <= 1; ++y)
    {
      for (int x = -1; x <= 1; ++x)
      {
        const Index3 p = { position[0] + x, position[1] + y, position[2] + z };
        const bool isInside = p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < blocks[0] &&
                              p[1] < blocks[1] && p[2] < blocks[2];
        const std::int8_t level = isInside ? levels[grid.GetBlock(p)] : levels[block];
        around[ToIndex(x, y, z)] = std::max(level, levels[block]);
      }
    }
  }
  return around;
}
} // namespace

BlockBorder GetBlockBorder(
  const BlockGrid& grid, const std::vector<std::int8_t>& levels, std::int64_t block)
{
  const BlockBorder around = GetCoarserNeighbours(grid, levels, block);
  BlockBorder border = {};
  for (int z = -1; z <= 1; ++z)
  {
    for (int y = -1; y <= 1; ++y)
    {
      for (int x = -1; x <= 1; ++x)
      {
        const int directions = std::abs(x) + std::abs(y) + std::abs(z);
        if (directions == 1 || directions == 2)
        {
          const std::int8_t coarsest = std::max({ around[ToIndex(x, y, z)],
            around[ToIndex(x, 0, 0)], around[ToIndex(0, y, 0)], around[ToIndex(0, 0, z)] });
          border[ToIndex(x, y, z)] = static_cast<std::int8_t>(coarsest - levels[block]);
        }
      }
    }
  }
  return border;
}
} // namespace flatblock
