#include "BrickCopy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

using flatblock::CopyBrick;
using flatblock::TexelEncoder;

TEST(BrickCopy, RepeatsTheLastSampleBeyondTheFarFaces)
{
  const std::array<int, 3> dims = { 4, 3, 2 };
  std::vector<std::uint8_t> samples;
  for (int i = 0; i < 4 * 3 * 2; ++i)
  {
    samples.push_back(static_cast<std::uint8_t>(10 + i));
  }
  const int side = 3;
  std::vector<std::uint8_t> brick(side * side * side, 0);
  CopyBrick(samples.data(), dims, { 2, 1, 0 }, side, 1, TexelEncoder<std::uint8_t, std::uint8_t>(),
    brick.data());
  for (int k = 0; k < side; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        const int x = std::min(2 + i, 3);
        const int y = std::min(1 + j, 2);
        const int z = std::min(k, 1);
        EXPECT_EQ(brick[(k * side + j) * side + i], samples[(z * 3 + y) * 4 + x]);
      }
    }
  }
}

// As the apron of a block at a near face has it.
TEST(BrickCopy, RepeatsTheFirstSampleBeforeTheNearFaces)
{
  const std::array<int, 3> dims = { 9, 7, 1 };
  std::vector<std::uint8_t> samples(std::size_t(9) * 7);
  std::iota(samples.begin(), samples.end(), std::uint8_t(10));
  for (const int stride : { 1, 2, 4 })
  {
    const int side = 8 / stride + 3;
    std::vector<std::uint8_t> brick(std::size_t(side) * side * side, 0);
    CopyBrick(samples.data(), dims, { -stride, -stride, -stride }, side, stride,
      TexelEncoder<std::uint8_t, std::uint8_t>(), brick.data());
    for (int i = 0; i < side * side * side; ++i)
    {
      const int x = std::clamp((i % side - 1) * stride, 0, dims[0] - 1);
      const int y = std::clamp((i / side % side - 1) * stride, 0, dims[1] - 1);
      EXPECT_EQ(brick[std::size_t(i)], samples[std::size_t(y * dims[0] + x)]) << i << " " << stride;
    }
  }
}

TEST(BrickCopy, KeepsIntegersOf8And16BitExact)
{
  const TexelEncoder<signed char, std::uint8_t> bytes{ -128.0 };
  for (int v = -128; v <= 127; ++v)
  {
    EXPECT_EQ(bytes(static_cast<signed char>(v)), v + 128);
  }
  const TexelEncoder<short, std::uint16_t> shorts{ -32768.0 };
  for (int v = -32768; v <= 32767; ++v)
  {
    ASSERT_EQ(shorts(static_cast<short>(v)), v + 32768);
  }
  EXPECT_EQ((TexelEncoder<unsigned short, std::uint16_t>()(65535)), 65535);
  EXPECT_EQ((TexelEncoder<unsigned short, std::uint16_t>{ 65000.0 }(65005)), 5);
}

TEST(BrickCopy, PutsOtherTypesOnFloatsOverTheRange)
{
  const double lowest = 1e9;
  const double span = 3e9;
  const TexelEncoder<long long, float> encode{ lowest, span };
  for (long long v = 1'000'000'000; v <= 4'000'000'000; v += 123'456'789)
  {
    const double back = lowest + span * static_cast<double>(encode(v));
    EXPECT_NEAR(back, static_cast<double>(v), span / (1 << 24));
  }
}

TEST(BrickCopy, KeepsTexelsWithinOneButHoles)
{
  const TexelEncoder<double, float> encode{ -1.0, 2.0 };
  for (const double hole : { std::nan(""), -double(INFINITY), double(INFINITY) })
  {
    EXPECT_EQ(encode(hole), flatblock::HoleTexel);
  }
  EXPECT_EQ(encode(-1.5), 0.0F);
  EXPECT_EQ(encode(1.5), 1.0F);
  EXPECT_EQ(encode(0.0), 0.5F);
}
