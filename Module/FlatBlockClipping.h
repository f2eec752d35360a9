/// What is cut off a volume: the uniforms of Clipping.glsl.
#pragma once

class vtkShaderProgram;

namespace flatblock
{
struct Clipping;

void SetClipping(vtkShaderProgram* program, const Clipping& clipping);
} // namespace flatblock
