#include "BrickFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>

using flatblock::BrickFilter;
using flatblock::TexelEncoder;

namespace
{
// The mean of the samples around, in double precision.
double GetTentMean(const std::vector<std::uint16_t>& samples, const std::array<int, 3>& dims,
  const std::array<int, 3>& center, int stride)
{
  double sum = 0.0;
  for (int z = 1 - stride; z < stride; ++z)
  {
    for (int y = 1 - stride; y < stride; ++y)
    {
      for (int x = 1 - stride; x < stride; ++x)
      {
        const double weight = double(stride - std::abs(x)) * double(stride - std::abs(y)) *
                              double(stride - std::abs(z));
        const std::size_t at = (std::size_t(std::clamp(center[2] + z, 0, dims[2] - 1)) * dims[1] +
                                 std::clamp(center[1] + y, 0, dims[1] - 1)) *
                                 dims[0] +
                               std::clamp(center[0] + x, 0, dims[0] - 1);
        sum += weight * samples[at];
      }
    }
  }
  return sum / std::pow(double(stride), 6);
}
} // namespace

TEST(BrickFilter, IsTheMeanUnderATent)
{
  std::mt19937 random(3);
  const std::array<int, 3> dims = { 40, 29, 21 };
  std::vector<std::uint16_t> samples(std::size_t(40) * 29 * 21);
  std::generate(samples.begin(), samples.end(), [&] { return std::uint16_t(random()); });
  BrickFilter<std::uint16_t, std::uint16_t> filter(
    samples.data(), dims, TexelEncoder<std::uint16_t, std::uint16_t>());
  for (const auto& [side, stride] : { std::make_pair(17, 1), { 9, 2 }, { 5, 4 }, { 2, 16 } })
  {
    const std::array<int, 3> first = { 16, 16, 0 };
    std::vector<std::uint16_t> brick(std::size_t(side) * side * side);
    filter.Read(first, side, stride, brick.data());
    auto texel = brick.begin();
    for (int k = 0; k < side; ++k)
    {
      for (int j = 0; j < side; ++j)
      {
        for (int i = 0; i < side; ++i)
        {
          const double mean = GetTentMean(samples, dims,
            { first[0] + i * stride, first[1] + j * stride, first[2] + k * stride }, stride);
          ASSERT_NEAR(*texel++, mean, 0.51) << "stride " << stride;
        }
      }
    }
  }
}
