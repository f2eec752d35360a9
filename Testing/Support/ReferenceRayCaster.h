/// A volume renderer's ray integral on the CPU in double precision, to an error below 1e-6. It is
/// slow, and shares no code with what it is compared with.
#pragma once

#include "ReferencePieces.h"
#include "ReferenceRays.h"

#include <array>
#include <vector>

namespace flatblock::testing
{
/// Samples at the integers of the box [0, n - 1] of sample coordinates, x fastest, n >= 2 on each
/// side. A cell is a hole, of which nothing is drawn, if a sample that its filter reads is not
/// finite: of 8 corners, or of 4^3 coefficients.
struct ReferenceVolume
{
  std::array<int, 3> Samples = {};
  std::vector<double> Values;
};

/// The cubic B-spline is uniform and takes the samples for its coefficients, so it smooths (Sigg &
/// Hadwiger, Fast Third-Order Texture Filtering, GPU Gems 2, 2005). Indices are clamped.
enum class ReferenceFilter
{
  Trilinear,
  CubicBSpline
};

/// Emission and absorption along rays: C = int c(s) tau(s) exp(-int_0^s tau) ds and
/// A = 1 - exp(-int tau), of which the result is {C, A}: premultiplied colour and opacity.
///
/// A ray is cut at the faces of the cells, where the field is a polynomial along it, and the pieces
/// are split until the table is straight over a piece's values and a Gauss rule agrees with that of
/// the halves. The range of the values is bounded by the polynomial's Bernstein coefficients, and
/// the table's bends are summed, not sampled, so no feature of the table is missed.
class ReferenceRayCaster
{
public:
  /// Throws std::invalid_argument for what the structures above do not allow.
  ReferenceRayCaster(ReferenceVolume volume, const ReferenceTable& table, ReferenceFilter filter);

  /// From one point to another in sample coordinates, as far as that is in the box.
  std::array<double, 4> Integrate(const std::array<double, 3>& from,
    const std::array<double, 3>& to, const std::array<double, 9>& sampleToLength) const;

  /// Every `pixelStride`-th pixel of every `pixelStride`-th row, from pixel 0, x fastest. The ray
  /// of a pixel goes through its centre, from the near plane on without end.
  std::vector<std::array<double, 4>> Render(const ReferenceView& view, int pixelStride = 1) const;

private:
  int GetDegree() const { return this->Filter == ReferenceFilter::Trilinear ? 1 : 3; }

  /// The samples that the filter reads in a cell, x fastest.
  std::array<double, 64> GetCoefficients(const std::array<int, 3>& cell) const;
  /// The field from `a` to `b`, coordinates in the cell's [0, 1]^3.
  RayPiece MakePiece(const std::array<int, 3>& cell, const std::array<double, 3>& a,
    const std::array<double, 3>& b) const;
  void FindDrawnCells();
  /// Between two points in the box.
  std::array<double, 4> IntegrateInside(const std::array<double, 3>& from,
    const std::array<double, 3>& to, const std::array<double, 9>& sampleToLength) const;

  ReferenceVolume Volume;
  ReferenceFilter Filter;
  PositionTable Table;
  RayRule Rule;
  std::vector<char> IsDrawn; // of cells, x fastest
};
} // namespace flatblock::testing
