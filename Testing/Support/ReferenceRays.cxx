#include "ReferenceRays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace flatblock::testing
{
namespace
{
struct Plane
{
  LongPoint Normal;
  long double Offset; // Normal . p + Offset = 0
};

LongPoint Cross(const LongPoint& a, const LongPoint& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

long double Dot(const LongPoint& a, const LongPoint& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Row `row` of the matrix plus `factor` times its last row.
Plane MakePlane(const std::array<double, 16>& matrix, int row, long double factor)
{
  std::array<long double, 4> sums;
  for (int i = 0; i < 4; ++i)
  {
    sums[i] = matrix[4 * row + i] + factor * matrix[12 + i];
  }
  return { { sums[0], sums[1], sums[2] }, sums[3] };
}
} // namespace

// A ray is where the planes of its x and its y meet, so the far plane does not matter, and nor does
// how far away it is. It runs to where the near plane's side is inside.
std::pair<LongPoint, LongPoint> MakeReferenceRay(const ReferenceView& view, int x, int y)
{
  const Plane a = MakePlane(view.SampleToClip, 0, 1.0L - (2.0L * x + 1.0L) / view.Width);
  const Plane b = MakePlane(view.SampleToClip, 1, 1.0L - (2.0L * y + 1.0L) / view.Height);
  const Plane front = MakePlane(view.SampleToClip, 2, 1.0L);
  LongPoint direction = Cross(a.Normal, b.Normal);
  const LongPoint bFront = Cross(b.Normal, front.Normal);
  const LongPoint frontA = Cross(front.Normal, a.Normal);
  const long double determinant = Dot(direction, front.Normal);
  LongPoint origin;
  for (int i = 0; i < 3; ++i)
  {
    origin[i] =
      -(a.Offset * bFront[i] + b.Offset * frontA[i] + front.Offset * direction[i]) / determinant;
  }
  for (long double& component : direction)
  {
    component = determinant < 0.0L ? -component : component;
  }
  return { origin, direction };
}

// Cuts [first, last] of a line's parameter to what is in the box. False where that is nothing.
bool Clip(const std::array<int, 3>& samples, const LongPoint& origin, const LongPoint& direction,
  long double& first, long double& last)
{
  for (int i = 0; i < 3; ++i)
  {
    const long double low = -origin[i];
    const long double high = static_cast<long double>(samples[i] - 1) - origin[i];
    if (direction[i] == 0.0L && (low > 0.0L || high < 0.0L))
    {
      return false;
    }
    if (direction[i] != 0.0L)
    {
      first = std::max(first, std::min(low / direction[i], high / direction[i]));
      last = std::min(last, std::max(low / direction[i], high / direction[i]));
    }
  }
  return first < last;
}

// The point of a line at a parameter, inside the box in spite of rounding.
std::array<double, 3> GetPoint(const std::array<int, 3>& samples, const LongPoint& origin,
  const LongPoint& direction, long double parameter)
{
  std::array<double, 3> point;
  for (int i = 0; i < 3; ++i)
  {
    const auto coordinate = static_cast<double>(origin[i] + parameter * direction[i]);
    point[i] = std::clamp(coordinate, 0.0, samples[i] - 1.0);
  }
  return point;
}

double GetLength(const std::array<double, 9>& sampleToLength, const std::array<double, 3>& way)
{
  double square = 0.0;
  for (int row = 0; row < 3; ++row)
  {
    double component = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      component += sampleToLength[3 * row + i] * way[i];
    }
    square += component * component;
  }
  return std::sqrt(square);
}

std::vector<std::array<double, 4>> RenderRays(const ReferenceView& view,
  const std::array<int, 3>& samples, int pixelStride, const RayIntegral& integral)
{
  const int columns = (view.Width + pixelStride - 1) / pixelStride;
  const int rows = (view.Height + pixelStride - 1) / pixelStride;
  std::vector<std::array<double, 4>> picture(std::size_t(columns) * rows);
#pragma omp parallel for schedule(dynamic)
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const auto [origin, direction] =
        MakeReferenceRay(view, column * pixelStride, row * pixelStride);
      long double first = 0.0L;
      long double last = std::numeric_limits<long double>::infinity();
      if (Clip(samples, origin, direction, first, last))
      {
        picture[std::size_t(row) * columns + column] = integral(
          GetPoint(samples, origin, direction, first), GetPoint(samples, origin, direction, last));
      }
    }
  }
  return picture;
}
} // namespace flatblock::testing
