/// The lit volume on the CPU in double precision, by many small steps.
#pragma once

#include "ReferenceRayCaster.h"

namespace flatblock::testing
{
/// A white headlight on a material, after Blinn and Phong, on both sides.
struct ReferenceMaterial
{
  double Ambient = 0.1;
  double Diffuse = 0.7;
  double Specular = 0.2;
  double SpecularPower = 10.0;
};

/// Emission and absorption as of ReferenceRayCaster, trilinear, but the colour at a point c becomes
/// c (Ambient + Diffuse |n v|) + Specular |n v|^SpecularPower, with v towards the eye and n along
/// the central difference over one sample to each side, or as far as the box goes. A volume without
/// holes. Between planes 1/`steps` of a sample apart along the axis that the ray follows most,
/// matter is taken as that in the middle, so the error falls with the square of `steps`.
class ReferenceShading
{
public:
  ReferenceShading(ReferenceVolume volume, const ReferenceTable& table,
    const ReferenceMaterial& material, int steps = 48);

  /// As ReferenceRayCaster has it.
  std::vector<std::array<double, 4>> Render(const ReferenceView& view, int pixelStride = 1) const;

private:
  double GetValue(const std::array<double, 3>& point) const;
  /// {Ambient + Diffuse |n v|, Specular |n v|^SpecularPower}
  std::array<double, 2> GetLight(const std::array<double, 3>& point,
    const std::array<double, 3>& way, const std::array<double, 9>& lengthToSample,
    const std::array<double, 9>& sampleToLength) const;
  std::array<double, 4> Integrate(const std::array<double, 3>& from,
    const std::array<double, 3>& to, const ReferenceView& view) const;

  ReferenceVolume Volume;
  PositionTable Table;
  ReferenceMaterial Material;
  int Steps;
};
} // namespace flatblock::testing
