/// Bricks of filtered levels.
#pragma once

#include "BrickCopy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace flatblock
{
/// Level l of a volume, smoothed: the samples at multiples of 2^l, each the mean of its neighbours
/// weighted by a tent that falls to 0 at a distance of 2^l along each axis. Samples beyond the
/// volume repeat the last one. Depends on the position in the volume alone, so that bricks agree on
/// the samples that they share.
template <typename T, typename Texel>
class BrickFilter
{
public:
  /// @param samples  dims[0] * dims[1] * dims[2] values, x fastest
  BrickFilter(
    const T* samples, const std::array<int, 3>& dims, const TexelEncoder<T, Texel>& encode)
    : Samples(samples), Dims(dims), Encode(encode)
  {
  }

  /// Writes side^3 texels, x fastest.
  ///
  /// @param first   the brick's first sample
  /// @param stride  2^l
  void Read(const std::array<int, 3>& first, int side, int stride, Texel* brick)
  {
    const int reach = stride - 1;
    const int rows = (side - 1) * stride + 2 * reach + 1;
    this->SetWeights(stride);
    this->AlongX.resize(std::size_t(rows) * rows * side);
    float* out = this->AlongX.data();
    for (int k = 0; k < rows; ++k)
    {
      for (int j = 0; j < rows; ++j)
      {
        this->FilterRow(first, j - reach, k - reach, side, stride, out);
        out += side;
      }
    }
    this->AlongY.resize(std::size_t(rows) * side * side);
    for (int k = 0; k < rows; ++k)
    {
      this->FilterPlane(&this->AlongX[std::size_t(k) * rows * side], side, side, stride,
        &this->AlongY[std::size_t(k) * side * side]);
    }
    const int plane = side * side;
    this->AlongZ.resize(std::size_t(plane) * side);
    this->FilterPlane(this->AlongY.data(), plane, side, stride, this->AlongZ.data());
    std::transform(this->AlongZ.begin(), this->AlongZ.end(), brick, ToTexel);
  }

private:
  static Texel ToTexel(float value)
  {
    if constexpr (std::is_integral_v<Texel>)
    {
      return static_cast<Texel>(std::lround(value));
    }
    else
    {
      return value;
    }
  }

  void SetWeights(int stride)
  {
    this->Weights.clear();
    for (int k = 1 - stride; k < stride; ++k)
    {
      const float inside = static_cast<float>(stride - std::abs(k));
      this->Weights.push_back(inside / static_cast<float>(stride * stride));
    }
  }

  // One row of the volume, filtered along x.
  void FilterRow(
    const std::array<int, 3>& first, int j, int k, int side, int stride, float* out) const
  {
    const int y = std::clamp(first[1] + j, 0, this->Dims[1] - 1);
    const int z = std::clamp(first[2] + k, 0, this->Dims[2] - 1);
    const T* row =
      this->Samples + (static_cast<std::size_t>(z) * this->Dims[1] + y) * this->Dims[0];
    for (int i = 0; i < side; ++i)
    {
      float sum = 0.0F;
      int x = first[0] + i * stride - (stride - 1);
      for (const float weight : this->Weights)
      {
        sum +=
          weight * static_cast<float>(this->Encode(row[std::clamp(x++, 0, this->Dims[0] - 1)]));
      }
      out[i] = sum;
    }
  }

  // Rows of `length` values, filtered across.
  void FilterPlane(const float* in, int length, int side, int stride, float* out) const
  {
    for (int j = 0; j < side; ++j, out += length)
    {
      std::fill_n(out, length, 0.0F);
      const float* row = in + static_cast<std::ptrdiff_t>(j) * stride * length;
      for (const float weight : this->Weights)
      {
        for (int i = 0; i < length; ++i)
        {
          out[i] += weight * row[i];
        }
        row += length;
      }
    }
  }

  const T* Samples;
  std::array<int, 3> Dims;
  TexelEncoder<T, Texel> Encode;
  std::vector<float> Weights;
  std::vector<float> AlongX;
  std::vector<float> AlongY;
  std::vector<float> AlongZ;
};
} // namespace flatblock
