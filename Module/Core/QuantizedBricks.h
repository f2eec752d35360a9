/// Bricks of few bits.
#pragma once

#include "BrickSource.h"

#include <vector>

namespace flatblock
{
/// The bricks of another source, rounded to a few values that lie at equal distances over a range
/// of each block: a texel is off by at most half of such a distance.
class QuantizedBricks : public BrickSource
{
public:
  /// @param source  outlives this; none of its texels is a hole
  /// @param ranges  of all blocks, in which all texels of all their levels lie
  /// @param bits    1 to 8, of a texel; all take a byte
  QuantizedBricks(const BrickSource& source, std::vector<TexelRange> ranges, int bits);

  const BlockGrid& GetGrid() const override { return this->Source.GetGrid(); }
  const TexelEncoding& GetEncoding() const override { return this->Encoding; }
  const std::vector<TexelRange>& GetRanges() const override { return this->Ranges; }
  Continuity GetContinuity() const override { return this->Source.GetContinuity(); }
  void ReadBrick(
    std::int64_t block, int level, const BlockBorder& border, void* texels) const override;

private:
  const BrickSource& Source;
  std::vector<TexelRange> Ranges;
  TexelEncoding Encoding;
  double LastValue; // values are 0 to this
};
} // namespace flatblock
