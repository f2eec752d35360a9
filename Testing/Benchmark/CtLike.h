/// A volume like a computed tomography: air, soft tissue with noise, bone.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flatblock::benchmarks
{
/// Numbers that look random, and are the same everywhere.
inline std::uint32_t Hash(std::uint32_t x)
{
  x = (x ^ (x >> 16)) * 0x7feb352dU;
  x = (x ^ (x >> 15)) * 0x846ca68bU;
  return x ^ (x >> 16);
}

/// Hounsfield units + 1024, x fastest: an elliptic body along z with ribs and a spine; a third of
/// the volume is body.
inline std::vector<std::uint16_t> MakeCtLike(const std::array<int, 3>& n)
{
  std::vector<std::uint16_t> samples(std::size_t(n[0]) * n[1] * n[2]);
#pragma omp parallel for
  for (int k = 0; k < n[2]; ++k)
  {
    std::uint16_t* sample = samples.data() + std::size_t(k) * n[0] * n[1];
    const double z = double(k) / n[2];
    const double rib = std::sin(60.0 * z);
    for (int j = 0; j < n[1]; ++j)
    {
      const double y = (double(j) / n[1] - 0.5) / 0.30;
      for (int i = 0; i < n[0]; ++i)
      {
        const double x = (double(i) / n[0] - 0.5) / 0.36;
        const double r = x * x + y * y;
        const auto number = static_cast<std::uint32_t>((std::size_t(k) * n[1] + j) * n[0] + i);
        // The sum of three uniform numbers is nearly normal.
        const std::uint32_t bits = Hash(number);
        const double noise =
          double(bits & 1023) + double(bits >> 10 & 1023) + double(bits >> 20 & 1023) - 1534.5;
        double value = 24.0; // air
        if (r < 1.0)
        {
          const bool isBone =
            (r > 0.80 && r < 0.90 && rib > 0.2) || (std::abs(x) < 0.12 && std::abs(y - 0.6) < 0.15);
          const bool isLung = !isBone && r < 0.5 && std::abs(x) > 0.15;
          value = isBone ? 1900.0 : (isLung ? 220.0 : 1074.0);
          value += noise * (isBone ? 0.2 : 0.04);
        }
        *sample++ = static_cast<std::uint16_t>(value);
      }
    }
  }
  return samples;
}
} // namespace flatblock::benchmarks
