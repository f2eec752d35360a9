#include "FlatBlockGLErrors.h"

#include "vtk_glew.h"

void flatblock::ClearGLErrors()
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
}
