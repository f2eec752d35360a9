/// How a mapper blends: from VTK's settings to the uniforms of the shaders that gather along rays.
#pragma once

#include "Blending.h"
#include "ComponentTable.h"

class vtkShaderProgram;
class vtkVolumeMapper;
class vtkVolumeProperty;

namespace flatblock
{
struct Clipping;
struct Components;
struct RaySampling;

/// @throws std::runtime_error where a setting that the blend mode needs is missing
Blending GetBlending(
  vtkVolumeMapper* mapper, vtkVolumeProperty* property, const Components& components);

void SetBlending(vtkShaderProgram* program, const RaySampling& sampling, const Clipping& clipping,
  const ComponentTables& tables);
} // namespace flatblock
