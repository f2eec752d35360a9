#include "BlockGrid.h"

#include <gtest/gtest.h>

using flatblock::BlockGrid;
using flatblock::Index3;

TEST(BlockGrid, CountsBlocksThatShareBorders)
{
  const struct
  {
    int Samples, SamplesPerBlock, Blocks;
  } cases[] = { { 33, 33, 1 }, { 34, 33, 2 }, { 65, 33, 2 }, { 66, 33, 3 }, { 2, 17, 1 },
    { 1, 17, 1 }, { 17, 17, 1 }, { 18, 17, 2 }, { 301, 33, 10 }, { 370, 33, 12 }, { 129, 65, 2 } };
  for (const auto& c : cases)
  {
    const BlockGrid grid({ c.Samples, c.Samples, 5 }, c.SamplesPerBlock);
    EXPECT_EQ(grid.GetBlocks()[0], c.Blocks) << c.Samples << " by " << c.SamplesPerBlock;
    EXPECT_EQ(grid.GetBlocks()[1], c.Blocks);
    EXPECT_EQ(grid.GetBlocks()[2], 1);
  }
}

TEST(BlockGrid, NumbersBlocksXFastest)
{
  const BlockGrid grid({ 50, 100, 170 }, 17);
  const Index3 blocks = grid.GetBlocks();
  ASSERT_EQ(blocks, (Index3{ 4, 7, 11 }));
  ASSERT_EQ(grid.GetNumberOfBlocks(), 4 * 7 * 11);
  std::int64_t next = 0;
  for (int z = 0; z < blocks[2]; ++z)
  {
    for (int y = 0; y < blocks[1]; ++y)
    {
      for (int x = 0; x < blocks[0]; ++x, ++next)
      {
        EXPECT_EQ(grid.GetBlock({ x, y, z }), next);
        EXPECT_EQ(grid.GetPosition(next), (Index3{ x, y, z }));
        EXPECT_EQ(grid.GetFirstSample(next), (Index3{ 16 * x, 16 * y, 16 * z }));
      }
    }
  }
}

TEST(BlockGrid, EveryCellLiesInOneBlock)
{
  for (int samples : { 2, 3, 16, 17, 18, 33, 97, 100 })
  {
    const BlockGrid grid({ samples, 2, 2 }, 17);
    const int cells = grid.GetBlocks()[0] * grid.GetCellsPerBlock();
    EXPECT_GE(cells, samples - 1);
    EXPECT_LT(cells - grid.GetCellsPerBlock(), samples - 1);
  }
}

TEST(BlockGrid, CountsMoreBlocksThanAnIntHolds)
{
  const BlockGrid grid({ 1 << 15, 1 << 15, 1 << 15 }, 17);
  EXPECT_EQ(grid.GetNumberOfBlocks(), std::int64_t(1) << 33);
  const std::int64_t last = grid.GetNumberOfBlocks() - 1;
  EXPECT_EQ(grid.GetBlock(grid.GetPosition(last)), last);
}
