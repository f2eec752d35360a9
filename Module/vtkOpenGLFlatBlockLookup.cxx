#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockLookup.h"

#include "FlatBlockGLErrors.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

vtkOpenGLFlatBlockLookup::vtkOpenGLFlatBlockLookup() = default;
vtkOpenGLFlatBlockLookup::~vtkOpenGLFlatBlockLookup() = default;

bool vtkOpenGLFlatBlockLookup::Create(
  vtkOpenGLRenderWindow* window, vtkTypeInt64 bytes, const std::function<bool()>& create)
{
  flatblock::ClearGLErrors();
  this->Texture->SetContext(window);
  if (!create() || glGetError() != GL_NO_ERROR)
  {
    this->ReleaseGraphicsResources(window);
    return false;
  }
  this->Bytes.Set(bytes);
  return true;
}

bool vtkOpenGLFlatBlockLookup::IsUploaded() const
{
  return this->Texture->GetHandle() != 0;
}

void vtkOpenGLFlatBlockLookup::Deactivate()
{
  this->Texture->Deactivate();
}

void vtkOpenGLFlatBlockLookup::ReleaseIfStale(vtkWindow* window, vtkTypeInt64 bytes)
{
  if (this->Bytes.Get() != bytes)
  {
    this->ReleaseGraphicsResources(window);
  }
}

void vtkOpenGLFlatBlockLookup::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Bytes.Set(0);
}

void vtkOpenGLFlatBlockLookup::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bytes: " << this->Bytes.Get() << "\n";
}
