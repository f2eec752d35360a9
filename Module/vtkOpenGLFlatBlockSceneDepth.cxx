#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockSceneDepth.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkOpenGLFlatBlockSceneDepth);

namespace
{
int GetDepthAttachment(unsigned int parameter)
{
  int framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  int value = 0;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, framebuffer == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT, parameter, &value);
  return value;
}

// One of vtkTextureObject's depth formats, or WithStencil.
constexpr int WithStencil = -1;
int GetDepthFormat()
{
  if (GetDepthAttachment(GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0)
  {
    return WithStencil;
  }
  if (GetDepthAttachment(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
  {
    return vtkTextureObject::Float32;
  }
  switch (GetDepthAttachment(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE))
  {
  case 16:
    return vtkTextureObject::Fixed16;
  case 32:
    return vtkTextureObject::Fixed32;
  default:
    return vtkTextureObject::Fixed24;
  }
}
} // namespace

vtkOpenGLFlatBlockSceneDepth::vtkOpenGLFlatBlockSceneDepth() = default;
vtkOpenGLFlatBlockSceneDepth::~vtkOpenGLFlatBlockSceneDepth() = default;

void vtkOpenGLFlatBlockSceneDepth::Capture(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  int width = 0;
  int height = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &this->Origin[0], &this->Origin[1]);
  this->Allocate(window, width, height);
  this->Blit(window, width, height);
}

// Depth can only be blitted to a framebuffer of the same depth format.
void vtkOpenGLFlatBlockSceneDepth::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  const int format = GetDepthFormat();
  if (this->Depth->GetHandle() != 0 && this->Depth->GetContext() == window &&
      this->Format == format && static_cast<int>(this->Depth->GetWidth()) == width &&
      static_cast<int>(this->Depth->GetHeight()) == height)
  {
    return;
  }
  this->ReleaseGraphicsResources(window);
  this->Depth->SetContext(window);
  this->Format = format;
  this->Bytes.Set(GetBytes(width, height));
  if (format == WithStencil)
  {
    this->Depth->AllocateDepthStencil(width, height);
  }
  else
  {
    this->Depth->AllocateDepth(width, height, format);
  }
}

void vtkOpenGLFlatBlockSceneDepth::ReleaseIfStale(vtkRenderer* renderer)
{
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  if (static_cast<int>(this->Depth->GetWidth()) != size[0] ||
      static_cast<int>(this->Depth->GetHeight()) != size[1])
  {
    this->ReleaseGraphicsResources(renderer->GetRenderWindow());
  }
}

void vtkOpenGLFlatBlockSceneDepth::Blit(vtkOpenGLRenderWindow* window, int width, int height)
{
  vtkOpenGLState* state = window->GetState();
  int source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->DeactivateDrawBuffers();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, source);
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglBlitFramebuffer(this->Origin[0], this->Origin[1], this->Origin[0] + width,
    this->Origin[1] + height, 0, 0, width, height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->PopFramebufferBindings();
}

void vtkOpenGLFlatBlockSceneDepth::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depth->ReleaseGraphicsResources(window);
  this->Bytes.Set(0);
  this->Framebuffer->ReleaseGraphicsResources(window);
}

void vtkOpenGLFlatBlockSceneDepth::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << "\n";
}
