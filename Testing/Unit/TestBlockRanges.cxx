#include "BlockGrid.h"
#include "BlockRanges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

using flatblock::BlockGrid;
using flatblock::ValueRange;

namespace
{
template <typename T>
std::vector<T> RandomSamples(const flatblock::Index3& dims)
{
  std::mt19937_64 random(7);
  std::vector<T> samples(static_cast<std::size_t>(dims[0]) * dims[1] * dims[2]);
  for (T& sample : samples)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      sample = static_cast<T>(std::normal_distribution<double>(0.0, 1e6)(random));
    }
    else
    {
      sample = static_cast<T>(random());
    }
  }
  return samples;
}

template <typename T>
std::vector<ValueRange> Compute(const std::vector<T>& samples, const BlockGrid& grid)
{
  std::vector<ValueRange> ranges(grid.GetNumberOfBlocks());
  flatblock::ComputeBlockRanges(
    samples.data(), grid.GetSamples(), grid.GetCellsPerBlock(), grid.GetBlocks(), ranges.data());
  return ranges;
}

template <typename T>
ValueRange Reference(const std::vector<T>& samples, const BlockGrid& grid, std::int64_t block)
{
  const flatblock::Index3 n = grid.GetSamples();
  const flatblock::Index3 first = grid.GetFirstSample(block);
  ValueRange range;
  for (int z = first[2]; z < std::min(first[2] + grid.GetSamplesPerBlock(), n[2]); ++z)
  {
    for (int y = first[1]; y < std::min(first[1] + grid.GetSamplesPerBlock(), n[1]); ++y)
    {
      for (int x = first[0]; x < std::min(first[0] + grid.GetSamplesPerBlock(), n[0]); ++x)
      {
        const auto value = static_cast<double>(samples[(std::size_t(z) * n[1] + y) * n[0] + x]);
        range.Lowest = std::min(range.Lowest, value);
        range.Highest = std::max(range.Highest, value);
      }
    }
  }
  return range;
}
} // namespace

template <typename T>
class BlockRangesOf : public ::testing::Test
{
};
using ScalarTypes = ::testing::Types<char, signed char, unsigned char, short, unsigned short, int,
  unsigned int, long, unsigned long, long long, unsigned long long, float, double>;
TYPED_TEST_SUITE(BlockRangesOf, ScalarTypes);

TYPED_TEST(BlockRangesOf, EqualTheReferenceOnPartialBlocks)
{
  for (const flatblock::Index3& dims :
    { flatblock::Index3{ 40, 35, 19 }, { 17, 17, 17 }, { 18, 2, 33 }, { 3, 70, 2 } })
  {
    const auto samples = RandomSamples<TypeParam>(dims);
    const BlockGrid grid(dims, 17);
    const auto ranges = Compute(samples, grid);
    for (std::int64_t block = 0; block < grid.GetNumberOfBlocks(); ++block)
    {
      const ValueRange expected = Reference(samples, grid, block);
      EXPECT_EQ(ranges[block].Lowest, expected.Lowest) << "block " << block;
      EXPECT_EQ(ranges[block].Highest, expected.Highest) << "block " << block;
    }
  }
}

TEST(BlockRanges, BorderSamplesCountForBothNeighbours)
{
  const flatblock::Index3 dims = { 33, 17, 17 };
  std::vector<float> samples(33 * 17 * 17, 1.0F);
  samples[16] = 9.0F; // the shared sample of the two blocks' first row
  const auto ranges = Compute(samples, BlockGrid(dims, 17));
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_EQ(ranges[0].Highest, 9.0);
  EXPECT_EQ(ranges[1].Highest, 9.0);
}

TEST(BlockRanges, LeaveOutWhatIsNotFinite)
{
  const flatblock::Index3 dims = { 33, 17, 17 };
  std::vector<double> samples(33 * 17 * 17, std::nan(""));
  samples[0] = 2.0;
  samples[1] = INFINITY;
  samples[2] = -INFINITY;
  samples[3] = 5.0;
  const auto ranges = Compute(samples, BlockGrid(dims, 17));
  EXPECT_EQ(ranges[0].Lowest, 2.0);
  EXPECT_EQ(ranges[0].Highest, 5.0);
  EXPECT_TRUE(ranges[0].HasHoles);
  EXPECT_TRUE(ranges[1].IsEmpty());
  EXPECT_TRUE(ranges[1].HasHoles);
  samples.assign(samples.size(), 1.0);
  EXPECT_FALSE(Compute(samples, BlockGrid(dims, 17))[0].HasHoles);
}

#ifdef _OPENMP
TEST(BlockRanges, DoNotDependOnTheNumberOfThreads)
{
  const flatblock::Index3 dims = { 70, 61, 52 };
  const auto samples = RandomSamples<float>(dims);
  const BlockGrid grid(dims, 17);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto serial = Compute(samples, grid);
  omp_set_num_threads(5);
  const auto parallel = Compute(samples, grid);
  omp_set_num_threads(threads);
  for (std::size_t block = 0; block < serial.size(); ++block)
  {
    EXPECT_EQ(serial[block].Lowest, parallel[block].Lowest);
    EXPECT_EQ(serial[block].Highest, parallel[block].Highest);
  }
}
#endif
