#include "LodSelector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

using flatblock::AtlasShape;
using flatblock::BlockGrid;
using flatblock::BlockRank;
using flatblock::LodSelector;
using flatblock::NoLevel;
using flatblock::RefinementOrder;

namespace
{
using Levels = std::vector<std::int8_t>;
using Ranks = std::vector<BlockRank>;
const std::vector<int> Sides = { 17, 9, 5, 3, 2 };
const BlockGrid Grid({ 161, 161, 161 }, 17); // 10^3 blocks
const Ranks AllInView(1000, BlockRank::InView);

AtlasShape MakeShape(std::int64_t texels)
{
  return AtlasShape({ Sides, texels, 1000, 2048 });
}

RefinementOrder MakeOrder(const Ranks& ranks, const std::array<double, 3>& point = {},
  const BlockGrid& grid = Grid, const std::array<double, 3>& spacing = { 1.0, 1.0, 1.0 })
{
  RefinementOrder order;
  order.SetToDistance(grid, ranks, point, spacing);
  return order;
}

Levels Select(const AtlasShape& shape, const Ranks& ranks, const std::array<double, 3>& point = {},
  int numberOfLevels = 4)
{
  LodSelector selector;
  EXPECT_TRUE(selector.Select(MakeOrder(ranks, point), shape, numberOfLevels));
  return selector.GetLevels();
}

std::int64_t GetDepth(const AtlasShape& shape, const Levels& levels)
{
  std::vector<std::int64_t> bricks(shape.GetNumberOfLevels(), 0);
  for (std::int8_t level : levels)
  {
    bricks[level < 0 ? 0 : level] += level < 0 ? 0 : 1;
  }
  return shape.GetDepthOf(bricks);
}

// The rule of LodSelector, by looking at every block for each refinement.
Levels SelectSlowly(const RefinementOrder& order, const AtlasShape& shape, int coarsest)
{
  const std::size_t blocks = order.GetNumbers(0).size();
  const auto timeOf = [&order](std::size_t block, int level)
  {
    return order.GetTime(order.GetNumbers(order.GetSequence(level))[block]) + order.GetDelay(level);
  };
  Levels levels(blocks, NoLevel);
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const bool isVisible = order.GetNumbers(0)[block] != RefinementOrder::Never;
    levels[block] = isVisible ? static_cast<std::int8_t>(coarsest) : NoLevel;
  }
  std::vector<bool> waits(coarsest + 1, false);
  while (true)
  {
    std::size_t next = blocks;
    int nextLevel = 0;
    for (int level = 1; level <= coarsest; ++level)
    {
      std::size_t first = blocks; // that was not refined from this level
      for (std::size_t block = 0; block < blocks; ++block)
      {
        if (levels[block] >= level &&
            (first == blocks || timeOf(block, level) < timeOf(first, level)))
        {
          first = block;
        }
      }
      const bool isThere = first < blocks && levels[first] == level && !waits[level];
      if (isThere && (next == blocks || timeOf(first, level) < timeOf(next, nextLevel) ||
                       (timeOf(first, level) == timeOf(next, nextLevel) && first < next)))
      {
        next = first;
        nextLevel = level;
      }
    }
    if (next == blocks)
    {
      return levels;
    }
    --levels[next];
    if (GetDepth(shape, levels) <= shape.GetDepth())
    {
      waits.assign(coarsest + 1, false);
    }
    else
    {
      ++levels[next];
      waits[nextLevel] = true;
    }
  }
}

// What is left to wish for: the sum of the priorities of all blocks that are not finest.
double GetTotalError(const RefinementOrder& order, const Levels& levels)
{
  double error = 0.0;
  for (std::size_t block = 0; block < levels.size(); ++block)
  {
    if (levels[block] > 0)
    {
      error += 1.0 / (order.GetTime(order.GetBlocks()[block]) + order.GetDelay(levels[block]));
    }
  }
  return error;
}

// Over all levels of all blocks.
double GetLeastError(const RefinementOrder& order, const AtlasShape& shape, int coarsest)
{
  Levels levels(order.GetBlocks().size(), 0);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t block = 0; block < levels.size();)
  {
    if (GetDepth(shape, levels) <= shape.GetDepth())
    {
      least = std::min(least, GetTotalError(order, levels));
    }
    for (block = 0; block < levels.size() && ++levels[block] > coarsest; ++block)
    {
      levels[block] = 0;
    }
  }
  return least;
}
} // namespace

TEST(LodSelector, EverythingIsFinestWhereItFits)
{
  EXPECT_EQ(Select(MakeShape(10'000'000), AllInView), Levels(1000, 0));
}

TEST(LodSelector, KeepsWithinTheShapeAndUsesIt)
{
  for (std::int64_t texels : { 100'000, 400'000, 1'000'000, 3'000'000 })
  {
    const AtlasShape shape = MakeShape(texels);
    const Levels levels = Select(shape, AllInView);
    EXPECT_LE(GetDepth(shape, levels), shape.GetDepth());
    EXPECT_GE(GetDepth(shape, levels), shape.GetDepth() - 17) << "room for another slab";
  }
}

