#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockSkipTexture.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkOpenGLFlatBlockSkipTexture);

bool vtkOpenGLFlatBlockSkipTexture::Upload(
  vtkOpenGLRenderWindow* window, const flatblock::SkipMap& map, int cells)
{
  this->Size = map.Size;
  this->Cells = cells;
  return this->Create(window, static_cast<vtkTypeInt64>(map.Leaps.size()),
    [&]
    {
      this->Texture->SetInternalFormat(GL_R8UI);
      this->Texture->SetFormat(GL_RED_INTEGER);
      this->Texture->SetDataType(GL_UNSIGNED_BYTE);
      vtkOpenGLState* state = window->GetState();
      state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
      // VTK's type for the data wants no const.
      const bool isCreated = this->Texture->Create3DFromRaw(map.Size[0], map.Size[1], map.Size[2],
        1, VTK_UNSIGNED_CHAR, const_cast<std::uint8_t*>(map.Leaps.data()));
      state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
      return isCreated;
    });
}

void vtkOpenGLFlatBlockSkipTexture::Activate(vtkShaderProgram* program)
{
  this->Texture->Activate();
  program->SetUniformi("in_SkipMap", this->Texture->GetTextureUnit());
  program->SetUniform1iv("in_Cubes", 3, this->Size.data());
  program->SetUniformi("in_CellsPerCube", this->Cells);
}
