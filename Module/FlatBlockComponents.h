/// Several components of texels: the uniforms of Components.glsl, Masked.glsl and
/// TwoDimensional.glsl.
#pragma once

#include "ComponentTable.h"

class vtkShaderProgram;

namespace flatblock
{
struct RaySampling;

struct MaskOptions
{
  double LowestLabel = 0.0;
  double BlendFactor = 1.0;
};

/// Of a mask the first table is that of all values, the others are those of labels; of a second
/// array the last table's range is its own.
void SetComponents(vtkShaderProgram* program, const RaySampling& sampling,
  const ComponentTables& tables, const MaskOptions& mask);
} // namespace flatblock
