#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockRayImage.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include "FlatBlockRayImageFragmentGLSL.h"
#include "FlatBlockRayImageVertexGLSL.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

vtkStandardNewMacro(vtkOpenGLFlatBlockRayImage);

namespace
{
// Of colours, and of counts.
vtkTypeInt64 GetBytesPerRay(bool hasCounts)
{
  return hasCounts ? 16 : 8;
}

struct ViewportBox
{
  explicit ViewportBox(vtkRenderer* renderer)
  {
    renderer->GetTiledSizeAndOrigin(
      &this->Size[0], &this->Size[1], &this->Origin[0], &this->Origin[1]);
  }
  int Size[2] = { 0, 0 };
  int Origin[2] = { 0, 0 };
};

// In its end, what was drawn to before is drawn to again.
class FormerTarget
{
public:
  explicit FormerTarget(vtkOpenGLState* state) : State(state)
  {
    state->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport);
    state->PushFramebufferBindings();
  }
  ~FormerTarget()
  {
    const int* v = this->Viewport;
    this->State->PopFramebufferBindings();
    this->State->vtkglViewport(v[0], v[1], v[2], v[3]);
  }
  FormerTarget(const FormerTarget&) = delete;
  FormerTarget& operator=(const FormerTarget&) = delete;

private:
  vtkOpenGLState* State;
  int Viewport[4] = { 0, 0, 0, 0 };
};
} // namespace

vtkOpenGLFlatBlockRayImage::vtkOpenGLFlatBlockRayImage() = default;
vtkOpenGLFlatBlockRayImage::~vtkOpenGLFlatBlockRayImage() = default;

std::array<int, 2> vtkOpenGLFlatBlockRayImage::GetSize(vtkRenderer* renderer, double pixelsPerRay)
{
  const ViewportBox viewport(renderer);
  return { std::max(1, static_cast<int>(std::ceil(viewport.Size[0] / pixelsPerRay))),
    std::max(1, static_cast<int>(std::ceil(viewport.Size[1] / pixelsPerRay))) };
}

vtkTypeInt64 vtkOpenGLFlatBlockRayImage::GetBytes(
  vtkRenderer* renderer, double pixelsPerRay, bool hasCounts)
{
  const auto size = GetSize(renderer, pixelsPerRay);
  return GetBytesPerRay(hasCounts) * size[0] * size[1];
}

bool vtkOpenGLFlatBlockRayImage::HasSize(const std::array<int, 2>& size, bool hasCounts) const
{
  return this->Colors->GetHandle() != 0 && (this->Counts->GetHandle() != 0) == hasCounts &&
         static_cast<int>(this->Colors->GetWidth()) == size[0] &&
         static_cast<int>(this->Colors->GetHeight()) == size[1];
}

void vtkOpenGLFlatBlockRayImage::Allocate(
  vtkOpenGLRenderWindow* window, const std::array<int, 2>& size, bool hasCounts)
{
  if (this->HasSize(size, hasCounts) && this->Colors->GetContext() == window)
  {
    return;
  }
  this->ReleaseGraphicsResources(window);
  this->Bytes.Set(GetBytesPerRay(hasCounts) * size[0] * size[1]);
  for (vtkTextureObject* texture : { this->Colors.Get(), this->Counts.Get() })
  {
    texture->SetContext(window);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
    texture->SetMinificationFilter(vtkTextureObject::Linear);
    texture->SetMagnificationFilter(vtkTextureObject::Linear);
  }
  this->Colors->SetInternalFormat(GL_RGBA16F);
  this->Colors->Allocate2D(size[0], size[1], 4, VTK_FLOAT);
  if (hasCounts)
  {
    this->Counts->SetInternalFormat(GL_RG32F);
    this->Counts->Allocate2D(size[0], size[1], 2, VTK_FLOAT);
  }
}

void vtkOpenGLFlatBlockRayImage::DrawInto(
  vtkRenderer* renderer, const Content& content, const std::function<void()>& draw)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const auto size = GetSize(renderer, content.PixelsPerRay);
  this->Allocate(window, size, content.HasCounts);
  const FormerTarget target(window->GetState());
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Clear(window->GetState(), size, content.HasCounts);
  draw();
  this->RayCounts = {};
  if (content.KeepsImages)
  {
    this->KeepImages();
  }
  else if (content.HasCounts)
  {
    this->CountRays();
  }
}

