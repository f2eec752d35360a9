#include "CudaDevice.h"
#include "CudaDistortion.h"

#include "BlockGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

using flatblock::BlockedVolume;
using flatblock::BlockGrid;
using flatblock::ClassifiedTable;
using flatblock::Index3;

namespace
{
ClassifiedTable MakeTable(double lowest, double highest, int entries, std::mt19937& random)
{
  std::uniform_real_distribution<double> anything(0.0, 1.0);
  std::vector<flatblock::ClassifiedColor> colors;
  for (int i = 0; i < entries; ++i)
  {
    colors.push_back(flatblock::ToClassifiedColor(
      anything(random), anything(random), anything(random), anything(random)));
  }
  return { lowest, highest, colors };
}

template <typename T>
class CudaDistortionOf : public testing::Test
{
};
using AllTypes = testing::Types<char, signed char, unsigned char, short, unsigned short, int,
  unsigned int, long, unsigned long, long long, unsigned long long, float, double>;
TYPED_TEST_SUITE(CudaDistortionOf, AllTypes);
} // namespace

// On all block sizes, with partial blocks, resident and in slabs.
TYPED_TEST(CudaDistortionOf, EqualsTheThreads)
{
  const flatblock::CudaDevice device = flatblock::FindCudaDevice();
  if (!device.Answers)
  {
    GTEST_SKIP() << "No CUDA device answers: " << device.Name;
  }
  using T = TypeParam;
  std::mt19937 random(4);
  const bool isExact = std::is_integral_v<T> && sizeof(T) <= 2;
  const double lowest = std::is_integral_v<T> ? double(std::numeric_limits<T>::lowest()) : -1e30;
  const double highest = std::is_integral_v<T> ? double(std::numeric_limits<T>::max()) : 1e30;
  std::uniform_real_distribution<double> noise(0.1, 0.9);
  for (const auto& [size, n] :
    { std::make_pair(17, Index3{ 40, 35, 50 }), { 33, { 70, 33, 34 } }, { 65, { 67, 20, 66 } } })
  {
    std::vector<T> samples(std::size_t(n[0]) * n[1] * n[2]);
    std::generate(samples.begin(), samples.end(),
      [&]
      {
        const double share = noise(random);
        return static_cast<T>(lowest * (1.0 - share) + highest * share);
      });
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    const double span = double(*high) - double(*low);
    const auto table =
      MakeTable(double(*low), double(*high), isExact ? int(span) + 1 : 4096, random);
    const BlockGrid grid(n, size);
    const BlockedVolume volume = { n, grid.GetBlocks(), grid.GetCellsPerBlock() };
    std::vector<std::int64_t> blocks(grid.GetNumberOfBlocks());
    std::iota(blocks.begin(), blocks.end(), 0);
    const int levels = grid.GetNumberOfLevels() - 1;
    std::vector<float> wanted(blocks.size() * levels);
    flatblock::ComputeDistortion(samples.data(), volume, blocks, levels, table, 0, wanted.data());
    for (const std::size_t mostResident : { std::size_t(0), std::size_t(1) })
    {
      flatblock::CudaDistortion cuda;
      cuda.SetMostResidentBytes(mostResident);
      std::vector<float> distortion(wanted.size());
      ASSERT_EQ(cuda.Compute(samples.data(), volume, blocks, levels, table, distortion.data()), "");
      for (std::size_t i = 0; i < wanted.size(); ++i)
      {
        ASSERT_NEAR(distortion[i], wanted[i], 2e-6 * wanted[i]) << "blocks of " << size;
      }
    }
  }
}

TEST(CudaDistortion, SaysWhyItFails)
{
  if (flatblock::FindCudaDevice().Answers)
  {
    GTEST_SKIP() << "A CUDA device answers.";
  }
  const std::vector<float> samples(4913, 1.0F);
  std::vector<float> distortion(1);
  std::mt19937 random(1);
  flatblock::CudaDistortion cuda;
  EXPECT_NE(cuda.Compute(samples.data(), { { 17, 17, 17 }, { 1, 1, 1 }, 16 }, { 0 }, 1,
              MakeTable(0.0, 1.0, 2, random), distortion.data()),
    "");
}
