#include "Distortion.h"

#include "BlockGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>

using flatblock::BlockedVolume;
using flatblock::BlockGrid;
using flatblock::ClassifiedColor;
using flatblock::ClassifiedTable;
using flatblock::Index3;

namespace
{
ClassifiedTable MakeTable(double lowest, double highest, int entries, std::mt19937& random)
{
  std::uniform_real_distribution<double> anything(0.0, 1.0);
  std::vector<ClassifiedColor> colors;
  double opacity = 0.0;
  for (int i = 0; i < entries; ++i)
  {
    opacity = i % 50 == 0 ? anything(random) : opacity; // steps, and slow changes between
    colors.push_back(
      flatblock::ToClassifiedColor(0.5 + 0.5 * std::sin(0.01 * i), 0.3, anything(random), opacity));
  }
  return { lowest, highest, colors };
}

// As the definition says, in double precision, sample by sample.
template <typename T>
class Reference
{
public:
  Reference(const std::vector<T>& samples, const BlockGrid& grid, const ClassifiedTable& table)
    : Samples(samples), Grid(grid), Table(table)
  {
  }

  double Compute(std::int64_t block, int level) const
  {
    const Index3 first = this->Grid.GetFirstSample(block);
    Index3 end;
    for (int axis = 0; axis < 3; ++axis)
    {
      end[axis] =
        std::min(first[axis] + this->Grid.GetSamplesPerBlock(), this->Grid.GetSamples()[axis]);
    }
    double sum = 0.0;
    std::int64_t count = 0;
    for (int z = first[2]; z < end[2]; ++z)
    {
      for (int y = first[1]; y < end[1]; ++y)
      {
        for (int x = first[0]; x < end[0]; ++x)
        {
          const double value = static_cast<double>(this->Get(x, y, z));
          if (!std::isfinite(value))
          {
            continue;
          }
          ++count;
          const auto fine = this->GetColor(this->Table.GetPosition(value));
          const auto coarse = this->GetColor(this->Interpolate(first, { x, y, z }, level));
          for (int c = 0; c < 4; ++c)
          {
            sum += (fine[c] - coarse[c]) * (fine[c] - coarse[c]);
          }
        }
      }
    }
    return count > 0 ? std::sqrt(sum / double(count)) : 0.0;
  }

private:
  T Get(int x, int y, int z) const
  {
    const Index3& n = this->Grid.GetSamples();
    return this
      ->Samples[(std::size_t(std::min(z, n[2] - 1)) * n[1] + std::min(y, n[1] - 1)) * n[0] +
                std::min(x, n[0] - 1)];
  }

  // In entries of the table.
  double Interpolate(const Index3& first, const Index3& at, int level) const
  {
    const int stride = 1 << level;
    double position = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      Index3 p;
      double weight = 1.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int local = at[axis] - first[axis];
        const int cell = std::min(local >> level, (this->Grid.GetCellsPerBlock() >> level) - 1);
        const double share = double(local - (cell << level)) / stride;
        const int up = corner >> axis & 1;
        p[axis] = first[axis] + (cell + up) * stride;
        weight *= up ? share : 1.0 - share;
      }
      position += weight * this->Table.GetPosition(double(this->Get(p[0], p[1], p[2])));
    }
    return position;
  }

  std::array<double, 4> GetColor(double position) const
  {
    const auto& colors = this->Table.GetColors();
    const auto first = std::min(std::size_t(position), colors.size() - 1);
    const auto next = std::min(first + 1, colors.size() - 1);
    std::array<double, 4> color;
    for (int c = 0; c < 4; ++c)
    {
      const double a = colors[first][c];
      color[c] = a + (position - double(first)) * (double(colors[next][c]) - a);
    }
    return color;
  }

  const std::vector<T>& Samples;
  const BlockGrid& Grid;
  const ClassifiedTable& Table;
};

std::vector<std::int64_t> AllBlocks(const BlockGrid& grid)
{
  std::vector<std::int64_t> blocks(grid.GetNumberOfBlocks());
  std::iota(blocks.begin(), blocks.end(), 0);
  return blocks;
}

template <typename T>
std::vector<float> Compute(const std::vector<T>& samples, const BlockGrid& grid, int levels,
  const ClassifiedTable& table, int threads = 0)
{
  const BlockedVolume volume = { grid.GetSamples(), grid.GetBlocks(), grid.GetCellsPerBlock() };
  const auto blocks = AllBlocks(grid);
  std::vector<float> distortion(blocks.size() * levels);
  flatblock::ComputeDistortion(
    samples.data(), volume, blocks, levels, table, threads, distortion.data());
  return distortion;
}

