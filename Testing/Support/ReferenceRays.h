/// The rays of a picture, as straight as double precision allows.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace flatblock::testing
{
using LongPoint = std::array<long double, 3>;

/// Matrices are row-major. SampleToClip takes homogeneous sample coordinates to OpenGL's clip
/// coordinates, with w > 0 before the eye; SampleToLength takes a direction in samples to a vector
/// in units of length. Pixels count from the lower left.
struct ReferenceView
{
  std::array<double, 16> SampleToClip = {};
  std::array<double, 9> SampleToLength = {};
  int Width = 0;
  int Height = 0;
};

/// Origin and direction of a pixel's ray: through its centre, from the near plane on.
std::pair<LongPoint, LongPoint> MakeReferenceRay(const ReferenceView& view, int x, int y);

/// Cuts [first, last] of a line's parameter to what is in the box of so many samples. False where
/// that is nothing.
bool Clip(const std::array<int, 3>& samples, const LongPoint& origin, const LongPoint& direction,
  long double& first, long double& last);

/// The point of a line at a parameter, inside the box in spite of rounding.
std::array<double, 3> GetPoint(const std::array<int, 3>& samples, const LongPoint& origin,
  const LongPoint& direction, long double parameter);

/// From one point in the box to another, in sample coordinates.
using RayIntegral =
  std::function<std::array<double, 4>(const std::array<double, 3>&, const std::array<double, 3>&)>;

/// Every `pixelStride`-th pixel of every `pixelStride`-th row, from pixel 0, x fastest, by all
/// threads; 0 where the ray passes by the box.
std::vector<std::array<double, 4>> RenderRays(const ReferenceView& view,
  const std::array<int, 3>& samples, int pixelStride, const RayIntegral& integral);

double GetLength(const std::array<double, 9>& sampleToLength, const std::array<double, 3>& way);
} // namespace flatblock::testing
