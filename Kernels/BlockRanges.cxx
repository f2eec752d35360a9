#include "BlockRanges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace flatblock
{
namespace
{
template <typename T>
struct Extremes
{
  T Lowest = std::numeric_limits<T>::max();
  T Highest = std::numeric_limits<T>::lowest();
  bool HasBelow = false;
  bool HasAbove = false;

  void Add(const T* values, int count)
  {
    T lowest = this->Lowest;
    T highest = this->Highest;
    for (int i = 0; i < count; ++i)
    {
      const T v = values[i];
      if constexpr (std::is_floating_point_v<T>)
      {
        if (!std::isfinite(v))
        {
          this->HasAbove = this->HasAbove || v > T(0);
          this->HasBelow = this->HasBelow || !(v > T(0));
          continue;
        }
      }
      lowest = v < lowest ? v : lowest;
      highest = v > highest ? v : highest;
    }
    this->Lowest = lowest;
    this->Highest = highest;
  }
};

// Every sample is read once for the block that it lies in, and the shared border samples once more
// for each neighbour.
template <typename T>
void ComputeRowOfBlocks(const T* samples, const std::array<int, 3>& dims, int cells, int blockCount,
  int blockY, int blockZ, ValueRange* ranges)
{
  const int firstY = blockY * cells;
  const int firstZ = blockZ * cells;
  const int lastY = std::min(firstY + cells, dims[1] - 1);
  const int lastZ = std::min(firstZ + cells, dims[2] - 1);
  for (int blockX = 0; blockX < blockCount; ++blockX)
  {
    const int firstX = blockX * cells;
    const int count = std::min(firstX + cells, dims[0] - 1) - firstX + 1;
    Extremes<T> extremes;
    for (int z = firstZ; z <= lastZ; ++z)
    {
      for (int y = firstY; y <= lastY; ++y)
      {
        const auto row = (static_cast<std::size_t>(z) * dims[1] + y) * dims[0];
        extremes.Add(samples + row + firstX, count);
      }
    }
    ValueRange& range = ranges[blockX];
    range = ValueRange();
    if (extremes.Lowest <= extremes.Highest)
    {
      range.Lowest = static_cast<double>(extremes.Lowest);
      range.Highest = static_cast<double>(extremes.Highest);
    }
    range.HasBelow = extremes.HasBelow;
    range.HasAbove = extremes.HasAbove;
  }
}
} // namespace

template <typename T>
void ComputeBlockRanges(const T* samples, const std::array<int, 3>& dims, int cells,
  const std::array<int, 3>& blocks, ValueRange* ranges)
{
  const std::int64_t rows = static_cast<std::int64_t>(blocks[1]) * blocks[2];
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t row = 0; row < rows; ++row)
  {
    const int blockY = static_cast<int>(row % blocks[1]);
    const int blockZ = static_cast<int>(row / blocks[1]);
    ComputeRowOfBlocks(samples, dims, cells, blocks[0], blockY, blockZ, ranges + row * blocks[0]);
  }
}

#define FLATBLOCK_INSTANTIATE(T)                                                                   \
  template void ComputeBlockRanges<T>(                                                             \
    const T*, const std::array<int, 3>&, int, const std::array<int, 3>&, ValueRange*)
FLATBLOCK_INSTANTIATE(char);
FLATBLOCK_INSTANTIATE(signed char);
FLATBLOCK_INSTANTIATE(unsigned char);
FLATBLOCK_INSTANTIATE(short);
FLATBLOCK_INSTANTIATE(unsigned short);
FLATBLOCK_INSTANTIATE(int);
FLATBLOCK_INSTANTIATE(unsigned int);
FLATBLOCK_INSTANTIATE(long);
FLATBLOCK_INSTANTIATE(unsigned long);
FLATBLOCK_INSTANTIATE(long long);
FLATBLOCK_INSTANTIATE(unsigned long long);
FLATBLOCK_INSTANTIATE(float);
FLATBLOCK_INSTANTIATE(double);
#undef FLATBLOCK_INSTANTIATE
} // namespace flatblock
