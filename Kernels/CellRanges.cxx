#include "CellRanges.h"

#include "Interruption.h"
#include "RangeColumns.h"
#include "SampleTypes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace flatblock
{
namespace
{
CellRange Quantize(const ValueRange& range, const CellScale& scale)
{
  if (range.IsEmpty())
  {
    return {};
  }
  if (range.HasHoles)
  {
    return { 0, 65535 };
  }
  const auto toNumber = [](double number)
  { return static_cast<std::uint16_t>(std::clamp(number, 0.0, 65535.0)); };
  return { toNumber(std::floor((range.Lowest - scale.Lowest) / scale.Step)),
    toNumber(std::ceil((range.Highest - scale.Lowest) / scale.Step)) };
}
} // namespace

template <typename T>
void ComputeCellRanges(const T* samples, const std::array<int, 3>& dims, int cells, int around,
  const std::array<int, 3>& count, const CellScale& scale, CellRange* ranges)
{
  const std::int64_t rows = static_cast<std::int64_t>(count[1]) * count[2];
  ParallelLoop loop;
#pragma omp parallel for schedule(dynamic, 16)
  for (std::int64_t row = 0; row < rows; ++row)
  {
    loop.Do(
      [&]
      {
        const int y = static_cast<int>(row % count[1]) * cells;
        const int z = static_cast<int>(row / count[1]) * cells;
        Columns<T> columns(dims[0]);
        columns.Add(samples, dims,
          { std::max(y - around, 0), std::min(y + cells + around, dims[1] - 1) },
          { std::max(z - around, 0), std::min(z + cells + around, dims[2] - 1) });
        for (int i = 0; i < count[0]; ++i)
        {
          const int x = i * cells;
          ranges[row * count[0] + i] = Quantize(
            columns.GetRange(std::max(x - around, 0), std::min(x + cells + around, dims[0] - 1)),
            scale);
        }
      });
  }
  loop.Finish();
}

#define FLATBLOCK_INSTANTIATE(T)                                                                   \
  template void ComputeCellRanges<T>(const T*, const std::array<int, 3>&, int, int,                \
    const std::array<int, 3>&, const CellScale&, CellRange*);
FLATBLOCK_FOR_SAMPLE_TYPES(FLATBLOCK_INSTANTIATE)
#undef FLATBLOCK_INSTANTIATE
} // namespace flatblock
