/// What coarser levels of detail make of a grid of cubes.
#pragma once

#include "BlockGrid.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace flatblock
{
/// What coarser levels of detail make of a volume: samples at a stride, or means of those up to
/// that far around; and what is made of these between them.
struct Coarsening
{
  int Cubes = 1;       ///< that the coarsest cell is long, a power of two
  int CellsAround = 0; ///< on each side, whose samples show in a cell
};

/// Calls action(number of the first cube, stride) for all lines of cubes along an axis.
template <typename Action>
void ForLines(const Index3& size, int axis, const Action& action)
{
  const std::size_t strides[3] = { 1, static_cast<std::size_t>(size[0]),
    static_cast<std::size_t>(size[0]) * size[1] };
  const int across = axis == 0 ? 1 : 0;
  const int along = axis == 2 ? 1 : 2;
  for (int j = 0; j < size[along]; ++j)
  {
    for (int i = 0; i < size[across]; ++i)
    {
      action(i * strides[across] + j * strides[along], strides[axis]);
    }
  }
}

/// Gives each cube what `merge`, associative, makes of all cubes that show in it at the coarsest
/// level: those of its cell, and of the cells around.
template <typename Value, typename Merge>
void Coarsen(
  const Index3& size, const Coarsening& coarsening, std::vector<Value>& values, const Merge& merge)
{
  const int reach = coarsening.CellsAround * coarsening.Cubes;
  for (int axis = 0; axis < 3 && (coarsening.Cubes > 1 || reach > 0); ++axis)
  {
    std::vector<Value> line(static_cast<std::size_t>(size[axis]));
    ForLines(size, axis,
      [&](std::size_t first, std::size_t stride)
      {
        for (int i = 0; i < size[axis]; ++i)
        {
          line[i] = values[first + i * stride];
        }
        for (int cell = 0; cell < size[axis]; cell += coarsening.Cubes)
        {
          const int begin = std::max(cell - reach, 0);
          Value merged = line[begin];
          for (int i = begin + 1; i < std::min(cell + coarsening.Cubes + reach, size[axis]); ++i)
          {
            merged = merge(merged, line[i]);
          }
          for (int i = cell; i < std::min(cell + coarsening.Cubes, size[axis]); ++i)
          {
            values[first + i * stride] = merged;
          }
        }
      });
  }
}
} // namespace flatblock
