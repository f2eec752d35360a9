#include "VariationMap.h"

#include <algorithm>
#include <cstddef>

namespace flatblock
{
namespace
{
CubeRange Union(const CubeRange& a, const CubeRange& b)
{
  return { std::min(a[0], b[0]), std::max(a[1], b[1]) };
}

bool IsNarrow(const CubeRange& range, int tolerance)
{
  return range[0] <= range[1] && range[1] - range[0] <= tolerance;
}

// Unions with both neighbours along an axis, within groups of cubes.
void Widen(const Index3& size, int axis, int group, std::vector<CubeRange>& ranges)
{
  ForLines(size, axis,
    [&](std::size_t first, std::size_t stride)
    {
      CubeRange before = ranges[first];
      for (int i = 0; i < size[axis]; ++i)
      {
        CubeRange& here = ranges[first + i * stride];
        const CubeRange own = here;
        here = i % group > 0 ? Union(here, before) : here;
        const bool isLast = i + 1 == size[axis] || (i + 1) % group == 0;
        here = isLast ? here : Union(here, ranges[first + (i + 1) * stride]);
        before = own;
      }
    });
}
} // namespace

void CoarsenRanges(const Index3& size, const Coarsening& coarsening, std::vector<CubeRange>& ranges)
{
  Coarsen(size, coarsening, ranges, Union);
}

std::vector<std::uint8_t> MeasureVariation(
  const CubeGrid& grid, const std::vector<CubeRange>& ranges, int tolerance)
{
  std::vector<std::uint8_t> reach(ranges.size(), 0);
  std::vector<CubeRange> around = ranges;
  bool isAny = true;
  const int farthest = std::min<int>(SkipMap::FarthestLeap, grid.CubesPerBlock);
  for (int radius = 1; radius <= farthest && isAny; ++radius)
  {
    isAny = false;
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      if (reach[i] == radius - 1 && IsNarrow(around[i], tolerance))
      {
        reach[i] = static_cast<std::uint8_t>(radius);
        isAny = true;
      }
    }
    for (int axis = 0; axis < 3 && isAny; ++axis)
    {
      Widen(grid.Cubes, axis, grid.CubesPerBlock, around);
    }
  }
  return reach;
}
} // namespace flatblock
