/// Several components of texels: the uniforms of Components.glsl.
#pragma once

#include "ComponentTable.h"

class vtkShaderProgram;

namespace flatblock
{
struct RaySampling;

void SetComponents(
  vtkShaderProgram* program, const RaySampling& sampling, const ComponentTables& tables);
} // namespace flatblock
