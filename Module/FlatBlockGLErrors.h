/// OpenGL's errors, which nobody else may have asked for.
#pragma once

#include "vtk_glew.h"

namespace flatblock
{
/// Forgets those that came before, so that the next one is our own.
inline void ClearGLErrors()
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
}
} // namespace flatblock
