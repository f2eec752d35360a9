/// The way from the levels that are on the GPU to those that are wanted.
#pragma once

#include "AtlasShape.h"
#include "BlockBorders.h"
#include "BlockGrid.h"
#include "LodSelector.h"

#include <cstdint>
#include <vector>

namespace flatblock
{
/// Work that one frame may do. Counted, not timed: so a run repeats exactly.
struct RefinementBudget
{
  std::int64_t Blocks = 0; ///< that change their level
  std::int64_t Texels = 0; ///< of the bricks that they get, and of their neighbours' borders
};

/// Bricks of each level.
std::vector<std::int64_t> CountBricks(
  const std::vector<std::int8_t>& levels, const AtlasShape& shape);

class Refiner
{
public:
  /// @param depth  texels of the atlas along z, at most those of the shape
  Refiner(const BlockGrid& grid, const AtlasShape& shape, int depth, Continuity continuity)
    : Grid(grid), Shape(shape), Depth(depth), Borders(continuity)
  {
  }

  /// One frame's part of the way from `current` to `target`; at least one block changes where they
  /// differ, and no other one if that is more than the budget. Blocks that are new to the picture
  /// come at once, at a coarse level that keeps the budget if there is one. Blocks that matter more
  /// are refined first; those that matter less give up their memory as it is needed. The result
  /// fits the atlas.
  ///
  /// @param target   of every block, which together fit
  /// @param current  of every block, which together fit
  /// @param order    of every block, small for those that matter
  std::vector<std::int8_t> StepTowards(const std::vector<std::int8_t>& target,
    const std::vector<std::int8_t>& current, const std::vector<std::uint16_t>& order,
    const RefinementBudget& budget) const;

private:
  class Step;

  const BlockGrid& Grid;
  const AtlasShape& Shape;
  int Depth;
  Continuity Borders;
};
} // namespace flatblock
