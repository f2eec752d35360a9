#include "BlockVisibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

using flatblock::BlockGrid;
using flatblock::ComputeTransmittance;
using flatblock::Index3;
using flatblock::Viewpoint;

namespace
{
using Point = std::array<double, 3>;

// Optical depth from one point to another, by small steps.
double GetOpticalDepth(const BlockGrid& grid, const std::vector<float>& extinction,
  const Point& spacing, const Point& from, const Point& to)
{
  constexpr int Steps = 4000;
  const double length = std::hypot(
    (to[0] - from[0]) * spacing[0], (to[1] - from[1]) * spacing[1], (to[2] - from[2]) * spacing[2]);
  double depth = 0.0;
  for (int step = 0; step < Steps; ++step)
  {
    Index3 block;
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double at = from[axis] + (step + 0.5) / Steps * (to[axis] - from[axis]);
      isInside = isInside && at >= 0.0 && at <= grid.GetSamples()[axis] - 1.0;
      const int last = grid.GetBlocks()[axis] - 1;
      block[axis] = std::min(static_cast<int>(std::floor(at / grid.GetCellsPerBlock())), last);
    }
    depth += isInside ? extinction[grid.GetBlock(block)] * length / Steps : 0.0;
  }
  return depth;
}
} // namespace

TEST(BlockVisibility, WhatIsSeenIsNeverTakenForHidden)
{
  std::mt19937 random(23);
  // The last layers of two axes are partial.
  const BlockGrid grid({ 146, 129, 170 }, 17);
  const std::int64_t blocks = grid.GetNumberOfBlocks();
  const Point spacing = { 1.0, 0.7, 1.6 };
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  int hidden = 0;
  for (int trial = 0; trial < 60; ++trial)
  {
    std::vector<float> extinction(blocks);
    std::generate(extinction.begin(), extinction.end(),
      [&]
      { return random() % 100 == 0 ? 0.0F : static_cast<float>(0.05 + 0.2 * anywhere(random)); });
    Viewpoint view;
    view.IsParallel = trial % 3 == 0;
    const double reach = trial % 2 == 0 ? 400.0 : 150.0; // outside, or perhaps inside
    for (int axis = 0; axis < 3; ++axis)
    {
      view.Eye[axis] = 75.0 + reach * (2.0 * anywhere(random) - 1.0);
      view.Sight[axis] = 2.0 * anywhere(random) - 1.0;
    }
    const auto transmittance = ComputeTransmittance(grid, extinction, spacing, view);
    hidden += int(std::count_if(
      transmittance.begin(), transmittance.end(), [](float t) { return t < 1.0F / 255.0F; }));
    for (int ray = 0; ray < 60; ++ray)
    {
      const std::int64_t block = std::int64_t(random() % blocks);
      const Index3 first = grid.GetFirstSample(block);
      Point to;
      Point from = view.Eye;
      for (int axis = 0; axis < 3; ++axis)
      {
        to[axis] = std::min(first[axis] + 16.0 * anywhere(random), grid.GetSamples()[axis] - 1.0);
        from[axis] = view.IsParallel ? to[axis] - 600.0 * view.Sight[axis] : from[axis];
      }
      const double depth = GetOpticalDepth(grid, extinction, spacing, from, to);
      ASSERT_GE(transmittance[block], std::exp(-depth) * 0.97 - 1e-6)
        << "trial " << trial << ", block " << block;
    }
  }
  std::cout << hidden << " of " << 60 * blocks << " blocks are hidden\n";
  EXPECT_GT(hidden, 1000);
}

TEST(BlockVisibility, TheInsideOfAnOpaqueBodyIsHidden)
{
  const BlockGrid grid({ 161, 161, 161 }, 17); // 10^3 blocks
  const std::vector<float> extinction(1000, 0.5F);
  Viewpoint view;
  view.Eye = { 80.0, 80.0, 800.0 };
  const auto transmittance = ComputeTransmittance(grid, extinction, { 1.0, 1.0, 1.0 }, view);
  EXPECT_EQ(transmittance[grid.GetBlock({ 5, 5, 9 })], 1.0F);
  EXPECT_LT(transmittance[grid.GetBlock({ 5, 5, 7 })], 0.01F);
  EXPECT_LT(transmittance[grid.GetBlock({ 5, 5, 2 })], 0.01F);
}

TEST(BlockVisibility, EyesInsideSeeWhatIsAroundThem)
{
  const BlockGrid grid({ 161, 161, 161 }, 17);
  const std::vector<float> extinction(1000, 0.5F);
  Viewpoint view;
  view.Eye = { 80.0, 81.0, 79.0 };
  const auto transmittance = ComputeTransmittance(grid, extinction, { 1.0, 1.0, 1.0 }, view);
  for (const Index3& block : { Index3{ 4, 5, 4 }, { 5, 5, 5 }, { 4, 5, 5 } })
  {
    EXPECT_EQ(transmittance[grid.GetBlock(block)], 1.0F);
  }
  EXPECT_LT(transmittance[grid.GetBlock({ 5, 5, 8 })], 0.01F);
}

TEST(BlockVisibility, WhatLiesBeforeTheNearPlaneHidesNothing)
{
  const BlockGrid grid({ 161, 161, 161 }, 17);
  const std::vector<float> extinction(1000, 0.5F);
  Viewpoint view;
  view.IsParallel = true;
  view.Sight = { 0.0, 0.0, -1.0 };
  view.NearPlane = { 0.0, 0.0, -1.0, 100.0 }; // at z = 100, in the seventh layer
  const auto transmittance = ComputeTransmittance(grid, extinction, { 1.0, 1.0, 1.0 }, view);
  EXPECT_EQ(transmittance[grid.GetBlock({ 5, 5, 6 })], 1.0F);
  EXPECT_EQ(transmittance[grid.GetBlock({ 5, 5, 5 })], 1.0F);
  EXPECT_LT(transmittance[grid.GetBlock({ 5, 5, 3 })], 0.01F);
}
