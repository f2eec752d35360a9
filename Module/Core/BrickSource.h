/// Where bricks come from.
#pragma once

#include "BlockBorders.h"
#include "BlockGrid.h"

#include <cstddef>
#include <cstdint>

namespace flatblock
{
/// One texel of the atlas: a normalized unsigned integer, or a float in [0, 1].
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
  TexelFormat Format = TexelFormat::Unsigned8;
  double Offset = 0.0;
  double Scale = 1.0;
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

  /// How borders meet coarser ones of the levels that this source makes.
  virtual Continuity GetContinuity() const = 0;

  /// Writes the block's samples at a stride of 2^level as GetBrickSide(level)^3 texels, x fastest,
  /// with the border made as coarse as asked for. Beyond the volume's far faces the last sample
  /// repeats. Safe to call from several threads at once.
  virtual void ReadBrick(
    std::int64_t block, int level, const BlockBorder& border, void* texels) const = 0;
};
} // namespace flatblock
