/// Several components of texels: the uniforms of Components.glsl and Masked.glsl.
#pragma once

#include "ComponentTable.h"

class vtkShaderProgram;

namespace flatblock
{
struct RaySampling;

void SetComponents(
  vtkShaderProgram* program, const RaySampling& sampling, const ComponentTables& tables);

struct MaskOptions
{
  double LowestLabel = 0.0;
  double BlendFactor = 1.0;
};

/// Of the tables the first one is that of all values, the others those of labels.
void SetMask(vtkShaderProgram* program, const RaySampling& sampling, const ComponentTables& tables,
  const MaskOptions& mask);
} // namespace flatblock
