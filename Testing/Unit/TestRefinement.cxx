#include "LodSelector.h"
#include "Refinement.h"

#include <gtest/gtest.h>

#include <random>

using flatblock::AtlasShape;
using flatblock::BlockGrid;
using flatblock::BlockRank;
using flatblock::Continuity;
using flatblock::CountBricks;
using flatblock::NoLevel;
using flatblock::RefinementBudget;
using flatblock::RefinementOrder;
using flatblock::Refiner;

namespace
{
using Levels = std::vector<std::int8_t>;
const BlockGrid Grid({ 161, 161, 161 }, 17); // 10^3 blocks

AtlasShape MakeShape(std::int64_t texels)
{
  return AtlasShape({ { 17, 9, 5, 3, 2 }, texels, 1000, 2048 });
}

Refiner MakeRefiner(const AtlasShape& shape)
{
  return { Grid, shape, shape.GetDepth(), Continuity::Nested };
}

bool Fits(const AtlasShape& shape, const Levels& levels)
{
  return shape.GetDepthOf(CountBricks(levels, shape)) <= shape.GetDepth();
}

RefinementOrder MakeOrder(double x)
{
  RefinementOrder order;
  order.SetToDistance(
    Grid, std::vector<BlockRank>(1000, BlockRank::InView), { x, 80.0, 80.0 }, { 1.0, 1.0, 1.0 });
  return order;
}

int CountChanges(const Levels& before, const Levels& after)
{
  int changes = 0;
  for (std::size_t block = 0; block < before.size(); ++block)
  {
    changes += before[block] != after[block] ? 1 : 0;
  }
  return changes;
}

// Texels of the bricks that are new, and of the borders that differ.
std::int64_t CountTexels(const Levels& before, const Levels& after)
{
  std::int64_t texels = 0;
  for (std::int64_t block = 0; block < 1000; ++block)
  {
    if (after[block] != NoLevel)
    {
      const int side = Grid.GetBrickSide(after[block]);
      const auto borderOf = [block](const Levels& levels)
      { return flatblock::GetBlockBorder(Grid, levels, block, Continuity::Nested); };
      texels +=
        flatblock::CountTexels(before[block] != after[block]
                                 ? flatblock::WholeBrick
                                 : flatblock::GetChangedParts(borderOf(before), borderOf(after)),
          side);
    }
  }
  return texels;
}
} // namespace

TEST(Refinement, ReachesTheTargetWithinBudgetAndShape)
{
  for (std::int64_t texels : { 150'000, 600'000, 2'000'000, 20'000'000 })
  {
    const AtlasShape shape = MakeShape(texels);
    const RefinementBudget budget{ 50, 40'000 };
    Levels levels(1000, NoLevel);
    for (double x : { -50.0, 200.0, 80.0 })
    {
      const RefinementOrder order = MakeOrder(x);
      flatblock::LodSelector selector;
      ASSERT_TRUE(selector.Select(order, shape, 4));
      const Levels target = selector.GetLevels();
      const bool isThere = levels == target;
      const bool isNew = levels[0] == NoLevel;
      int steps = 0;
      int large = 0;
      while (levels != target)
      {
        ASSERT_LT(steps++, 2000);
        const Levels next =
          MakeRefiner(shape).StepTowards(target, levels, order.GetBlocks(), budget);
        ASSERT_TRUE(Fits(shape, next));
        const int changes = CountChanges(levels, next);
        ASSERT_GT(changes, 0);
        const bool isLarge = changes > budget.Blocks || CountTexels(levels, next) > budget.Texels;
        large += isLarge && levels[0] != NoLevel ? 1 : 0;
        levels = next;
      }
      EXPECT_TRUE(isThere || steps > 2);
      EXPECT_LE(large, 1) << texels << " " << x; // where only all changes together fit
      EXPECT_TRUE(!isNew || steps > 2);
    }
  }
}

TEST(Refinement, NewBlocksComeAtOnceAndHiddenOnesGo)
{
  const AtlasShape shape = MakeShape(20'000'000);
  Levels current(1000, 0);
  current[3] = NoLevel;
  Levels target(1000, 0);
  target[7] = NoLevel;
  const Levels next =
    MakeRefiner(shape).StepTowards(target, current, MakeOrder(0.0).GetBlocks(), { 0, 0 });
  EXPECT_EQ(next[7], NoLevel);
  EXPECT_NE(next[3], NoLevel);
}

TEST(Refinement, NewBlocksKeepTheBudgetWhereTheyCan)
{
  const AtlasShape shape = MakeShape(20'000'000);
  const auto order = MakeOrder(0.0);
  for (const auto& [texels, level] : { std::make_pair(30'000, 3), { 10'000, 4 }, { 1, 4 } })
  {
    const Levels next = MakeRefiner(shape).StepTowards(
      Levels(1000, 0), Levels(1000, NoLevel), order.GetBlocks(), { 0, texels });
    EXPECT_EQ(next, Levels(1000, static_cast<std::int8_t>(level))) << texels;
  }
}

TEST(Refinement, WhatMattersMostComesFirst)
{
  const AtlasShape shape = MakeShape(20'000'000);
  const auto order = MakeOrder(-100.0);
  const Levels next = MakeRefiner(shape).StepTowards(
    Levels(1000, 0), Levels(1000, 2), order.GetBlocks(), { 10, 1'000'000 });
  for (std::int64_t block = 0; block < 1000; ++block)
  {
    EXPECT_TRUE(next[block] == 2 || Grid.GetPosition(block)[0] == 0) << block;
  }
  EXPECT_EQ(CountChanges(Levels(1000, 2), next), 10);
}

// Whatever there is and whatever is wanted: each step fits, and the last one arrives.
TEST(Refinement, EveryStepFits)
{
  std::mt19937 random(19);
  const AtlasShape shape = MakeShape(250'000);
  const auto order = MakeOrder(0.0);
  const auto anything = [&]
  {
    Levels levels(1000, 4);
    for (int change = 0; change < 3000; ++change)
    {
      std::int8_t& level = levels[random() % 1000];
      const std::int8_t before = level;
      level = static_cast<std::int8_t>(int(random() % 6) - 1);
      level = Fits(shape, levels) ? level : before;
    }
    return levels;
  };
  Levels levels = anything();
  for (int trial = 0; trial < 200; ++trial)
  {
    const Levels target = anything();
    for (int step = 0; step < 5 || trial % 20 == 0; ++step)
    {
      ASSERT_LT(step, 3000);
      levels = MakeRefiner(shape).StepTowards(
        target, levels, order.GetBlocks(), { int(random() % 40), int(random() % 20'000) });
      ASSERT_TRUE(Fits(shape, levels)) << trial << " " << step;
      if (levels == target)
      {
        break;
      }
    }
  }
}
