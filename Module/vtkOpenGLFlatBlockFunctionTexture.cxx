#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockFunctionTexture.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkOpenGLFlatBlockFunctionTexture);

vtkTypeInt64 vtkOpenGLFlatBlockFunctionTexture::GetBytes(const flatblock::FunctionTable& table)
{
  return static_cast<vtkTypeInt64>(sizeof(float)) * static_cast<vtkTypeInt64>(table.Texels.size());
}

bool vtkOpenGLFlatBlockFunctionTexture::Upload(
  vtkOpenGLRenderWindow* window, const flatblock::FunctionTable& table)
{
  return this->Create(window, GetBytes(table),
    [&]
    {
      this->Texture->SetInternalFormat(table.HasColors() ? GL_RGBA32F : GL_R32F);
      this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
      this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
      this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
      this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
      // VTK's type for the data wants no const.
      return this->Texture->Create2DFromRaw(static_cast<unsigned int>(table.Width),
        static_cast<unsigned int>(table.Height), table.HasColors() ? 4 : 1, VTK_FLOAT,
        const_cast<float*>(table.Texels.data()));
    });
}

void vtkOpenGLFlatBlockFunctionTexture::Activate(vtkShaderProgram* program)
{
  this->Texture->Activate();
  program->SetUniformi(this->Name, this->Texture->GetTextureUnit());
}
