#include "ReferenceShading.h"

#include "ReferenceVectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flatblock::testing
{
namespace
{
// 0 for a vector of no length.
double GetCosine(const Vector& a, const Vector& b)
{
  const double lengths = std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
  return lengths > 0.0 ? Dot(a, b) / lengths : 0.0;
}
} // namespace

ReferenceShading::ReferenceShading(
  ReferenceVolume volume, const ReferenceTable& table, const ReferenceMaterial& material, int steps)
  : Volume(std::move(volume)), Table(table), Material(material), Steps(steps)
{
}

double ReferenceShading::GetValue(const Vector& point) const
{
  const auto& n = this->Volume.Samples;
  double value = 0.0;
  std::array<int, 3> cell;
  Vector share;
  for (int axis = 0; axis < 3; ++axis)
  {
    cell[axis] = std::clamp(static_cast<int>(point[axis]), 0, n[axis] - 2);
    share[axis] = point[axis] - cell[axis];
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    const int x = corner & 1;
    const int y = corner >> 1 & 1;
    const int z = corner >> 2;
    const double weight = (x != 0 ? share[0] : 1.0 - share[0]) *
                          (y != 0 ? share[1] : 1.0 - share[1]) *
                          (z != 0 ? share[2] : 1.0 - share[2]);
    value +=
      weight *
      this->Volume.Values[(std::size_t(cell[2] + z) * n[1] + cell[1] + y) * n[0] + cell[0] + x];
  }
  return value;
}

// A gradient goes with the transpose of the inverse, and a way with the matrix.
std::array<double, 2> ReferenceShading::GetLight(const Vector& point, const Vector& way,
  const Matrix& lengthToSample, const Matrix& sampleToLength) const
{
  Vector gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector low = point;
    Vector high = point;
    low[axis] = std::max(point[axis] - 1.0, 0.0);
    high[axis] = std::min(point[axis] + 1.0, this->Volume.Samples[axis] - 1.0);
    gradient[axis] = (this->GetValue(high) - this->GetValue(low)) / (high[axis] - low[axis]);
  }
  Vector normal = {};
  Vector view = {};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      normal[i] += lengthToSample[3 * j + i] * gradient[j];
      view[i] -= sampleToLength[3 * i + j] * way[j];
    }
  }
  const double cosine = std::abs(GetCosine(normal, view));
  return { this->Material.Ambient + this->Material.Diffuse * cosine,
    this->Material.Specular * std::pow(cosine, this->Material.SpecularPower) };
}

std::array<double, 4> ReferenceShading::Integrate(
  const Vector& from, const Vector& to, const ReferenceView& view) const
{
  const Vector way = { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
  const double samples = std::max({ std::abs(way[0]), std::abs(way[1]), std::abs(way[2]) });
  const int count = std::max(1, static_cast<int>(std::ceil(samples * this->Steps)));
  const double length = GetLength(view.SampleToLength, way) / count;
  const Matrix lengthToSample = Invert(view.SampleToLength);
  std::array<double, 4> pixel = {};
  for (int i = 0; i < count && pixel[3] < 1.0 - 1e-7; ++i)
  {
    Vector point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = from[axis] + (i + 0.5) / count * way[axis];
    }
    const auto matter = this->Table.GetEntry(this->Table.GetPosition(this->GetValue(point)));
    if (matter[3] > 0.0)
    {
      const auto light = this->GetLight(point, way, lengthToSample, view.SampleToLength);
      const double opacity = (1.0 - pixel[3]) * -std::expm1(-matter[3] * length);
      for (int channel = 0; channel < 3; ++channel)
      {
        pixel[channel] += opacity * (matter[channel] * light[0] + light[1]);
      }
      pixel[3] += opacity;
    }
  }
  return pixel;
}

std::vector<std::array<double, 4>> ReferenceShading::Render(
  const ReferenceView& view, int pixelStride) const
{
  return RenderRays(view, this->Volume.Samples, pixelStride,
    [&](const Vector& from, const Vector& to) { return this->Integrate(from, to, view); });
}
} // namespace flatblock::testing
