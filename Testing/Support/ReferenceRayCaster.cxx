#include "ReferenceRayCaster.h"

#include "ReferenceRays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace flatblock::testing
{
namespace
{
// The weights of the samples in the Bernstein coefficients of one axis's spline over [a, b] of a
// cell: its blossom, by de Boor's recursion over uniform knots.
std::array<std::array<double, 4>, 4> GetWeights(int degree, double a, double b)
{
  std::array<std::array<double, 4>, 4> weights = {};
  for (int i = 0; i <= degree; ++i)
  {
    for (int sample = 0; sample <= degree; ++sample)
    {
      std::array<double, 4> values = {};
      values[sample] = 1.0;
      for (int level = degree; level > 0; --level)
      {
        const double at = level <= i ? b : a;
        for (int j = 0; j < level; ++j)
        {
          const double share = (at + (level - 1 - j)) / level;
          values[j] += share * (values[j + 1] - values[j]);
        }
      }
      weights[i][sample] = values[0];
    }
  }
  return weights;
}

// Applies an axis's weights to n^3 values and moves that axis last; three times restores the order.
void Contract(
  int n, const std::array<std::array<double, 4>, 4>& weights, std::array<double, 64>& values)
{
  std::array<double, 64> result = {};
  for (int rest = 0; rest < n * n; ++rest)
  {
    for (int i = 0; i < n; ++i)
    {
      for (int sample = 0; sample < n; ++sample)
      {
        result[i * n * n + rest] += weights[i][sample] * values[rest * n + sample];
      }
    }
  }
  values = result;
}

// Where a ray meets the faces of cells, its ends among them, as shares of the way.
std::vector<double> GetFaces(const std::array<double, 3>& from, const std::array<double, 3>& way)
{
  std::vector<double> faces = { 0.0, 1.0 };
  for (int i = 0; i < 3; ++i)
  {
    const double low = std::min(from[i], from[i] + way[i]);
    const auto count = static_cast<int>(std::floor(low + std::abs(way[i])) - std::ceil(low)) + 1;
    for (int face = 0; face < count && way[i] != 0.0; ++face)
    {
      faces.push_back(std::clamp((std::ceil(low) + face - from[i]) / way[i], 0.0, 1.0));
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}
} // namespace

ReferenceRayCaster::ReferenceRayCaster(
  ReferenceVolume volume, const ReferenceTable& table, ReferenceFilter filter)
  : Volume(std::move(volume)), Filter(filter), Table(table), Rule(3 * this->GetDegree())
{
  const auto& n = this->Volume.Samples;
  if (n[0] < 2 || n[1] < 2 || n[2] < 2 ||
      this->Volume.Values.size() != std::size_t(n[0]) * std::size_t(n[1]) * std::size_t(n[2]))
  {
    throw std::invalid_argument("A volume needs two samples a side, and as many as it says.");
  }
  this->FindDrawnCells();
}

std::array<double, 64> ReferenceRayCaster::GetCoefficients(const std::array<int, 3>& cell) const
{
  const auto& n = this->Volume.Samples;
  const int before = this->Filter == ReferenceFilter::Trilinear ? 0 : 1;
  const int count = this->GetDegree() + 1;
  const auto index = [&](int axis, int i)
  { return std::size_t(std::clamp(cell[axis] + i - before, 0, n[axis] - 1)); };
  std::array<double, 64> values = {};
  std::size_t at = 0;
  for (int z = 0; z < count; ++z)
  {
    for (int y = 0; y < count; ++y)
    {
      for (int x = 0; x < count; ++x)
      {
        values[at++] = this->Volume.Values[(index(2, z) * n[1] + index(1, y)) * n[0] + index(0, x)];
      }
    }
  }
  return values;
}

void ReferenceRayCaster::FindDrawnCells()
{
  const auto& n = this->Volume.Samples;
  const int count = (this->GetDegree() + 1) * (this->GetDegree() + 1) * (this->GetDegree() + 1);
  this->IsDrawn.resize(std::size_t(n[0] - 1) * (n[1] - 1) * (n[2] - 1));
#pragma omp parallel for
  for (int z = 0; z < n[2] - 1; ++z)
  {
    std::size_t at = std::size_t(z) * (n[1] - 1) * (n[0] - 1);
    for (int y = 0; y < n[1] - 1; ++y)
    {
      for (int x = 0; x < n[0] - 1; ++x)
      {
        const auto values = this->GetCoefficients({ x, y, z });
        const auto* end = values.data() + count;
        const bool isHole =
          !std::all_of(values.data(), end, [](double v) { return std::isfinite(v); });
        const auto [low, high] = std::minmax_element(values.data(), end);
        this->IsDrawn[at++] = !isHole && !this->Table.IsTransparent(this->Table.GetPosition(*low),
                                           this->Table.GetPosition(*high));
      }
    }
  }
}

RayPiece ReferenceRayCaster::MakePiece(const std::array<int, 3>& cell,
  const std::array<double, 3>& a, const std::array<double, 3>& b) const
{
  const int degree = this->GetDegree();
  const int n = degree + 1;
  auto values = this->GetCoefficients(cell);
  for (double& value : values)
  {
    value = this->Table.GetPosition(value);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    Contract(n, GetWeights(degree, a[axis], b[axis]), values);
  }
  // The product of three Bernstein polynomials is one again, times binomials.
  RayPiece piece;
  for (int i = 0; i < n * n * n; ++i)
  {
    const int x = i % n;
    const int y = i / n % n;
    const int z = i / (n * n);
    piece.Field[x + y + z] += Binomial(degree, x) * Binomial(degree, y) * Binomial(degree, z) /
                              Binomial(3 * degree, x + y + z) * values[i];
  }
  return piece;
}

std::array<double, 4> ReferenceRayCaster::IntegrateInside(const std::array<double, 3>& from,
  const std::array<double, 3>& to, const std::array<double, 9>& sampleToLength) const
{
  const auto& n = this->Volume.Samples;
  const std::array<double, 3> way = { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
  const double length = GetLength(sampleToLength, way);
  const std::vector<double> faces = GetFaces(from, way);
  RayWalk walk(this->Table, this->Rule, length);
  for (std::size_t face = 1; face < faces.size() && !walk.IsOpaque(); ++face)
  {
    const double first = faces[face - 1];
    const double last = faces[face];
    std::array<int, 3> cell;
    std::array<double, 3> a;
    std::array<double, 3> b;
    for (int i = 0; i < 3; ++i)
    {
      const double middle = from[i] + 0.5 * (first + last) * way[i];
      cell[i] = std::clamp(static_cast<int>(middle), 0, n[i] - 2);
      a[i] = std::clamp(from[i] + first * way[i] - cell[i], 0.0, 1.0);
      b[i] = std::clamp(from[i] + last * way[i] - cell[i], 0.0, 1.0);
    }
    if (last > first &&
        this->IsDrawn[(std::size_t(cell[2]) * (n[1] - 1) + cell[1]) * (n[0] - 1) + cell[0]] != 0)
    {
      RayPiece piece = this->MakePiece(cell, a, b);
      piece.Length = (last - first) * length;
      walk.Add(piece);
    }
  }
  return walk.GetPixel();
}

std::array<double, 4> ReferenceRayCaster::Integrate(const std::array<double, 3>& from,
  const std::array<double, 3>& to, const std::array<double, 9>& sampleToLength) const
{
  LongPoint origin;
  LongPoint direction;
  for (int i = 0; i < 3; ++i)
  {
    origin[i] = from[i];
    direction[i] = static_cast<long double>(to[i]) - from[i];
  }
  long double first = 0.0L;
  long double last = 1.0L;
  if (!Clip(this->Volume.Samples, origin, direction, first, last))
  {
    return {};
  }
  return this->IntegrateInside(GetPoint(this->Volume.Samples, origin, direction, first),
    GetPoint(this->Volume.Samples, origin, direction, last), sampleToLength);
}

std::vector<std::array<double, 4>> ReferenceRayCaster::Render(
  const ReferenceView& view, int pixelStride) const
{
  return RenderRays(view, this->Volume.Samples, pixelStride,
    [&](const std::array<double, 3>& from, const std::array<double, 3>& to)
    { return this->IntegrateInside(from, to, view.SampleToLength); });
}
} // namespace flatblock::testing
