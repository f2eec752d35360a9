#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockSkipTexture.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkOpenGLFlatBlockSkipTexture);

vtkOpenGLFlatBlockSkipTexture::vtkOpenGLFlatBlockSkipTexture() = default;
vtkOpenGLFlatBlockSkipTexture::~vtkOpenGLFlatBlockSkipTexture() = default;

bool vtkOpenGLFlatBlockSkipTexture::Upload(
  vtkOpenGLRenderWindow* window, const flatblock::SkipMap& map, int cells)
{
  while (glGetError() != GL_NO_ERROR) // what came before is not ours
  {
  }
  this->Texture->SetContext(window);
  this->Texture->SetInternalFormat(GL_R8UI);
  this->Texture->SetFormat(GL_RED_INTEGER);
  this->Texture->SetDataType(GL_UNSIGNED_BYTE);
  vtkOpenGLState* state = window->GetState();
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const flatblock::Index3& size = map.Size;
  // VTK's type for the data wants no const.
  const bool isCreated = this->Texture->Create3DFromRaw(
    size[0], size[1], size[2], 1, VTK_UNSIGNED_CHAR, const_cast<std::uint8_t*>(map.Leaps.data()));
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (!isCreated || glGetError() != GL_NO_ERROR)
  {
    this->ReleaseGraphicsResources(window);
    return false;
  }
  this->Size = size;
  this->Cells = cells;
  this->Bytes.Set(static_cast<std::int64_t>(map.Leaps.size()));
  return true;
}

bool vtkOpenGLFlatBlockSkipTexture::IsUploaded() const
{
  return this->Texture->GetHandle() != 0;
}

void vtkOpenGLFlatBlockSkipTexture::Activate(vtkShaderProgram* program)
{
  this->Texture->Activate();
  program->SetUniformi("in_SkipMap", this->Texture->GetTextureUnit());
  program->SetUniform1iv("in_Cubes", 3, this->Size.data());
  program->SetUniformi("in_CellsPerCube", this->Cells);
}

void vtkOpenGLFlatBlockSkipTexture::Deactivate()
{
  this->Texture->Deactivate();
}

void vtkOpenGLFlatBlockSkipTexture::ReleaseIfStale(vtkWindow* window, vtkTypeInt64 bytes)
{
  if (this->Bytes.Get() != bytes)
  {
    this->ReleaseGraphicsResources(window);
  }
}

void vtkOpenGLFlatBlockSkipTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Bytes.Set(0);
}

void vtkOpenGLFlatBlockSkipTexture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bytes: " << this->Bytes.Get() << "\n";
}
