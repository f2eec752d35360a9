/// In which order blocks are refined.
#pragma once

#include "BlockGrid.h"
#include "ViewRegion.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace flatblock
{
/// Each block has a number, and with it a time. Its refinement from level l to l - 1 comes at
/// GetTime(number) + GetDelay(l), of two at the same time the one of the block that is first in the
/// grid. Blocks out of view come after all refinements of those in view.
class RefinementOrder
{
public:
  /// Distance from the point of interest, as distance + diagonal: that of the block's centre, and
  /// the diagonal of the block counted in voxels of its present level, both in world units of the
  /// finest voxel. Distances count in steps of 1/32767 of what lies between the nearest and the
  /// farthest block.
  ///
  /// @param point    in samples
  /// @param spacing  world units of a sample's spacing along each axis
  void SetToDistance(const BlockGrid& grid, const std::vector<BlockRank>& ranks,
    const std::array<double, 3>& point, const std::array<double, 3>& spacing);

  /// Of a transparent block in GetBlocks().
  static constexpr std::uint16_t Never = 0xffff;

  /// Of every block: blocks that matter more have smaller numbers.
  const std::vector<std::uint16_t>& GetBlocks() const { return this->Blocks; }

  /// The time of a block with this number, without its delay; and the first number with at least
  /// this time.
  int GetTime(int number) const
  {
    return number < FirstOutOfView ? number : number + this->Delays[0];
  }
  int GetNumber(int time) const
  {
    return time < FirstOutOfView ? std::max(time, 0)
                                 : std::max<int>(FirstOutOfView, time - this->Delays[0]);
  }

  /// How much later it comes at level l > 0. Less the coarser the level.
  int GetDelay(int level) const { return this->Delays[level]; }

private:
  static constexpr std::uint16_t FirstOutOfView = 0x8000;

  std::vector<std::uint16_t> Blocks;
  std::vector<int> Delays = { 0 };
};
} // namespace flatblock
