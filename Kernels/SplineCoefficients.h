/// Coefficients of the spline that goes through samples.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace flatblock
{
/// Replaces values by the coefficients of the uniform cubic B-spline that interpolates them, along
/// one axis: a recursive filter there and one back (Unser, Splines: A Perfect Fit for Signal and
/// Image Processing, IEEE Signal Processing Magazine 1999, box 2). What is beyond the ends is taken
/// as the last value.
///
/// @param values  `count` rows, one after the other, of `length` values; filtered across the rows
inline void InterpolateAcross(float* values, int count, std::size_t length)
{
  const float pole = std::sqrt(3.0F) - 2.0F;
  const float gain = 6.0F;
  for (std::size_t i = 0; i < length; ++i)
  {
    values[i] *= gain / (1.0F - pole);
  }
  for (int row = 1; row < count; ++row)
  {
    float* here = values + row * length;
    const float* before = here - length;
    for (std::size_t i = 0; i < length; ++i)
    {
      here[i] = gain * here[i] + pole * before[i];
    }
  }
  float* last = values + (count - 1) * length;
  for (std::size_t i = 0; i < length; ++i)
  {
    last[i] *= -pole / (1.0F - pole);
  }
  for (int row = count - 2; row >= 0; --row)
  {
    float* here = values + row * length;
    const float* behind = here + length;
    for (std::size_t i = 0; i < length; ++i)
    {
      here[i] = pole * (behind[i] - here[i]);
    }
  }
}

/// The same along all axes of side^3 values.
inline void InterpolateBySpline(std::vector<float>& values, int side)
{
  const std::size_t row = side;
  const std::size_t plane = row * row;
  for (std::size_t i = 0; i < plane; ++i)
  {
    InterpolateAcross(&values[i * row], side, 1);
  }
  for (std::size_t k = 0; k < row; ++k)
  {
    InterpolateAcross(&values[k * plane], side, row);
  }
  InterpolateAcross(values.data(), side, plane);
}

/// Samples around those that are wanted, without which coefficients are off by 1e-7 of the values:
/// what they tell of others falls by 2 - sqrt(3) from sample to sample.
constexpr int SplineMargin = 12;
} // namespace flatblock
