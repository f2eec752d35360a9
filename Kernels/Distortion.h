/// How wrong each block of a volume looks at each level of detail.
#pragma once

#include "BlockSummary.h"
#include "ClassifiedTable.h"

#include <array>
#include <cstdint>
#include <vector>

namespace flatblock
{
/// The blocks of a volume of `Samples` samples: as BlockRanges.h has them.
struct BlockedVolume
{
  std::array<int, 3> Samples;
  std::array<int, 3> Blocks;
  int Cells; ///< a block's side, 2^n
};

/// e(b, l) = sqrt(1/n sum |T(v) - T(v_l)|^2) over the n finite samples v of block b, with T the
/// table and v_l the trilinear interpolant of the samples at a stride of 2^l; samples beyond the
/// volume's far faces repeat the last one. Sums are in double precision and in a fixed order: the
/// result has the same bits for any number of threads.
///
/// @param samples     x fastest
/// @param blocks      numbers of the blocks that are computed
/// @param levels      1 to n; results for the levels 1 to `levels`
/// @param threads     0: all
/// @param distortion  levels values for each of `blocks`, in their order
/// @param summaries   one for each of `blocks`, or none
/// @return samples that are not finite, and so left out
/// Instantiated for every C++ arithmetic type that a VTK array can hold.
template <typename T>
std::int64_t ComputeDistortion(const T* samples, const BlockedVolume& volume,
  const std::vector<std::int64_t>& blocks, int levels, const ClassifiedTable& table, int threads,
  float* distortion, BlockSummary* summaries = nullptr);
} // namespace flatblock
