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
/// How wrong blocks look. Levels without a value count as wrong as the coarsest that has one.
struct BlockDistortion
{
  const float* Values = nullptr; ///< of each block: those of the levels 1 to Levels; none: all 1
  int Levels = 0;
  bool PerByte = false;           ///< errors are divided by the bytes of the brick that is to come
  const float* Weights = nullptr; ///< of each block, by which its errors count; none: all 1
};

/// Each block has a number at each level, and with it a time. Its refinement from level l to l - 1
/// comes at GetTime(number) + GetDelay(l), of two at the same time the one of the block that is
/// first in the grid, and never before that of a coarser level. Blocks out of view come after all
/// refinements of those in view.
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

  /// The largest error at the present level first. Errors count in 2048 steps between a number and
  /// its double, down to 2^-16 of the largest.
  void SetToDistortion(
    const BlockGrid& grid, const std::vector<BlockRank>& ranks, const BlockDistortion& distortion);

  /// The largest error / (distance + diagonal) first.
  void SetToDistortionAndDistance(const BlockGrid& grid, const std::vector<BlockRank>& ranks,
    const BlockDistortion& distortion, const std::array<double, 3>& point,
    const std::array<double, 3>& spacing);

  /// Number of a transparent block.
  static constexpr std::uint16_t Never = 0xffff;

  /// Which of the sequences of numbers the refinements from a level > 0 take; they may share one.
  int GetSequence(int level) const { return std::min<int>(level, GetNumberOfSequences()) - 1; }
  int GetNumberOfSequences() const { return static_cast<int>(this->Numbers.size()); }

  /// Of every block.
  const std::vector<std::uint16_t>& GetNumbers(int sequence) const
  {
    return this->Numbers[sequence];
  }

  /// Of every block, as it matters at first: small for those that matter most.
  const std::vector<std::uint16_t>& GetBlocks() const { return this->Numbers.back(); }

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

  template <typename Importance>
  void SetToImportance(const BlockGrid& grid, const std::vector<BlockRank>& ranks,
    const BlockDistortion& distortion, const Importance& importanceOf);

  std::vector<std::vector<std::uint16_t>> Numbers = { {} };
  std::vector<int> Delays = { 0 };
};
} // namespace flatblock
