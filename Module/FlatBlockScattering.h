/// Light scattered by the volume: the uniforms of Scattering.glsl.
#pragma once

#include "ComponentTable.h"

class vtkMatrix4x4;
class vtkShaderProgram;

namespace flatblock
{
struct RaySampling;

/// Its steps are those of rays. Gradients are taken by the data set's spacing, as differences of
/// two spacings, in shares of the range of the first table, or of opacities where normals are
/// theirs.
void SetScattering(vtkShaderProgram* program, vtkMatrix4x4* sampleToWorld,
  vtkMatrix4x4* sampleToDataSet, const RaySampling& sampling, const ComponentTables& tables);
} // namespace flatblock
