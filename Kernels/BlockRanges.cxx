#include "BlockRanges.h"

#include "Interruption.h"
#include "RangeColumns.h"
#include "SampleTypes.h"

#include <algorithm>
#include <cstdint>

namespace flatblock
{
namespace
{
template <typename T>
void ComputeRowOfBlocks(const T* samples, const std::array<int, 3>& dims, int cells, int blockCount,
  int blockY, int blockZ, ValueRange* ranges)
{
  const int firstY = blockY * cells;
  const int firstZ = blockZ * cells;
  const int lastY = std::min(firstY + cells, dims[1] - 1);
  const int lastZ = std::min(firstZ + cells, dims[2] - 1);
  Columns<T> columns(dims[0]);
  columns.Add(samples, dims, { firstY, lastY }, { firstZ, lastZ });
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
  ParallelLoop loop;
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t row = 0; row < rows; ++row)
  {
    loop.Do(
      [&]
      {
        const int blockY = static_cast<int>(row % blocks[1]);
        const int blockZ = static_cast<int>(row / blocks[1]);
        ComputeRowOfBlocks(
          samples, dims, cells, blocks[0], blockY, blockZ, ranges + row * blocks[0]);
      });
  }
  loop.Finish();
}

#define FLATBLOCK_INSTANTIATE(T)                                                                   \
  template void ComputeBlockRanges<T>(                                                             \
    const T*, const std::array<int, 3>&, int, const std::array<int, 3>&, ValueRange*);
FLATBLOCK_FOR_SAMPLE_TYPES(FLATBLOCK_INSTANTIATE)
#undef FLATBLOCK_INSTANTIATE
} // namespace flatblock