TEST(LodSelector, FollowsItsRule)
{
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial)
  {
    const auto number = [&random](int from, int to)
    { return std::uniform_int_distribution<int>(from, to)(random); };
    const BlockGrid grid({ number(2, 120), number(2, 120), number(2, 120) }, 17);
    const std::int64_t blocks = grid.GetNumberOfBlocks();
    Ranks ranks(blocks);
    std::generate(ranks.begin(), ranks.end(),
      [&] { return static_cast<BlockRank>(std::min(number(0, 5), 2)); });
    std::array<double, 3> point;
    std::generate(point.begin(), point.end(), [&] { return double(number(-100, 200)); });
    const std::array<double, 3> spacing = { 1.0, 0.5, double(number(1, 4)) };
    std::vector<float> errors(4 * blocks);
    std::generate(errors.begin(), errors.end(),
      [&]
      { return number(0, 9) == 0 ? 0.0F : static_cast<float>(std::exp2(0.1 * number(-50, 50))); });
    const flatblock::BlockDistortion distortion{ errors.data(), number(1, 4), trial % 2 == 0 };
    RefinementOrder order;
    switch (trial % 3)
    {
    case 0:
      order.SetToDistance(grid, ranks, point, spacing);
      break;
    case 1:
      order.SetToDistortion(grid, ranks, distortion);
      break;
    default:
      order.SetToDistortionAndDistance(grid, ranks, distortion, point, spacing);
    }
    const AtlasShape shape({ Sides, blocks * number(20, 5000), blocks, 2048 });
    LodSelector selector;
    if (!selector.Select(order, shape, number(1, 5)))
    {
      continue;
    }
    const Levels& levels = selector.GetLevels();
    const int coarsest = *std::max_element(levels.begin(), levels.end());
    // The coarsest level at which it may have begun.
    bool isFound = false;
    for (int level = std::max(coarsest, 0); level < 5 && !isFound; ++level)
    {
      isFound = SelectSlowly(order, shape, level) == levels;
    }
    ASSERT_TRUE(isFound) << "trial " << trial;
  }
}

TEST(LodSelector, NearBlocksAreFiner)
{
  const Levels levels = Select(MakeShape(1'000'000), AllInView, { -100.0, 80.0, 80.0 });
  EXPECT_LT(levels[Grid.GetBlock({ 0, 5, 5 })], levels[Grid.GetBlock({ 9, 5, 5 })]);
  for (int x = 1; x < 10; ++x)
  {
    EXPECT_LE(levels[Grid.GetBlock({ x - 1, 5, 5 })], levels[Grid.GetBlock({ x, 5, 5 })]);
  }
}

TEST(LodSelector, WrongBlocksAreFiner)
{
  // Errors that double from block to block, and are half as large at each finer level.
  std::vector<float> errors;
  for (int block = 0; block < 1000; ++block)
  {
    for (int level = 1; level <= 3; ++level)
    {
      errors.push_back(static_cast<float>(std::exp2(0.01 * block + level)));
    }
  }
  RefinementOrder order;
  order.SetToDistortion(Grid, AllInView, { errors.data(), 3, false });
  LodSelector selector;
  ASSERT_TRUE(selector.Select(order, MakeShape(1'000'000), 4));
  const Levels& levels = selector.GetLevels();
  EXPECT_TRUE(std::is_sorted(levels.rbegin(), levels.rend()));
  EXPECT_EQ(levels[999], 0);
  EXPECT_EQ(levels[0], 3);
}

TEST(LodSelector, WhatIsOutOfViewComesLast)
{
  Ranks ranks(1000);
  for (std::int64_t block = 0; block < 1000; ++block)
  {
    ranks[block] = Grid.GetPosition(block)[0] >= 5 ? BlockRank::InView : BlockRank::OutOfView;
  }
  const Levels levels = Select(MakeShape(2'900'000), ranks);
  int finestOutOfView = 0;
  for (std::int64_t block = 0; block < 1000; ++block)
  {
    const bool isInView = ranks[block] == BlockRank::InView;
    EXPECT_TRUE(!isInView || levels[block] == 0) << block;
    finestOutOfView += !isInView && levels[block] == 0 ? 1 : 0;
  }
  EXPECT_LT(finestOutOfView, 120);
}

TEST(LodSelector, AddsCoarserLevelsWhereTheAskedForDontFit)
{
  const Levels levels = Select(MakeShape(60'000), AllInView, {}, 1);
  EXPECT_EQ(*std::max_element(levels.begin(), levels.end()), 3);
  LodSelector selector;
  EXPECT_FALSE(selector.Select(MakeOrder(AllInView), MakeShape(4'000), 1));
}

TEST(LodSelector, InvisibleBlocksCostNothing)
{
  Ranks ranks(1000, BlockRank::Transparent);
  ranks[17] = BlockRank::InView;
  const Levels levels = Select(MakeShape(5'000), ranks);
  for (std::size_t block = 0; block < 1000; ++block)
  {
    EXPECT_EQ(levels[block], block == 17 ? 0 : NoLevel);
  }
}

// Eight blocks, four levels: all 65536 choices against the greedy one.
TEST(LodSelector, GreedyIsNearTheOptimum)
{
  std::mt19937 random(13);
  const BlockGrid grid({ 33, 33, 33 }, 17);
  double worst = 1.0;
  double sum = 0.0;
  int instances = 0;
  for (int trial = 0; trial < 60; ++trial)
  {
    std::uniform_real_distribution<double> anywhere(-60.0, 90.0);
    const std::array<double, 3> point = { anywhere(random), anywhere(random), anywhere(random) };
    const RefinementOrder order = MakeOrder(Ranks(8, BlockRank::InView), point, grid);
    const AtlasShape shape({ Sides, 2000 + int(random() % 30000), 8, 2048 });
    LodSelector selector;
    if (!selector.Select(order, shape, 4))
    {
      continue;
    }
    const double greedy = GetTotalError(order, selector.GetLevels());
    const double least = GetLeastError(order, shape, 3);
    ASSERT_GE(greedy, least);
    if (least > 0.0)
    {
      worst = std::max(worst, greedy / least);
      sum += greedy / least;
      ++instances;
    }
  }
  ASSERT_GT(instances, 30);
  std::cout << "greedy error against the optimum: " << sum / instances << " on average, " << worst
            << " at worst of " << instances << "\n";
  EXPECT_LE(worst, 1.5);
}
