/// Where the rays of a frame run: the uniforms of Ray.glsl.
#pragma once

#include "BlockGrid.h"

#include <array>

class vtkMatrix4x4;
class vtkRenderer;
class vtkShaderProgram;

namespace flatblock
{
struct RayGeometry
{
  Index3 Samples;                ///< of the volume
  vtkMatrix4x4* SampleToDataSet; ///< spacing, origin and direction
  vtkMatrix4x4* SampleToClip;
  double Step; ///< between two points of a ray, in the data set's unit of length
};

/// Of samples, in the space that a matrix leads to.
std::array<double, 3> GetSpacing(vtkMatrix4x4* matrix);

/// With the projection of the renderer's camera.
void GetSampleToClip(
  vtkRenderer* renderer, vtkMatrix4x4* sampleToWorld, vtkMatrix4x4* sampleToClip);

/// A matrix for directions, divided by a length.
void SetDirections(
  vtkShaderProgram* program, const char* name, vtkMatrix4x4* matrix, double unitOfLength);

void SetRayGeometry(vtkRenderer* renderer, vtkShaderProgram* program, const RayGeometry& geometry);
} // namespace flatblock
