/// What is kept of a block to tell its distortion for any transfer function.
#pragma once

#include "ClassifiedTable.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flatblock
{
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
} // namespace flatblock
