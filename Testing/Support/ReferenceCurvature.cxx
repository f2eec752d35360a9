#include "ReferenceCurvature.h"

#include "ReferenceVectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flatblock::testing
{
namespace
{
Matrix ToMatrix(const std::array<double, 6>& h)
{
  return { h[0], h[5], h[4], h[5], h[1], h[3], h[4], h[3], h[2] };
}

// The uniform cubic B-spline that is centred at 0, or its derivatives.
double BSpline(double x, int derivative)
{
  const double r = std::abs(x);
  const double sign = x < 0.0 ? -1.0 : 1.0;
  if (r >= 2.0)
  {
    return 0.0;
  }
  const double rest = 2.0 - r;
  switch (derivative)
  {
  case 0:
    return r < 1.0 ? 2.0 / 3.0 - r * r + 0.5 * r * r * r : rest * rest * rest / 6.0;
  case 1:
    return sign * (r < 1.0 ? 1.5 * r * r - 2.0 * r : -0.5 * rest * rest);
  default:
    return r < 1.0 ? 3.0 * r - 2.0 : rest;
  }
}

double Tent(double x)
{
  return std::max(0.0, 1.0 - std::abs(x));
}

// Sum of the samples around, weighted along each axis.
template <typename Weight>
double Convolve(const ReferenceVolume& volume, const Vector& point, const Weight& weight)
{
  const auto& n = volume.Samples;
  std::array<int, 3> cell;
  for (int axis = 0; axis < 3; ++axis)
  {
    cell[axis] = std::clamp(static_cast<int>(std::floor(point[axis])), 0, n[axis] - 2);
  }
  std::array<std::array<double, 4>, 3> weights;
  for (int i = 0; i < 12; ++i)
  {
    weights[i / 4][i % 4] = weight(i / 4, point[i / 4] - (cell[i / 4] + i % 4 - 1));
  }
  double sum = 0.0;
  for (int i = 0; i < 64; ++i)
  {
    const std::array<int, 3> at = { cell[0] + i % 4 - 1, cell[1] + i / 4 % 4 - 1,
      cell[2] + i / 16 - 1 };
    const double product = weights[0][i % 4] * weights[1][i / 4 % 4] * weights[2][i / 16];
    if (product == 0.0)
    {
      continue;
    }
    const std::size_t x = std::clamp(at[0], 0, n[0] - 1);
    const std::size_t y = std::clamp(at[1], 0, n[1] - 1);
    const std::size_t z = std::clamp(at[2], 0, n[2] - 1);
    sum += product * volume.Values[(z * n[1] + y) * n[0] + x];
  }
  return sum;
}
} // namespace

PrincipalCurvatures GetPrincipalCurvatures(const FieldDerivatives& derivatives)
{
  const double slope = std::sqrt(Dot(derivatives.Gradient, derivatives.Gradient));
  const Vector normal = Normalize(derivatives.Gradient);
  const int least =
    static_cast<int>(std::min_element(normal.begin(), normal.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
                     normal.begin());
  Vector axis = {};
  axis[least] = 1.0;
  const Vector u = Normalize(Cross(normal, axis));
  const Vector v = Cross(normal, u);
  const Matrix hessian = ToMatrix(derivatives.Hessian);
  const double a = -Dot(u, Multiply(hessian, u)) / slope;
  const double b = -Dot(u, Multiply(hessian, v)) / slope;
  const double c = -Dot(v, Multiply(hessian, v)) / slope;
  const double root = std::hypot(0.5 * (a - c), b);
  return { 0.5 * (a + c) + root, 0.5 * (a + c) - root };
}

SampledField::SampledField(ReferenceVolume volume, ReferenceFilter filter)
  : Volume(std::move(volume)), Filter(filter)
{
}

double SampledField::GetValue(const Vector& point) const
{
  const bool isSpline = this->Filter == ReferenceFilter::CubicBSpline;
  return Convolve(
    this->Volume, point, [isSpline](int, double x) { return isSpline ? BSpline(x, 0) : Tent(x); });
}

FieldDerivatives SampledField::GetDerivatives(const Vector& point) const
{
  constexpr int Axes[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 1, 2 }, { 0, 2 }, { 0, 1 } };
  FieldDerivatives found;
  if (this->Filter == ReferenceFilter::CubicBSpline)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      found.Gradient[axis] = Convolve(
        this->Volume, point, [axis](int i, double x) { return BSpline(x, i == axis ? 1 : 0); });
    }
    for (int i = 0; i < 6; ++i)
    {
      found.Hessian[i] = Convolve(this->Volume, point,
        [axes = Axes[i]](int axis, double x)
        { return BSpline(x, (axis == axes[0] ? 1 : 0) + (axis == axes[1] ? 1 : 0)); });
    }
    return found;
  }
  const auto valueAt = [&](int first, double firstWay, int second, double secondWay)
  {
    Vector at = point;
    at[first] += firstWay;
    at[second] += secondWay;
    return this->GetValue(at);
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    found.Gradient[axis] = 0.5 * (valueAt(axis, 1.0, axis, 0.0) - valueAt(axis, -1.0, axis, 0.0));
    found.Hessian[axis] =
      valueAt(axis, 1.0, axis, 0.0) - 2.0 * this->GetValue(point) + valueAt(axis, -1.0, axis, 0.0);
    const auto [a, b] = Axes[3 + axis];
    found.Hessian[3 + axis] = 0.25 * (valueAt(a, 1.0, b, 1.0) - valueAt(a, 1.0, b, -1.0) -
                                       valueAt(a, -1.0, b, 1.0) + valueAt(a, -1.0, b, -1.0));
  }
  return found;
}

