/// Curvature of the surfaces of a volume, on the CPU in double precision. It shares no code, and no
/// formula, with what it is compared with.
#pragma once

#include "ReferenceRayCaster.h"

#include <array>
#include <functional>
#include <vector>

namespace flatblock::testing
{
/// The Hessian is xx, yy, zz, yz, xz, xy.
struct FieldDerivatives
{
  std::array<double, 3> Gradient = {};
  std::array<double, 6> Hessian = {};
};

struct PrincipalCurvatures
{
  double First = 0.0; ///< the larger one
  double Second = 0.0;
};

/// Eigenvalues of the Hessian on the plane across the gradient, over the gradient's length: convex
/// is positive where values fall outwards.
PrincipalCurvatures GetPrincipalCurvatures(const FieldDerivatives& derivatives);

/// A volume between its samples.
class SampledField
{
public:
  SampledField(ReferenceVolume volume, ReferenceFilter filter);

  const std::array<int, 3>& GetSamples() const { return this->Volume.Samples; }
  double GetValue(const std::array<double, 3>& point) const;

  /// In samples. Trilinear: central differences over one sample, at least one away from the faces
  /// of the volume. Cubic B-spline: those of the spline.
  FieldDerivatives GetDerivatives(const std::array<double, 3>& point) const;

  /// Where the way from one point to another first meets a value, if it does: to 1e-12 of the way,
  /// and of crossings that lie closer to each other than 1/4 of a sample not all.
  std::vector<std::array<double, 3>> FindCrossing(
    const std::array<double, 3>& from, const std::array<double, 3>& to, double value) const;

private:
  ReferenceVolume Volume;
  ReferenceFilter Filter;
};

/// From samples to lengths, which the matrix takes directions to.
FieldDerivatives ToLengths(
  const FieldDerivatives& derivatives, const std::array<double, 9>& sampleToLength);

/// Every pixel whose ray meets the surface: {1, point in samples}, else 0.
std::vector<std::array<double, 4>> FindSurface(
  const SampledField& field, const ReferenceView& view, double value);
} // namespace flatblock::testing
