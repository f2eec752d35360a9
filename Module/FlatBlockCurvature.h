/// Curvature in the ray caster's program.
#pragma once

#include "BrickSource.h"
#include "FunctionTable.h"
#include "RaySampling.h"

#include <array>
#include <cstdint>

class vtkColorTransferFunction;
class vtkMatrix4x4;
class vtkPiecewiseFunction;
class vtkShaderProgram;

namespace flatblock
{
/// What samples can tell of a function of curvature, in 1/length, of 1/length^2 for Gaussian.
std::array<double, 2> GetNaturalRange(CurvatureFunction function, double smallestSpacing);

/// From the first to the last point of both. Throws where one has a value that is not finite.
/// @param color  where it is nullptr or has no point blue, gray and red; gray and red for functions
///   that have no sign
/// @param opacity  1 where it is nullptr or has no point
FunctionTable MakeCurvatureTable(
  CurvatureFunction function, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity);

std::int64_t GetCurvatureTableBytes();

void SetCurvature(vtkShaderProgram* program, vtkMatrix4x4* sampleToDataSet,
  const RaySampling& sampling, const TexelEncoding& encoding);
} // namespace flatblock
