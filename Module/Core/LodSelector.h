/// Which level of detail each block is to have.
#pragma once

#include "AtlasShape.h"
#include "BlockGrid.h"
#include "RefinementOrder.h"

#include <cstdint>
#include <vector>

namespace flatblock
{
/// Level of a block of which nothing is drawn.
constexpr std::int8_t NoLevel = -1;

/// Begins with every visible block at the coarsest level, and refines in the given order, one block
/// by one level at a time, until nothing more fits. The first block of a level that does not fit
/// keeps the others waiting that come after it at that level, until a change makes room for it; so
/// does one that has not yet got to that level. Where all blocks fit at level 0 they have it.
class LodSelector
{
public:
  /// Depends on its arguments alone. Takes time in proportion to the number of blocks, without
  /// sorting them.
  ///
  /// @param order           with a number for every block
  /// @param numberOfLevels  that a block may have, at least 1; coarser ones are added where these
  ///                        don't fit
  /// @return whether at least the coarsest levels of all visible blocks fit the shape; where they
  ///         don't the levels stay as they were
  bool Select(const RefinementOrder& order, const AtlasShape& shape, int numberOfLevels);

  /// Of every block, NoLevel where it is not visible.
  const std::vector<std::int8_t>& GetLevels() const { return this->Levels; }

private:
  std::vector<std::int8_t> Levels;
  std::vector<std::vector<std::int32_t>> Counts; ///< by sequence: blocks that have each number
};
} // namespace flatblock