std::vector<Vector> SampledField::FindCrossing(
  const Vector& from, const Vector& to, double value) const
{
  constexpr double StepsPerSample = 4.0;
  constexpr int Bisections = 40;
  const auto pointAt = [&](double share) -> Vector
  {
    return { from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]),
      from[2] + share * (to[2] - from[2]) };
  };
  const double samples =
    std::max({ std::abs(to[0] - from[0]), std::abs(to[1] - from[1]), std::abs(to[2] - from[2]) });
  const int steps = std::max(1, static_cast<int>(std::ceil(samples * StepsPerSample)));
  const bool isBelow = this->GetValue(from) < value;
  for (int i = 1; i <= steps; ++i)
  {
    if ((this->GetValue(pointAt(double(i) / steps)) < value) != isBelow)
    {
      double low = double(i - 1) / steps;
      double high = double(i) / steps;
      for (int j = 0; j < Bisections; ++j)
      {
        const double middle = 0.5 * (low + high);
        const bool isBefore = (this->GetValue(pointAt(middle)) < value) == isBelow;
        (isBefore ? low : high) = middle;
      }
      return { pointAt(0.5 * (low + high)) };
    }
  }
  return {};
}

FieldDerivatives ToLengths(const FieldDerivatives& derivatives, const Matrix& sampleToLength)
{
  const Matrix toSamples = Invert(sampleToLength);
  const Matrix hessian = ToMatrix(derivatives.Hessian);
  const auto column = [&toSamples](int i) -> Vector {
    return { toSamples[i], toSamples[3 + i], toSamples[6 + i] };
  };
  FieldDerivatives found;
  constexpr int Axes[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 1, 2 }, { 0, 2 }, { 0, 1 } };
  for (int i = 0; i < 3; ++i)
  {
    found.Gradient[i] = Dot(column(i), derivatives.Gradient);
  }
  for (int i = 0; i < 6; ++i)
  {
    found.Hessian[i] = Dot(column(Axes[i][0]), Multiply(hessian, column(Axes[i][1])));
  }
  return found;
}

std::vector<std::array<double, 4>> FindSurface(
  const SampledField& field, const ReferenceView& view, double value)
{
  return RenderRays(view, field.GetSamples(), 1,
    [&](const Vector& from, const Vector& to) -> std::array<double, 4>
    {
      const std::vector<Vector> found = field.FindCrossing(from, to, value);
      return found.empty() ? std::array<double, 4>{}
                           : std::array<double, 4>{ 1.0, found[0][0], found[0][1], found[0][2] };
    });
}
} // namespace flatblock::testing
