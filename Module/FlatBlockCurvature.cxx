#include "FlatBlockCurvature.h"

#include "FlatBlockRayGeometry.h"
#include "vtkColorTransferFunction.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace flatblock
{
namespace
{
constexpr int Entries = 1024;
// From 0 to 1: what sums of 64 texels make of a float's 2^-24.
constexpr double LeastStep = 0x1p-22;

// The power of length that it is measured in.
int GetDimension(CurvatureFunction function)
{
  switch (function)
  {
  case CurvatureFunction::Gaussian:
    return -2;
  case CurvatureFunction::ShapeIndex:
    return 0;
  default:
    return -1;
  }
}

bool HasSign(CurvatureFunction function)
{
  return function != CurvatureFunction::Total && function != CurvatureFunction::Curvedness;
}

// Gray where there is no curvature.
void SetDefaultColors(vtkColorTransferFunction* color, bool hasSign)
{
  if (hasSign)
  {
    color->AddRGBPoint(-1.0, 0.23, 0.30, 0.75);
    color->AddRGBPoint(-0.5, 0.55, 0.69, 1.00);
  }
  color->AddRGBPoint(0.0, 0.87, 0.87, 0.87);
  color->AddRGBPoint(0.5, 0.96, 0.60, 0.48);
  color->AddRGBPoint(1.0, 0.71, 0.02, 0.15);
}

void SetTable(vtkShaderProgram* program, const RaySampling& sampling)
{
  constexpr double Margin = 0.02;
  const double margin = sampling.HasEndsInside ? Margin : 0.0;
  const auto [low, high] = sampling.CurvatureRange;
  const double unit = std::pow(sampling.UnitOfLength, GetDimension(sampling.Curvature));
  const double share = (1.0 - 2.0 * margin) / (high - low);
  const float toTable[2] = { static_cast<float>(unit * share),
    static_cast<float>(margin - low * share) };
  const float ends[2] = { static_cast<float>(margin), static_cast<float>(1.0 - margin) };
  program->SetUniform2f("in_CurvatureToTable", toTable);
  program->SetUniform2f("in_CurvatureEnds", ends);
}
} // namespace

std::array<double, 2> GetNaturalRange(CurvatureFunction function, double smallestSpacing)
{
  constexpr double SpacingsPerRadius = 4.0;
  const double most = std::pow(SpacingsPerRadius * smallestSpacing, GetDimension(function));
  return { HasSign(function) ? -most : 0.0, most };
}

std::int64_t GetCurvatureTableBytes()
{
  return 4 * Entries * static_cast<std::int64_t>(sizeof(float));
}

FunctionTable MakeCurvatureTable(
  CurvatureFunction function, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  vtkNew<vtkColorTransferFunction> defaults;
  if (!color || color->GetSize() == 0)
  {
    SetDefaultColors(defaults, HasSign(function));
    color = defaults;
  }
  std::vector<float> colors(3 * static_cast<std::size_t>(Entries));
  std::vector<float> shares(Entries, 1.0F);
  color->GetTable(color->GetRange()[0], color->GetRange()[1], Entries, colors.data());
  if (opacity && opacity->GetSize() > 0)
  {
    opacity->GetTable(opacity->GetRange()[0], opacity->GetRange()[1], Entries, shares.data());
  }
  const auto isFinite = [](float value) { return std::isfinite(value); };
  if (!std::all_of(colors.begin(), colors.end(), isFinite) ||
      !std::all_of(shares.begin(), shares.end(), isFinite))
  {
    throw std::runtime_error("CurvatureColor or CurvatureOpacity has a value that is not finite.");
  }
  FunctionTable table = { Entries, 1, {} };
  for (int i = 0; i < Entries; ++i)
  {
    table.Texels.insert(table.Texels.end(), &colors[3 * i], &colors[3 * i] + 3);
    table.Texels.push_back(std::clamp(shares[i], 0.0F, 1.0F));
  }
  return table;
}

void SetCurvature(vtkShaderProgram* program, vtkMatrix4x4* sampleToDataSet,
  const RaySampling& sampling, const TexelEncoding& encoding)
{
  vtkNew<vtkMatrix4x4> slopes;
  vtkMatrix4x4::Invert(sampleToDataSet, slopes);
  slopes->Transpose();
  SetDirections(program, "in_SlopeToLength", slopes, 1.0 / sampling.UnitOfLength);
  program->SetUniformf(
    "in_SteadySlope", static_cast<float>(2.0 * std::max(encoding.Step, LeastStep)));
  if (sampling.Curvature != CurvatureFunction::None)
  {
    SetTable(program, sampling);
  }
  if (sampling.SilhouetteWidth > 0.0)
  {
    const float color[3] = { static_cast<float>(sampling.SilhouetteColor[0]),
      static_cast<float>(sampling.SilhouetteColor[1]),
      static_cast<float>(sampling.SilhouetteColor[2]) };
    program->SetUniformf(
      "in_SilhouetteWidth", static_cast<float>(sampling.SilhouetteWidth / sampling.UnitOfLength));
    program->SetUniform3f("in_SilhouetteColor", color);
  }
}
} // namespace flatblock
