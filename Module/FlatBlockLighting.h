/// The lights of a renderer on the materials of a volume: the uniforms of Shading.glsl.
#pragma once

#include "ComponentTable.h"
#include "RaySampling.h"

class vtkMatrix4x4;
class vtkRenderer;
class vtkShaderProgram;
class vtkVolumeProperty;

namespace flatblock
{
/// At most six lights that are switched on, as vtkGPUVolumeRayCastMapper has them: headlights,
/// lights far away, and positional ones with attenuation and cone. Ambient light is that of the
/// lights, but a headlight alone is taken to have a white one, whatever it says.
void SetLighting(vtkRenderer* renderer, vtkShaderProgram* program, vtkVolumeProperty* property,
  vtkMatrix4x4* sampleToWorld);

/// Whether a light that is switched on has a position.
bool HasPositionalLights(vtkRenderer* renderer);

/// How gradients, in texels a sample, become magnitudes of a FunctionTable: the uniforms of
/// Gradient.glsl.
void SetGradientScale(vtkShaderProgram* program, vtkMatrix4x4* sampleToDataSet,
  const ComponentTables& tables, const RaySampling& sampling);
} // namespace flatblock
