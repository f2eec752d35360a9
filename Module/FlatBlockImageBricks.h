/// Bricks out of an image in memory.
#pragma once

#include "BlockGrid.h"
#include "BlockRanges.h"
#include "BrickBorder.h"
#include "BrickCopy.h"
#include "BrickFilter.h"
#include "BrickSource.h"
#include "SplineCoefficients.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace flatblock
{
/// What a sample becomes in the atlas: exact where the type fits a texture, float elsewhere.
template <typename T>
using TexelOf = std::conditional_t<!std::is_integral_v<T> || (sizeof(T) > 2), float,
  std::conditional_t<sizeof(T) == 1, std::uint8_t, std::uint16_t>>;

/// What samples are rounded by. Those of a narrow range are taken as if it had the values of a
/// byte: or else a mask of 0 and 1 would be nothing but rounding.
template <typename T>
double GetStep(const ValueRange& range)
{
  return std::is_integral_v<T> ? std::min(1.0, (range.Highest - range.Lowest) / 255.0) : 0.0;
}

template <typename T>
TexelEncoding MakeFloatEncoding(const ValueRange& range)
{
  const double span = range.Highest - range.Lowest;
  const double scale = span > 0.0 ? span : 1.0;
  return { TexelFormat::Float32, range.Lowest, scale, GetStep<T>(range) / scale };
}

template <typename T>
TexelEncoding MakeEncoding(const ValueRange& range)
{
  using Texel = TexelOf<T>;
  if constexpr (std::is_same_v<Texel, float>)
  {
    return MakeFloatEncoding<T>(range);
  }
  else
  {
    const auto format = sizeof(T) == 1 ? TexelFormat::Unsigned8 : TexelFormat::Unsigned16;
    const auto scale = static_cast<double>(std::numeric_limits<Texel>::max());
    return { format, range.Lowest, scale, GetStep<T>(range) / scale };
  }
}

/// The first sample, as one of the volume, of a brick with so many of its level's samples around.
inline Index3 GetFirstAround(const BlockGrid& grid, std::int64_t block, int level, int around)
{
  Index3 first = grid.GetFirstSample(block);
  for (int& sample : first)
  {
    sample -= around << level;
  }
  return first;
}

/// Bricks of an image in memory.
template <typename T>
class ImageBricks : public BrickSource
{
public:
  ImageBricks(
    const BlockGrid& grid, const T* samples, const TexelEncoding& encoding, LevelFilter filter)
    : Grid(grid), Samples(samples), Encoding(encoding), Filter(filter)
  {
  }

  const BlockGrid& GetGrid() const override { return this->Grid; }
  const TexelEncoding& GetEncoding() const override { return this->Encoding; }
  Continuity GetContinuity() const override
  {
    return this->Filter == LevelFilter::Subsample ? Continuity::Nested : Continuity::Filtered;
  }

  void ReadBrick(
    std::int64_t block, int level, const BlockBorder& border, void* texels) const override
  {
    auto* brick = static_cast<Texel*>(texels);
    BrickBorder<Texel> brickBorder(brick, this->Grid.GetBrickSide(level), this->Grid.GetApron());
    if (this->Filter == LevelFilter::Subsample)
    {
      CopyBrick(this->Samples, this->Grid.GetSamples(),
        GetFirstAround(this->Grid, block, level, this->Grid.GetApron()),
        this->Grid.GetTexelSide(level), 1 << level, this->GetEncoder(), brick);
    }
    else
    {
      BrickFilter<T, Texel> filter(this->Samples, this->Grid.GetSamples(), this->GetEncoder());
      filter.Read(GetFirstAround(this->Grid, block, level, this->Grid.GetApron()),
        this->Grid.GetTexelSide(level), 1 << level, brick);
      this->CopyCoarserBorder(block, level, border, filter, brickBorder);
    }
    brickBorder.Coarsen(border);
  }

private:
  using Texel = TexelOf<T>;

  TexelEncoder<T, Texel> GetEncoder() const
  {
    return TexelEncoder<T, Texel>(this->Encoding.Offset, this->Encoding.Scale);
  }

  void CopyCoarserBorder(std::int64_t block, int level, const BlockBorder& border,
    BrickFilter<T, Texel>& filter, BrickBorder<Texel>& brick) const
  {
    std::vector<Texel> coarse;
    for (int coarser = 1; level + coarser < this->Grid.GetNumberOfLevels(); ++coarser)
    {
      if (std::find(border.begin(), border.end(), coarser) != border.end())
      {
        const int coarseSide = this->Grid.GetBrickSide(level + coarser);
        coarse.resize(static_cast<std::size_t>(coarseSide) * coarseSide * coarseSide);
        filter.Read(
          this->Grid.GetFirstSample(block), coarseSide, 1 << (level + coarser), coarse.data());
        brick.CopyCoarser(border, coarser, coarse.data());
      }
    }
  }

  BlockGrid Grid;
  const T* Samples;
  TexelEncoding Encoding;
  LevelFilter Filter;
};

/// Bricks of the coefficients of the cubic B-spline that interpolates samples at a level's stride:
/// floats, of which 0 and 1 are the ends of the samples' range. Samples are finite.
template <typename T>
class CoefficientBricks : public BrickSource
{
public:
  CoefficientBricks(const BlockGrid& grid, const T* samples, const ValueRange& range)
    : Grid(grid), Samples(samples), Encoding(MakeFloatEncoding<T>(range))
  {
  }

  const BlockGrid& GetGrid() const override { return this->Grid; }
  const TexelEncoding& GetEncoding() const override { return this->Encoding; }
  Continuity GetContinuity() const override { return Continuity::Off; }

  void ReadBrick(
    std::int64_t block, int level, const BlockBorder& /*border*/, void* texels) const override
  {
    const int around = this->Grid.GetApron() + SplineMargin;
    const int side = this->Grid.GetBrickSide(level) + 2 * around;
    const Index3 first = GetFirstAround(this->Grid, block, level, around);
    const TexelEncoder<T, float> encode(this->Encoding.Offset, this->Encoding.Scale);
    std::vector<float> window(static_cast<std::size_t>(side) * side * side);
    CopyBrick(
      this->Samples, this->Grid.GetSamples(), first, side, 1 << level, encode, window.data());
    InterpolateBySpline(window, side);
    const int inner = this->Grid.GetTexelSide(level);
    auto* brick = static_cast<float*>(texels);
    for (int row = 0; row < inner * inner; ++row)
    {
      const std::size_t y = row % inner + SplineMargin;
      const std::size_t z = row / inner + SplineMargin;
      brick = std::copy_n(&window[(z * side + y) * side + SplineMargin], inner, brick);
    }
  }

private:
  BlockGrid Grid;
  const T* Samples;
  TexelEncoding Encoding;
};
} // namespace flatblock
