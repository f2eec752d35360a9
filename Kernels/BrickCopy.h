/// Copies one brick out of a volume, as texels of an atlas.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace flatblock
{
/// Stands for samples that are not finite: so much larger than 1 that whatever is interpolated from
/// it is, too, whatever its weight, and still finite.
constexpr float HoleTexel = 0x1p100F;

/// The texel of a value, an unsigned integer or a float in [0, 1], so that
/// value = offset + scale * texel, with integer texels counted as normalized.
/// - integers of 8 and 16 bit: exact, offset = the volume's lowest value: so small differences keep
///   all their digits in single precision
/// - other types: float, error <= scale / 2^24; NaN and infinities become HoleTexel
template <typename T, typename Texel>
class TexelEncoder
{
public:
  TexelEncoder() = default;
  explicit TexelEncoder(double offset, double scale = 1.0)
    : Offset(static_cast<Number>(offset)), Scale(scale)
  {
  }

  Texel operator()(T value) const
  {
    if constexpr (std::is_integral_v<Texel>)
    {
      static_assert(std::is_integral_v<T> && sizeof(T) == sizeof(Texel));
      return static_cast<Texel>(static_cast<Number>(value) - this->Offset);
    }
    else
    {
      if constexpr (std::is_floating_point_v<T>)
      {
        if (!std::isfinite(value))
        {
          return HoleTexel;
        }
      }
      const double texel = (static_cast<double>(value) - this->Offset) / this->Scale;
      return static_cast<Texel>(std::clamp(texel, 0.0, 1.0));
    }
  }

private:
  using Number = std::conditional_t<std::is_integral_v<Texel>, int, double>;

  Number Offset = 0;
  double Scale = 1.0;
};

/// Writes side^3 texels, x fastest: the samples from `first` on, at a stride along each axis.
/// Samples beyond the volume's faces repeat the last one.
///
/// @param samples  dims[0] * dims[1] * dims[2] values, x fastest
/// @param first    the brick's first sample, before the volume's far faces
template <typename T, typename Texel>
void CopyBrick(const T* samples, const std::array<int, 3>& dims, const std::array<int, 3>& first,
  int side, int stride, const TexelEncoder<T, Texel>& encode, Texel* brick)
{
  const int before = std::min(side, std::max((stride - 1 - first[0]) / stride, 0));
  const int end = std::min(side, (dims[0] - 1 - first[0]) / stride + 1);
  for (int k = 0; k < side; ++k)
  {
    const int z = std::clamp(first[2] + k * stride, 0, dims[2] - 1);
    for (int j = 0; j < side; ++j)
    {
      const int y = std::clamp(first[1] + j * stride, 0, dims[1] - 1);
      const T* row = samples + (static_cast<std::size_t>(z) * dims[1] + y) * dims[0];
      brick = std::fill_n(brick, before, encode(row[0]));
      if (stride == 1)
      {
        brick = std::transform(row + (first[0] + before), row + (first[0] + end), brick, encode);
      }
      else
      {
        for (int i = before; i < end; ++i)
        {
          *brick++ = encode(row[first[0] + i * stride]);
        }
      }
      brick = std::fill_n(brick, side - end, encode(row[dims[0] - 1]));
    }
  }
}
} // namespace flatblock
