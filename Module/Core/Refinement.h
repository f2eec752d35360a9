/// The way from the levels that are on the GPU to those that are wanted.
#pragma once

#include "AtlasShape.h"
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
  std::int64_t Texels = 0; ///< of the bricks that they get
};

/// One frame's part of the way from `current` to `target`; at least one block changes where they
/// differ. Blocks that are new to the picture come at their coarsest level at once, whatever the
/// budget. Of the others, those that are to be finest come first; blocks that are to be coarser
/// give up their memory as it is needed. The result fits the shape.
///
/// @param current  of every block; may be empty: nothing is there yet
/// @param target   of every block, which together fit the shape
std::vector<std::int8_t> StepTowards(const BlockGrid& grid, const AtlasShape& shape,
  const std::vector<std::int8_t>& current, const std::vector<std::int8_t>& target,
  RefinementBudget budget);
} // namespace flatblock
