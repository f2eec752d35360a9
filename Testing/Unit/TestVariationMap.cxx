// The variation map, against its definition.
#include "VariationMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace flatblock;

namespace
{
const CubeGrid Grid = { { 11, 8, 9 }, { 3, 2, 3 }, 4 };

std::size_t At(int x, int y, int z)
{
  return (static_cast<std::size_t>(z) * Grid.Cubes[1] + y) * Grid.Cubes[0] + x;
}

std::vector<CubeRange> MakeRanges(int variation)
{
  std::mt19937 random(1);
  std::vector<CubeRange> ranges(At(0, 0, Grid.Cubes[2]));
  for (auto& range : ranges)
  {
    range[0] = static_cast<std::uint16_t>(1000 + random() % variation);
    range[1] = static_cast<std::uint16_t>(range[0] + random() % variation);
  }
  return ranges;
}

// Of all cubes of the block within a distance.
CubeRange GetRangeAround(const std::vector<CubeRange>& ranges, const Index3& cube, int distance)
{
  CubeRange around = { 65535, 0 };
  Index3 first;
  Index3 last;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int block = cube[axis] - cube[axis] % Grid.CubesPerBlock;
    first[axis] = std::max(cube[axis] - distance, block);
    last[axis] =
      std::min({ cube[axis] + distance, block + Grid.CubesPerBlock - 1, Grid.Cubes[axis] - 1 });
  }
  for (int z = first[2]; z <= last[2]; ++z)
  {
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        around[0] = std::min(around[0], ranges[At(x, y, z)][0]);
        around[1] = std::max(around[1], ranges[At(x, y, z)][1]);
      }
    }
  }
  return around;
}
} // namespace

TEST(VariationMap, ReachesAsFarAsValuesAreNear)
{
  for (const int tolerance : { 0, 20, 40, 60, 500 })
  {
    const std::vector<CubeRange> ranges = MakeRanges(30);
    const auto reach = MeasureVariation(Grid, ranges, tolerance);
    for (int z = 0; z < Grid.Cubes[2]; ++z)
    {
      for (int y = 0; y < Grid.Cubes[1]; ++y)
      {
        for (int x = 0; x < Grid.Cubes[0]; ++x)
        {
          int expected = 0;
          for (int radius = 1; radius <= Grid.CubesPerBlock; ++radius)
          {
            const CubeRange around = GetRangeAround(ranges, { x, y, z }, radius - 1);
            expected += around[1] - around[0] <= tolerance ? 1 : 0;
          }
          EXPECT_EQ(int{ reach[At(x, y, z)] }, expected) << tolerance;
        }
      }
    }
  }
}

TEST(VariationMap, CubesWithoutValuesAreNotNear)
{
  std::vector<CubeRange> ranges = MakeRanges(2);
  ranges[At(5, 5, 5)] = { 65535, 0 };
  const auto reach = MeasureVariation(Grid, ranges, 10);
  EXPECT_EQ(int{ reach[At(5, 5, 5)] }, 0);
  EXPECT_GT(int{ reach[At(1, 1, 1)] }, 0);
}

TEST(VariationMap, CoarseCellsHoldWhatTheySpan)
{
  std::vector<CubeRange> ranges = MakeRanges(2);
  ranges[At(5, 5, 5)] = { 0, 2000 };
  std::vector<CubeRange> filtered = ranges;
  CoarsenRanges(Grid.Cubes, { 2, false }, ranges);
  CoarsenRanges(Grid.Cubes, { 2, true }, filtered);
  const CubeRange wide = { 0, 2000 };
  EXPECT_EQ(ranges[At(4, 4, 4)], wide);
  EXPECT_NE(ranges[At(6, 5, 5)], wide);
  EXPECT_NE(ranges[At(3, 5, 5)], wide);
  EXPECT_EQ(filtered[At(7, 5, 5)], wide);
  EXPECT_EQ(filtered[At(2, 2, 2)], wide);
  EXPECT_NE(filtered[At(1, 5, 5)], wide);
}
