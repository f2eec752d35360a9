#include "BlockRanges.h"
#include "SampleTypes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace flatblock
{
namespace
{
// Extremes of all samples of a row of blocks that have the same x: rows of samples are long, and
// what is done to each of their samples is the same, so that the compiler makes vectors of them.
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

template <typename T>
void ComputeRowOfBlocks(const T* samples, const std::array<int, 3>& dims, int cells, int blockCount,
  int blockY, int blockZ, ValueRange* ranges)
{
  const int firstY = blockY * cells;
  const int firstZ = blockZ * cells;
  const int lastY = std::min(firstY + cells, dims[1] - 1);
  const int lastZ = std::min(firstZ + cells, dims[2] - 1);
  Columns<T> columns(dims[0]);
  for (int z = firstZ; z <= lastZ; ++z)
  {
    for (int y = firstY; y <= lastY; ++y)
    {
      columns.Add(samples + (static_cast<std::size_t>(z) * dims[1] + y) * dims[0]);
    }
  }
  for (int block = 0; block < blockCount; ++block)
  {
    const int first = block * cells;
    ranges[block] = columns.GetRange(first, std::min(first + cells, dims[0] - 1));
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
    const T*, const std::array<int, 3>&, int, const std::array<int, 3>&, ValueRange*);
FLATBLOCK_FOR_SAMPLE_TYPES(FLATBLOCK_INSTANTIATE)
#undef FLATBLOCK_INSTANTIATE
} // namespace flatblock
