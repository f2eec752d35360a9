#include "FlatBlockScattering.h"

#include "FlatBlockRayGeometry.h"
#include "RaySampling.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>

namespace flatblock
{
void SetScattering(vtkShaderProgram* program, vtkMatrix4x4* sampleToWorld,
  vtkMatrix4x4* sampleToDataSet, const RaySampling& sampling, const ComponentTables& tables)
{
  vtkNew<vtkMatrix4x4> worldToSample;
  vtkMatrix4x4::Invert(sampleToWorld, worldToSample);
  SetDirections(program, "in_WorldToSamples", worldToSample, 1.0);
  program->SetUniformf("in_ScatteringReach", static_cast<float>(sampling.ScatteringReach));
  program->SetUniformf("in_ScatteringBlending", static_cast<float>(sampling.ScatteringBlending));
  program->SetUniformf(
    "in_ScatteringAnisotropy", static_cast<float>(sampling.ScatteringAnisotropy));

  const ComponentTable& table = tables.front();
  const double span = table.Table->GetHighest() - table.Table->GetLowest();
  const double share = span > 0.0 ? table.Encoding.Scale / span : 0.0;
  const double ofTexels = sampling.HasNormalsFromOpacity ? 1.0 : share;
  const std::array<double, 3> spacing = GetSpacing(sampleToDataSet);
  float toSurface[3];
  std::transform(spacing.begin(), spacing.end(), toSurface,
    [ofTexels](double length) { return static_cast<float>(2.0 * ofTexels / length); });
  program->SetUniform3f("in_GradientToSurface", toSurface);
}
} // namespace flatblock
