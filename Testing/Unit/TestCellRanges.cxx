#include "CellRanges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

using flatblock::CellRange;
using flatblock::CellScale;

namespace
{
const std::array<int, 3> Dims = { 14, 9, 6 };
const std::array<int, 3> Count = { 4, 2, 2 };
constexpr int Cells = 4;

template <typename T>
std::vector<CellRange> Compute(
  const std::vector<T>& samples, const CellScale& scale, int around = 0)
{
  std::vector<CellRange> ranges(Count[0] * Count[1] * Count[2]);
  flatblock::ComputeCellRanges(samples.data(), Dims, Cells, around, Count, scale, ranges.data());
  return ranges;
}

// All samples of a cube, both of its borders among them, and so many around it.
template <typename T, typename Action>
void ForSamples(const std::vector<T>& samples, int cube, const Action& action, int around = 0)
{
  const std::array<int, 3> first = { cube % Count[0] * Cells, cube / Count[0] % Count[1] * Cells,
    cube / (Count[0] * Count[1]) * Cells };
  for (int z = std::max(first[2] - around, 0);
       z <= std::min(first[2] + Cells + around, Dims[2] - 1); ++z)
  {
    for (int y = std::max(first[1] - around, 0);
         y <= std::min(first[1] + Cells + around, Dims[1] - 1); ++y)
    {
      for (int x = std::max(first[0] - around, 0);
           x <= std::min(first[0] + Cells + around, Dims[0] - 1); ++x)
      {
        action(samples[(std::size_t(z) * Dims[1] + y) * Dims[0] + x]);
      }
    }
  }
}
} // namespace

TEST(CellRanges, AreExactForIntegers)
{
  std::mt19937 random(5);
  std::vector<std::int16_t> samples(Dims[0] * Dims[1] * Dims[2]);
  for (std::int16_t& sample : samples)
  {
    sample = static_cast<std::int16_t>(int(random() % 65536U) - 32768);
  }
  const CellScale scale = { -32768.0, 1.0 };
  for (int around = 0; around < 3; ++around)
  {
    const std::vector<CellRange> ranges = Compute(samples, scale, around);
    for (int cube = 0; cube < int(ranges.size()); ++cube)
    {
      int lowest = 40000;
      int highest = -40000;
      ForSamples(
        samples, cube,
        [&](int sample)
        {
          lowest = std::min(lowest, sample);
          highest = std::max(highest, sample);
        },
        around);
      EXPECT_EQ(scale.GetValue(ranges[cube].Lowest), lowest);
      EXPECT_EQ(scale.GetValue(ranges[cube].Highest), highest);
    }
  }
}

TEST(CellRanges, AreRoundedOutwards)
{
  std::mt19937 random(5);
  std::vector<float> samples(Dims[0] * Dims[1] * Dims[2]);
  for (float& sample : samples)
  {
    sample = std::uniform_real_distribution<float>(0.0F, 1.0F)(random);
  }
  const CellScale scale = { 0.0, 1.0 / 65535.0 };
  const std::vector<CellRange> ranges = Compute(samples, scale);
  for (int cube = 0; cube < int(ranges.size()); ++cube)
  {
    double lowest = 2.0;
    double highest = -1.0;
    ForSamples(samples, cube,
      [&](double sample)
      {
        lowest = std::min(lowest, sample);
        highest = std::max(highest, sample);
      });
    EXPECT_LE(scale.GetValue(ranges[cube].Lowest), lowest);
    EXPECT_GT(scale.GetValue(ranges[cube].Lowest), lowest - 1.01 * scale.Step);
    EXPECT_GE(scale.GetValue(ranges[cube].Highest), highest);
    EXPECT_LT(scale.GetValue(ranges[cube].Highest), highest + 1.01 * scale.Step);
  }
}

TEST(CellRanges, TakeAllWhereASampleIsNotFinite)
{
  std::vector<double> samples(Dims[0] * Dims[1] * Dims[2], 0.5);
  const CellScale scale = { 0.0, 1.0 / 65535.0 };
  samples[0] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<CellRange> one = Compute(samples, scale);
  EXPECT_EQ(one[0].Lowest, 0);
  EXPECT_EQ(one[0].Highest, 65535);
  EXPECT_LE(one[1].Highest - one[1].Lowest, 1);
  std::fill(samples.begin(), samples.end(), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(Compute(samples, scale)[0].IsEmpty());
}
