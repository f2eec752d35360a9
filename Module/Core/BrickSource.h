/// Where bricks come from.
#pragma once

#include "BlockBorders.h"
#include "BlockGrid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flatblock
{
/// What a texel of the atlas is made of: normalized unsigned integers, or floats in [0, 1].
enum class TexelFormat
{
  Unsigned8,
  Unsigned16,
  Float32
};

inline std::size_t BytesPerTexel(TexelFormat format)
{
  return format == TexelFormat::Unsigned8 ? 1 : format == TexelFormat::Unsigned16 ? 2 : 4;
}

/// A sample's value is Offset + Scale * texel, with the texel in [0, 1].
struct TexelEncoding
{
  TexelFormat Format = TexelFormat::Unsigned8; ///< of each component
  double Offset = 0.0;
  double Scale = 1.0;
  double Step = 0.0; ///< by which samples, or texels, are rounded; 0: to floats
  int Components = 1;
};

inline std::size_t BytesPerTexel(const TexelEncoding& encoding)
{
  return static_cast<std::size_t>(encoding.Components) * BytesPerTexel(encoding.Format);
}

/// Texels of a brick that are on a scale of their own: Lowest + Extent * texel is what it would be.
struct TexelRange
{
  float Lowest = 0.0F;
  float Extent = 0.0F;
};

/// What the samples of a coarser level are.
enum class LevelFilter
{
  Subsample, ///< finest samples at a stride
  Tent       ///< means of their neighbours
};

/// Hands out the bricks of a volume one by one. Whoever reads from it must not assume that all
/// samples are at hand at once.
class BrickSource
{
public:
  virtual ~BrickSource() = default;
  virtual const BlockGrid& GetGrid() const = 0;
  virtual const TexelEncoding& GetEncoding() const = 0;

  /// Of all blocks; empty where all texels are on one scale.
  virtual const std::vector<TexelRange>& GetRanges() const
  {
    static const std::vector<TexelRange> none;
    return none;
  }

  /// How borders meet coarser ones of the levels that this source makes.
  virtual Continuity GetContinuity() const = 0;

  /// Writes the block's samples at a stride of 2^level as GetTexelSide(level)^3 texels, x fastest,
  /// with the border made as coarse as asked for, and around it the apron, which stays at the
  /// brick's own level. Beyond the volume's faces the last sample repeats. Safe to call from
  /// several threads at once.
  virtual void ReadBrick(
    std::int64_t block, int level, const BlockBorder& border, void* texels) const = 0;
};
} // namespace flatblock
