/// How far a field stays near its value.
#pragma once

#include "SkipMap.h"

#include <array>
#include <cstdint>
#include <vector>

namespace flatblock
{
/// Smallest and largest value in a cube, in steps of a scale; the first above the second for none.
using CubeRange = std::array<std::uint16_t, 2>;

/// Lets a cube's range hold what it has at coarser levels, as CoarsenKinds() does.
void CoarsenRanges(
  const Index3& size, const Coarsening& coarsening, std::vector<CubeRange>& ranges);

/// The variation map: for each cube how many cubes to each side, itself among them, of its block
/// hold no two values that are further apart than `tolerance`, in steps of the ranges' scale; 0
/// where not even the cube itself does. So from any point in it the field stays within the
/// tolerance for one cube less. At most SkipMap::FarthestLeap.
std::vector<std::uint8_t> MeasureVariation(
  const CubeGrid& grid, const std::vector<CubeRange>& ranges, int tolerance);
} // namespace flatblock