template <typename T>
class DistortionOf : public testing::Test
{
};
using AllTypes = testing::Types<char, signed char, unsigned char, short, unsigned short, int,
  unsigned int, long, unsigned long, long long, unsigned long long, float, double>;
TYPED_TEST_SUITE(DistortionOf, AllTypes);

// Noise on a gradient, over most of the type's range.
template <typename T>
std::vector<T> MakeSamples(const Index3& n, std::mt19937& random)
{
  const double highest = std::is_integral_v<T> ? double(std::numeric_limits<T>::max()) : 1e30;
  const double lowest = std::is_integral_v<T> ? double(std::numeric_limits<T>::lowest()) : -1e30;
  std::uniform_real_distribution<double> noise(0.0, 0.2);
  std::vector<T> samples(std::size_t(n[0]) * n[1] * n[2]);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double share = 0.79 * double(i % n[0]) / n[0] + noise(random);
    samples[i] = static_cast<T>(lowest * (1.0 - share) + highest * share);
  }
  return samples;
}
} // namespace

TYPED_TEST(DistortionOf, EqualsTheReference)
{
  std::mt19937 random(4);
  for (const auto& [size, n] :
    { std::make_pair(17, Index3{ 40, 35, 20 }), { 33, { 70, 33, 34 } }, { 65, { 67, 20, 66 } } })
  {
    const auto samples = MakeSamples<TypeParam>(n, random);
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    const bool isExact = std::is_integral_v<TypeParam> && sizeof(TypeParam) <= 2;
    const double span = double(*high) - double(*low);
    const auto table =
      MakeTable(double(*low), double(*high), isExact ? int(span) + 1 : 4096, random);
    const BlockGrid grid(n, size);
    const int levels = grid.GetNumberOfLevels() - 1;
    const auto distortion = Compute(samples, grid, levels, table);
    const Reference<TypeParam> reference(samples, grid, table);
    for (std::int64_t block = 0; block < grid.GetNumberOfBlocks(); ++block)
    {
      for (int level = 1; level <= levels; ++level)
      {
        const double wanted = reference.Compute(block, level);
        ASSERT_NEAR(distortion[block * levels + level - 1], wanted, 1e-6 * wanted)
          << "blocks of " << size << ", block " << block << ", level " << level;
      }
    }
  }
}

TEST(Distortion, HasTheSameBitsForAnyNumberOfThreads)
{
  std::mt19937 random(5);
  const Index3 n = { 100, 90, 80 };
  const auto samples = MakeSamples<float>(n, random);
  const auto table = MakeTable(-1e30, 1e30, 4096, random);
  const BlockGrid grid(n, 17);
  const auto serial = Compute(samples, grid, 3, table, 1);
  for (int threads : { 2, 3, 5, 8 })
  {
    EXPECT_EQ(Compute(samples, grid, 3, table, threads), serial) << threads;
  }
}

TEST(Distortion, ConstantVolumesHaveNone)
{
  std::mt19937 random(6);
  const BlockGrid grid({ 40, 40, 40 }, 17);
  const auto table = MakeTable(0.0, 255.0, 256, random);
  for (unsigned char value : { 0, 77, 255 })
  {
    const std::vector<unsigned char> samples(40 * 40 * 40, value);
    EXPECT_EQ(Compute(samples, grid, 4, table), std::vector<float>(27 * 4, 0.0F));
  }
}

TEST(Distortion, OneBrightVoxelCounts)
{
  const BlockGrid grid({ 33, 33, 33 }, 33);
  std::vector<unsigned short> samples(33 * 33 * 33, 0);
  samples[(11 * 33 + 7) * 33 + 5] = 1;
  const ClassifiedTable table(0.0, 1.0,
    { flatblock::ToClassifiedColor(0.0, 0.0, 0.0, 0.0),
      flatblock::ToClassifiedColor(1.0, 1.0, 1.0, 1.0) });
  // No coarser level has it: the whole difference, in one of all samples.
  const double wanted = std::sqrt(2.0 * 100.0 * 100.0 / std::pow(33.0, 3));
  for (const float distortion : Compute(samples, grid, 5, table))
  {
    EXPECT_NEAR(distortion, wanted, 1e-6 * wanted);
  }
}