void vtkOpenGLFlatBlockRayImage::Clear(
  vtkOpenGLState* state, const std::array<int, 2>& size, bool hasCounts)
{
  this->Framebuffer->AddColorAttachment(0, this->Colors);
  if (hasCounts)
  {
    this->Framebuffer->AddColorAttachment(1, this->Counts);
  }
  this->Framebuffer->ActivateDrawBuffers(hasCounts ? 2 : 1);
  state->vtkglViewport(0, 0, size[0], size[1]);
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
}

void vtkOpenGLFlatBlockRayImage::CountRays()
{
  const auto width = static_cast<int>(this->Counts->GetWidth());
  const auto height = static_cast<int>(this->Counts->GetHeight());
  std::vector<float> counts(2 * static_cast<std::size_t>(width) * height);
  this->Framebuffer->ActivateReadBuffer(1);
  glReadPixels(0, 0, width, height, GL_RG, GL_FLOAT, counts.data());
  for (std::size_t i = 0; i < counts.size(); i += 2)
  {
    this->RayCounts.Rays += counts[i + 1] > 0.0F ? 1 : 0;
    this->RayCounts.CutOff += counts[i] < 0.0F ? 1 : 0;
    this->RayCounts.Samples += std::abs(static_cast<double>(counts[i]));
    this->RayCounts.Fetches += counts[i + 1];
  }
}

void vtkOpenGLFlatBlockRayImage::KeepImages()
{
  const auto width = static_cast<int>(this->Colors->GetWidth());
  const auto height = static_cast<int>(this->Colors->GetHeight());
  this->ColorImage->SetDimensions(width, height, 1);
  this->ColorImage->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  this->DepthImage->SetDimensions(width, height, 1);
  this->DepthImage->AllocateScalars(VTK_FLOAT, 1);
  auto* colors = static_cast<unsigned char*>(this->ColorImage->GetScalarPointer());
  auto* depths = static_cast<float*>(this->DepthImage->GetScalarPointer());
  this->Framebuffer->ActivateReadBuffer(0);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, colors);
  this->Framebuffer->ActivateReadBuffer(1);
  glReadPixels(0, 0, width, height, GL_RED, GL_FLOAT, depths);
  // Where no ray was, nothing was written.
  std::replace(depths, depths + static_cast<std::ptrdiff_t>(width) * height, 0.0F, 1.0F);
}

void vtkOpenGLFlatBlockRayImage::GetImages(vtkImageData* color, vtkImageData* depth) const
{
  if (color)
  {
    color->DeepCopy(this->ColorImage);
  }
  if (depth)
  {
    depth->DeepCopy(this->DepthImage);
  }
}

void vtkOpenGLFlatBlockRayImage::Activate(vtkShaderProgram* program)
{
  this->Colors->Activate();
  program->SetUniformi("in_CoarseRays", this->Colors->GetTextureUnit());
}

void vtkOpenGLFlatBlockRayImage::Deactivate()
{
  this->Colors->Deactivate();
}

bool vtkOpenGLFlatBlockRayImage::Draw(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    FlatBlockRayImageVertexGLSL, FlatBlockRayImageFragmentGLSL, "");
  if (!program)
  {
    return false;
  }
  const ViewportBox viewport(renderer);
  const float size[2] = { static_cast<float>(viewport.Size[0]),
    static_cast<float>(viewport.Size[1]) };
  this->Colors->Activate();
  program->SetUniformi("in_RayImage", this->Colors->GetTextureUnit());
  program->SetUniform2i("in_ViewportOrigin", viewport.Origin);
  program->SetUniform2f("in_ViewportSize", size);
  const double raysPerPixel = this->Colors->GetWidth() / static_cast<double>(viewport.Size[0]);
  program->SetUniformi("in_Taps", std::max(1, static_cast<int>(std::lround(0.5 * raysPerPixel))));
  vtkNew<vtkOpenGLVertexArrayObject> empty;
  empty->Bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  empty->Release();
  this->Colors->Deactivate();
  return true;
}

void vtkOpenGLFlatBlockRayImage::ReleaseIfStale(
  vtkRenderer* renderer, double pixelsPerRay, bool hasCounts)
{
  if (this->Bytes.Get() > 0 && !this->HasSize(GetSize(renderer, pixelsPerRay), hasCounts))
  {
    this->ReleaseGraphicsResources(renderer->GetRenderWindow());
  }
}

void vtkOpenGLFlatBlockRayImage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Colors->ReleaseGraphicsResources(window);
  this->Counts->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Bytes.Set(0);
}

void vtkOpenGLFlatBlockRayImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bytes: " << this->Bytes.Get() << "\n";
  os << indent << "RaysCutOff: " << this->RayCounts.CutOff << "\n";
}
