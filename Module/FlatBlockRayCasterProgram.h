/// The shader program of the ray caster.
#pragma once

#include "RaySampling.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace flatblock
{
struct Clipping;

/// Made of what this sampling uses, and nothing else; ready to be used. The window's cache of
/// shaders compiles each variant once; nothing here outlives the window.
///
/// @param hasHoles     whether cells may have a corner that is not finite
/// @param hasLongSums  whether sums over the transfer table need more digits than a float has
/// @return null where it could not be built; VTK has said why
vtkShaderProgram* ReadyRayCaster(vtkOpenGLRenderWindow* window, const RaySampling& sampling,
  const Clipping& clipping, bool hasHoles, bool hasLongSums);
} // namespace flatblock