TEST(Distortion, WhatIsNotFiniteIsLeftOut)
{
  std::mt19937 random(7);
  const Index3 n = { 17, 17, 17 };
  auto samples = MakeSamples<float>(n, random);
  samples[5] = std::numeric_limits<float>::quiet_NaN();
  samples[1234] = std::numeric_limits<float>::infinity();
  samples[4000] = -std::numeric_limits<float>::infinity();
  const auto table = MakeTable(-1e30, 1e30, 1024, random);
  const BlockGrid grid(n, 17);
  std::vector<float> distortion(3);
  const std::int64_t left = flatblock::ComputeDistortion(
    samples.data(), { n, { 1, 1, 1 }, 16 }, { 0 }, 3, table, 0, distortion.data());
  EXPECT_EQ(left, 3);
  const Reference<float> reference(samples, grid, table);
  for (int level = 1; level <= 3; ++level)
  {
    const double wanted = reference.Compute(0, level);
    EXPECT_TRUE(std::isfinite(wanted));
    EXPECT_NEAR(distortion[level - 1], wanted, 1e-6 * wanted);
  }
  const std::vector<float> nothing(17 * 17 * 17, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(Compute(nothing, grid, 2, table), std::vector<float>(2, 0.0F));
}

TEST(Distortion, HoldsForTinyAndHugeValues)
{
  std::mt19937 random(8);
  const BlockGrid grid({ 20, 20, 20 }, 17);
  std::vector<float> ones(20 * 20 * 20);
  std::uniform_real_distribution<float> anything(0.0F, 1.0F);
  std::generate(ones.begin(), ones.end(), [&] { return anything(random); });
  const auto colors = MakeTable(0.0, 1.0, 512, random).GetColors();
  const auto wanted = Compute(ones, grid, 3, ClassifiedTable(0.0, 1.0, colors));
  for (const float scale : { 1e-30F, 1e-10F, 1e10F, 1e30F })
  {
    auto samples = ones;
    std::transform(
      ones.begin(), ones.end(), samples.begin(), [scale](float v) { return v * scale; });
    const auto distortion = Compute(samples, grid, 3, ClassifiedTable(0.0, scale, colors));
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      EXPECT_NEAR(distortion[i], wanted[i], 1e-4 * wanted[i]) << scale;
    }
  }
}

// For tables that they were not made with.
TEST(Distortion, SummariesKeepTheirBounds)
{
  std::mt19937 random(9);
  const Index3 n = { 70, 50, 40 };
  std::vector<unsigned short> samples(std::size_t(n[0]) * n[1] * n[2]);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    samples[i] =
      static_cast<unsigned short>(500 + 10 * (i % n[0]) + random() % (i % 3 == 0 ? 40 : 400));
  }
  const BlockGrid grid(n, 17);
  const auto blocks = AllBlocks(grid);
  const BlockedVolume volume = { n, grid.GetBlocks(), grid.GetCellsPerBlock() };
  std::vector<flatblock::BlockSummary> summaries(blocks.size());
  std::vector<float> exact(blocks.size() * 3);
  const auto table = [&random] { return MakeTable(0.0, 2000.0, 2001, random); };
  flatblock::ComputeDistortion(
    samples.data(), volume, blocks, 3, table(), 0, exact.data(), summaries.data());
  std::size_t bytes = 0;
  double error = 0.0;
  for (int trial = 0; trial < 20; ++trial)
  {
    const auto edited = table();
    const auto wanted = Compute(samples, grid, 3, edited);
    for (std::size_t block = 0; block < blocks.size(); ++block)
    {
      float estimate[3];
      float bounds[3];
      ASSERT_TRUE(summaries[block].IsSet());
      summaries[block].Estimate(edited, estimate, bounds);
      for (int level = 0; level < 3; ++level)
      {
        const float e = wanted[block * 3 + level];
        ASSERT_LE(std::abs(estimate[level] - e), bounds[level] * 1.0001F + 1e-4F) << trial;
        error += std::abs(estimate[level] - e) / e;
      }
      bytes += summaries[block].GetBytes();
    }
  }
  std::cout << "estimates are off by " << 100.0 * error / (20.0 * 3.0 * double(blocks.size()))
            << " % on average; " << double(bytes) / (20.0 * double(blocks.size()))
            << " bytes a block of 9826\n";
}

// Interpolants so near to their samples that both lie between the same two
// entries.
TEST(Distortion, SmoothFieldsAreExactToo)
{
  std::mt19937 random(12);
  const Index3 n = { 34, 20, 20 };
  std::vector<double> samples(std::size_t(n[0]) * n[1] * n[2]);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double x = double(i % n[0]) / n[0];
    samples[i] = 0.4 + 0.1 * x + 1e-5 * x * x;
  }
  const auto table = MakeTable(0.0, 1.0, 4096, random);
  const BlockGrid grid(n, 17);
  const auto distortion = Compute(samples, grid, 3, table);
  const Reference<double> reference(samples, grid, table);
  for (std::int64_t block = 0; block < grid.GetNumberOfBlocks(); ++block)
  {
    for (int level = 1; level <= 3; ++level)
    {
      const double wanted = reference.Compute(block, level);
      EXPECT_NEAR(distortion[block * 3 + level - 1], wanted, 1e-6 * wanted)
        << block << " " << level;
    }
  }
}
