/// How wrong each block of a volume looks at each level of detail.
#pragma once

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

/// How often which value stands for which other one at each level of a block: enough to tell e(b,
/// l) for any table without looking at the samples again, but for what happens within a bin. Takes
/// 4 bytes for each pair of bins that occurs.
class BlockSummary
{
public:
  static constexpr int Bins = 16; ///< of equal width over the block's range

  /// @param first   entry of the table that is nearest to the block's lowest sample
  /// @param last    the same of its highest
  /// @param counts  Bins * Bins of each level in turn: samples whose value is in bin i, and whose
  ///                interpolant is in bin j, at i * Bins + j
  void Set(int first, int last, const std::vector<std::uint32_t>& counts);

  bool IsSet() const { return !this->Ends.empty(); }
  std::size_t GetBytes() const { return this->Pairs.size() * sizeof(this->Pairs[0]); }

  /// e(b, l) for the levels from 1 on, and how far it may be from the exact value: by the triangle
  /// inequality the root mean square of what colours vary within the two bins of each sample.
  ///
  /// @param table  of the same range and number of entries as the one that it was made with
  void Estimate(const ClassifiedTable& table, float* distortion, float* bounds) const;

private:
  int First = 0;
  int Last = 0;
  std::vector<std::uint32_t> Pairs; ///< the pair of bins, and its count in the upper 24 bits
  std::vector<std::uint16_t> Ends;  ///< of each level's pairs
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
