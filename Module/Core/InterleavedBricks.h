/// Bricks of several volumes of one size, texel by texel.
#pragma once

#include "BrickSource.h"

#include <vector>

namespace flatblock
{
/// Texels have two or four components: where the volumes are three, the last one is 0. All are of
/// the widest format; normalized ones become floats by their value. Offset and scale are those of
/// the first volume.
class InterleavedBricks : public BrickSource
{
public:
  /// @param sources  2 to 4, of the same grid, without ranges, that outlive this
  /// @param isMask   whether the last one's values are not mixed where a border is coarser
  InterleavedBricks(std::vector<const BrickSource*> sources, bool isMask);

  const BlockGrid& GetGrid() const override { return this->Sources.front()->GetGrid(); }
  const TexelEncoding& GetEncoding() const override { return this->Encoding; }
  Continuity GetContinuity() const override { return this->Sources.front()->GetContinuity(); }
  void ReadBrick(
    std::int64_t block, int level, const BlockBorder& border, void* texels) const override;

private:
  std::vector<const BrickSource*> Sources;
  bool IsMask;
  TexelEncoding Encoding;
};
} // namespace flatblock
