#include "LodSelector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using flatblock::AtlasShape;
using flatblock::BlockGrid;
using flatblock::LodCriteria;
using flatblock::NoLevel;
using flatblock::SelectLevels;

namespace
{
const std::vector<int> Sides = { 17, 9, 5, 3, 2 };
const BlockGrid Grid({ 161, 161, 161 }, 17); // 10^3 blocks
const std::vector<std::uint8_t> AllVisible(1000, 1);

AtlasShape MakeShape(std::int64_t texels)
{
  return AtlasShape({ Sides, texels, 1000, 2048 });
}

std::int64_t GetDepth(const AtlasShape& shape, const std::vector<std::int8_t>& levels)
{
  std::vector<std::int64_t> bricks(5, 0);
  for (std::int8_t level : levels)
  {
    bricks[level < 0 ? 0 : level] += level < 0 ? 0 : 1;
  }
  return shape.GetDepthOf(bricks);
}
} // namespace

TEST(LodSelector, EverythingIsFinestWhereItFits)
{
  const auto levels = SelectLevels(Grid, MakeShape(10'000'000), AllVisible, LodCriteria());
  ASSERT_TRUE(levels);
  EXPECT_EQ(*levels, std::vector<std::int8_t>(1000, 0));
}

TEST(LodSelector, KeepsWithinTheShapeAndUsesIt)
{
  for (std::int64_t texels : { 100'000, 400'000, 1'000'000, 3'000'000 })
  {
    const AtlasShape shape = MakeShape(texels);
    const auto levels = SelectLevels(Grid, shape, AllVisible, LodCriteria());
    ASSERT_TRUE(levels) << texels;
    EXPECT_LE(GetDepth(shape, *levels), shape.GetDepth());
    EXPECT_GE(GetDepth(shape, *levels), shape.GetDepth() - 17) << "room for another slab";
  }
}

TEST(LodSelector, NearBlocksAreFiner)
{
  LodCriteria criteria;
  criteria.PointOfInterest = { -100.0, 80.0, 80.0 };
  const auto levels = SelectLevels(Grid, MakeShape(1'000'000), AllVisible, criteria);
  ASSERT_TRUE(levels);
  EXPECT_LT((*levels)[Grid.GetBlock({ 0, 5, 5 })], (*levels)[Grid.GetBlock({ 9, 5, 5 })]);
  for (int x = 1; x < 10; ++x)
  {
    EXPECT_LE((*levels)[Grid.GetBlock({ x - 1, 5, 5 })], (*levels)[Grid.GetBlock({ x, 5, 5 })]);
  }
}

TEST(LodSelector, WhatIsOutOfViewComesLast)
{
  LodCriteria criteria;
  criteria.ViewPlanes = { { 1.0, 0.0, 0.0, -85.0 } }; // x >= 85, in the sixth block
  const auto levels = SelectLevels(Grid, MakeShape(2'900'000), AllVisible, criteria);
  ASSERT_TRUE(levels);
  int finestOutOfView = 0;
  for (std::int64_t block = 0; block < 1000; ++block)
  {
    const bool isInView = Grid.GetPosition(block)[0] >= 5;
    EXPECT_TRUE(!isInView || (*levels)[block] == 0) << block;
    finestOutOfView += !isInView && (*levels)[block] == 0 ? 1 : 0;
  }
  EXPECT_LT(finestOutOfView, 120);
}

TEST(LodSelector, AddsCoarserLevelsWhereTheAskedForDontFit)
{
  LodCriteria criteria;
  criteria.NumberOfLevels = 1;
  const auto levels = SelectLevels(Grid, MakeShape(60'000), AllVisible, criteria);
  ASSERT_TRUE(levels);
  EXPECT_EQ(*std::max_element(levels->begin(), levels->end()), 3);
  EXPECT_FALSE(SelectLevels(Grid, MakeShape(4'000), AllVisible, criteria));
}

TEST(LodSelector, InvisibleBlocksCostNothing)
{
  std::vector<std::uint8_t> visible(1000, 0);
  visible[17] = 1;
  const auto levels = SelectLevels(Grid, MakeShape(5'000), visible, LodCriteria());
  ASSERT_TRUE(levels);
  for (std::size_t block = 0; block < 1000; ++block)
  {
    EXPECT_EQ((*levels)[block], block == 17 ? 0 : NoLevel);
  }
}
