/// How a mapper blends: from VTK's settings to the uniforms of the shaders that gather along rays.
#pragma once

#include "Blending.h"

class vtkShaderProgram;
class vtkVolumeMapper;
class vtkVolumeProperty;

namespace flatblock
{
struct Clipping;
struct RaySampling;

/// @throws std::runtime_error where a setting that the blend mode needs is missing
Blending GetBlending(vtkVolumeMapper* mapper, vtkVolumeProperty* property, int components);

void SetBlending(vtkShaderProgram* program, const RaySampling& sampling, const Clipping& clipping,
  const TransferTable& table);
} // namespace flatblock
