/// How ranges of values are found quickly.
#pragma once

#include "BlockRanges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace flatblock
{
/// Extremes of all samples of a row of blocks that have the same x: rows of samples are long, and
/// what is done to each of their samples is the same, so that the compiler makes vectors of them.
template <typename T>
class Columns
{
public:
  explicit Columns(int count)
    : Lowest(count, std::numeric_limits<T>::max()),
      Highest(count, std::numeric_limits<T>::lowest()),
      NotFinite(std::is_floating_point_v<T> ? count : 0, 0)
  {
  }

  void Add(const T* row)
  {
    T* lowest = this->Lowest.data();
    T* highest = this->Highest.data();
    const auto count = static_cast<std::ptrdiff_t>(this->Lowest.size());
    for (std::ptrdiff_t x = 0; x < count; ++x)
    {
      const T v = row[x];
      if constexpr (std::is_floating_point_v<T>)
      {
        const bool isFinite = std::isfinite(v);
        lowest[x] = isFinite && v < lowest[x] ? v : lowest[x];
        highest[x] = isFinite && v > highest[x] ? v : highest[x];
        this->NotFinite[x] |= isFinite ? 0 : 1;
      }
      else
      {
        lowest[x] = v < lowest[x] ? v : lowest[x];
        highest[x] = v > highest[x] ? v : highest[x];
      }
    }
  }

  /// All rows of a box; both ends of the intervals belong to it.
  void Add(const T* samples, const std::array<int, 3>& dims, const std::array<int, 2>& y,
    const std::array<int, 2>& z)
  {
    for (int k = z[0]; k <= z[1]; ++k)
    {
      for (int j = y[0]; j <= y[1]; ++j)
      {
        this->Add(samples + (static_cast<std::size_t>(k) * dims[1] + j) * dims[0]);
      }
    }
  }

  ValueRange GetRange(int first, int last) const
  {
    const T lowest =
      *std::min_element(this->Lowest.begin() + first, this->Lowest.begin() + last + 1);
    const T highest =
      *std::max_element(this->Highest.begin() + first, this->Highest.begin() + last + 1);
    ValueRange range;
    if (lowest <= highest)
    {
      range.Lowest = static_cast<double>(lowest);
      range.Highest = static_cast<double>(highest);
    }
    for (int x = first; x <= last && !this->NotFinite.empty(); ++x)
    {
      range.HasHoles = range.HasHoles || this->NotFinite[x] != 0;
    }
    return range;
  }

private:
  std::vector<T> Lowest;
  std::vector<T> Highest;
  std::vector<std::uint8_t> NotFinite;
};
} // namespace flatblock
