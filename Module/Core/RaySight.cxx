#include "RaySight.h"

#include <algorithm>
#include <cmath>

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

// Columns of the inverse, by Gauss and Jordan with pivots.
std::array<Column, 4> Invert(const double* matrix)
{
  double rows[4][8];
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      rows[i][j] = matrix[4 * i + j];
      rows[i][4 + j] = i == j ? 1.0 : 0.0;
    }
  }
  for (int c = 0; c < 4; ++c)
  {
    const auto* pivot = std::max_element(rows + c, rows + 4,
      [c](const auto& a, const auto& b) { return std::abs(a[c]) < std::abs(b[c]); });
    std::swap_ranges(rows[c], rows[c] + 8, rows[pivot - rows]);
    const double scale = rows[c][c];
    std::for_each(rows[c], rows[c] + 8, [scale](double& value) { value /= scale; });
    for (int i = 0; i < 4; ++i)
    {
      const double factor = i == c ? 0.0 : rows[i][c];
      for (int j = 0; j < 8 && factor != 0.0; ++j)
      {
        rows[i][j] -= factor * rows[c][j];
      }
    }
  }
  std::array<Column, 4> columns;
  for (int j = 0; j < 4; ++j)
  {
    columns[j] = { rows[0][4 + j], rows[1][4 + j], rows[2][4 + j], rows[3][4 + j] };
  }
  return columns;
}

// Rays begin in a point that the matrix takes to (0, 0, -1, 0). Seen from there, a point that moves
// over the screen moves linearly, also where the eye is at infinity.
std::array<double, 9> GetDirections(const std::array<Column, 4>& inverse, const Column& eye)
{
  std::array<double, 9> directions;
  double largest = 0.0;
  const int columnOf[3] = { 0, 1, 3 };
  for (int i = 0; i < 9; ++i)
  {
    const Column& column = inverse[columnOf[i / 3]];
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

RaySight ComputeRaySight(
  const double* sampleToClip, const std::array<int, 3>& samples, bool parallel)
{
  const std::array<Column, 4> inverse = Invert(sampleToClip);
  Column eye;
  std::transform(
    inverse[2].begin(), inverse[2].end(), eye.begin(), [](double value) { return -value; });
  eye[3] = parallel ? 0.0 : eye[3];

  RaySight sight;
  sight.Direction = GetDirections(inverse, eye);
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
    sight.Origin[i] = w * inverse[0][i];
    sight.Origin[3 + i] = w * inverse[1][i];
    sight.Origin[6 + i] = z * inverse[2][i] + w * inverse[3][i];
  }
  return sight;
}

bool IsBoxTooCloseToDraw(const double* sampleToClip, const std::array<int, 3>& samples)
{
  constexpr double LargestRatio = 1000.0;
  double nearest = 0.0;
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Point point = { (corner & 1) * (samples[0] - 1.0), (corner >> 1 & 1) * (samples[1] - 1.0),
      (corner >> 2) * (samples[2] - 1.0) };
    const double w = Apply(sampleToClip + 12, point);
    nearest = corner == 0 ? w : std::min(nearest, w);
    farthest = corner == 0 ? w : std::max(farthest, w);
  }
  return !(nearest > 0.0) || farthest > LargestRatio * nearest;
}
} // namespace flatblock
