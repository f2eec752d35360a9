#include "RaySight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatblock
{
namespace
{
using Column = std::array<double, 4>;
using Point = std::array<double, 3>;

double Apply(const double* row, const Point& point)
{
  return row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
}

Column GetColumn(const double* matrix, int column)
{
  return { matrix[column], matrix[4 + column], matrix[8 + column], matrix[12 + column] };
}

// Rays begin in a point that the matrix takes to (0, 0, -1, 0). Seen from there, a point that moves
// over the screen moves linearly, also where the eye is at infinity.
std::array<double, 9> GetDirections(const double* clipToSample, const Column& eye)
{
  std::array<double, 9> directions;
  double largest = 0.0;
  const int columnOf[3] = { 0, 1, 3 };
  for (int i = 0; i < 9; ++i)
  {
    const Column column = GetColumn(clipToSample, columnOf[i / 3]);
    directions[i] = eye[3] * column[i % 3] - eye[i % 3] * column[3];
    largest = std::max(largest, std::abs(directions[i]));
  }
  const double scale = eye[3] < 0.0 ? -largest : largest;
  std::for_each(directions.begin(), directions.end(), [scale](double& value) { value /= scale; });
  return directions;
}

Point GetCenter(const std::array<int, 3>& samples)
{
  return { 0.5 * (samples[0] - 1), 0.5 * (samples[1] - 1), 0.5 * (samples[2] - 1) };
}
} // namespace

RaySight ComputeRaySight(const double* sampleToClip, const double* clipToSample,
  const std::array<int, 3>& samples, bool parallel)
{
  Column eye = GetColumn(clipToSample, 2);
  std::transform(eye.begin(), eye.end(), eye.begin(), [](double value) { return -value; });
  eye[3] = parallel ? 0.0 : eye[3];

  RaySight sight;
  sight.Direction = GetDirections(clipToSample, eye);
  sight.Eye = { 0.0, 0.0, 0.0, 0.0 };
  const Point center = GetCenter(samples);
  double distance = 0.0; // of the eye from the middle, in halves of the box
  for (int i = 0; i < 3 && !parallel; ++i)
  {
    sight.Eye[i] = eye[i] / eye[3];
    distance = std::max(distance, std::abs(sight.Eye[i] - center[i]) / center[i]);
  }
  sight.Eye[3] = parallel ? 0.0 : 1.0;

  constexpr double Far = 4.0;
  const double w = Apply(sampleToClip + 12, center);
  if (!parallel && (distance < Far || w <= 0.0))
  {
    sight.Origin = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, sight.Eye[0], sight.Eye[1], sight.Eye[2] };
    return sight;
  }
  // On the plane through the middle that is parallel to the screen.
  const double z = Apply(sampleToClip + 8, center);
  for (int i = 0; i < 3; ++i)
  {
    const double* row = clipToSample + 4 * i;
    sight.Origin[i] = w * row[0];
    sight.Origin[3 + i] = w * row[1];
    sight.Origin[6 + i] = z * row[2] + w * row[3];
  }
  return sight;
}

bool IsBoxInexactOnScreen(const double* sampleToClip, const std::array<int, 3>& samples)
{
  constexpr double LargestRatio = 1000.0;
  constexpr double SmallestSide = 0.02; // of the screen's 2
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  Point lowest = { Infinity, Infinity, Infinity }; // x and y on the screen, and w
  Point highest = { -Infinity, -Infinity, -Infinity };
  for (int corner = 0; corner < 8; ++corner)
  {
    const Point point = { (corner & 1) * (samples[0] - 1.0), (corner >> 1 & 1) * (samples[1] - 1.0),
      (corner >> 2) * (samples[2] - 1.0) };
    const double w = Apply(sampleToClip + 12, point);
    const Point onScreen = { Apply(sampleToClip, point) / w, Apply(sampleToClip + 4, point) / w,
      w };
    for (int i = 0; i < 3; ++i)
    {
      lowest[i] = std::min(lowest[i], onScreen[i]);
      highest[i] = std::max(highest[i], onScreen[i]);
    }
  }
  return !(lowest[2] > 0.0) || highest[2] > LargestRatio * lowest[2] ||
         highest[0] - lowest[0] < SmallestSide || highest[1] - lowest[1] < SmallestSide;
}
} // namespace flatblock
