#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockRayCaster.h"

#include "FlatBlockBlending.h"
#include "FlatBlockClipping.h"
#include "FlatBlockCurvature.h"
#include "FlatBlockLighting.h"
#include "FlatBlockRayCasterProgram.h"
#include "FlatBlockRayGeometry.h"
#include "FlatBlockScattering.h"
#include "RaySight.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFlatBlockAtlas.h"
#include "vtkOpenGLFlatBlockRayImage.h"
#include "vtkOpenGLFlatBlockSceneDepth.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <cmath>

vtkStandardNewMacro(vtkOpenGLFlatBlockRayCaster);

namespace
{
constexpr int CubeStripVertices = 14;
} // namespace

vtkOpenGLFlatBlockRayCaster::vtkOpenGLFlatBlockRayCaster() = default;
vtkOpenGLFlatBlockRayCaster::~vtkOpenGLFlatBlockRayCaster() = default;

void vtkOpenGLFlatBlockRayCaster::SetMemoryCounter(flatblock::MemoryCounter* counter)
{
  this->Lookups.SetMemoryCounter(counter);
  this->SceneDepth->SetMemoryCounter(counter);
  this->RayImage->SetMemoryCounter(counter);
}

vtkTypeInt64 vtkOpenGLFlatBlockRayCaster::GetImageBytes(
  vtkRenderer* renderer, const flatblock::RaySampling& sampling)
{
  return sampling.HasImage() ? vtkOpenGLFlatBlockRayImage::GetBytes(
                                 renderer, sampling.GetPixelsOfImage(), sampling.HasTwoImages())
                             : 0;
}

void vtkOpenGLFlatBlockRayCaster::ReleaseStale(vtkRenderer* renderer,
  const flatblock::ComponentTables& tables, const flatblock::LookupBytes& bytes,
  const flatblock::RaySampling& sampling)
{
  this->SceneDepth->ReleaseIfStale(renderer);
  this->Lookups.ReleaseStale(renderer->GetRenderWindow(), tables, bytes, sampling);
  if (sampling.HasImage())
  {
    this->RayImage->ReleaseIfStale(renderer, sampling.GetPixelsOfImage(), sampling.HasTwoImages());
  }
  else
  {
    this->RayImage->ReleaseGraphicsResources(renderer->GetRenderWindow());
  }
}

void vtkOpenGLFlatBlockRayCaster::GetImages(vtkImageData* color, vtkImageData* depth) const
{
  this->RayImage->GetImages(color, depth);
}

void vtkOpenGLFlatBlockRayCaster::Finish()
{
  glFinish();
}

const flatblock::RayCounts& vtkOpenGLFlatBlockRayCaster::GetCounts() const
{
  return this->RayImage->GetCounts();
}

bool vtkOpenGLFlatBlockRayCaster::Draw(vtkRenderer* renderer, const Scene& scene)
{
  this->SceneDepth->Capture(renderer);
  if (scene.Sampling.RefinesImage)
  {
    Scene coarse = scene;
    coarse.Sampling.PixelsPerRay = flatblock::RaySampling::CoarsePixelsPerRay;
    coarse.Sampling.RefinesImage = false;
    coarse.IsOnlyImage = true;
    if (!this->Cast(renderer, coarse))
    {
      return false;
    }
  }
  return this->Cast(renderer, scene);
}

bool vtkOpenGLFlatBlockRayCaster::Cast(vtkRenderer* renderer, const Scene& scene)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkShaderProgram* program = flatblock::ReadyRayCaster(window, scene.Sampling, scene.Clipping,
    scene.HasHoles, this->Lookups.NeedsLongSums(scene.Sampling));
  if (!program)
  {
    return false;
  }
  vtkNew<vtkMatrix4x4> sampleToWorld;
  vtkNew<vtkMatrix4x4> sampleToClip;
  vtkMatrix4x4::Multiply4x4(scene.DataSetToWorld, scene.SampleToDataSet, sampleToWorld);
  flatblock::GetSampleToClip(renderer, sampleToWorld, sampleToClip);
  flatblock::SetRayGeometry(renderer, program,
    { scene.Source->GetGrid().GetSamples(), scene.SampleToDataSet, sampleToClip,
      scene.Sampling.Step });
  this->SetRays(renderer, program, scene);
  this->SetBlocks(program, scene);
  flatblock::SetClipping(program, scene.Clipping);
  flatblock::SetBlending(program, scene.Sampling, scene.Clipping, scene.Tables);
  this->Lookups.Activate(program, scene.Tables, scene.Sampling);
  if (scene.Sampling.RayStart > 0.0 || scene.Sampling.NeedsGradients())
  {
    flatblock::SetDirections(program, "in_SampleToWorld", sampleToWorld, 1.0);
  }
  if (scene.Selection)
  {
    flatblock::SetSelection(program, *scene.Selection);
  }
  if (scene.Sampling.Components > 1)
  {
    flatblock::SetComponents(program, scene.Sampling, scene.Tables, scene.Mask);
  }
  if (scene.Sampling.HasScattering())
  {
    flatblock::SetScattering(
      program, sampleToWorld, scene.SampleToDataSet, scene.Sampling, scene.Tables);
  }
  if (scene.Sampling.IsCurved())
  {
    flatblock::SetCurvature(
      program, scene.SampleToDataSet, scene.Sampling, scene.Tables.front().Encoding);
  }
  if (scene.Sampling.IsShaded)
  {
    flatblock::SetLighting(renderer, program, scene.Material, sampleToWorld);
  }

  Cover cover = Cover::Box;
  if (flatblock::IsBoxInexactOnScreen(
        sampleToClip->GetData(), scene.Source->GetGrid().GetSamples()))
  {
    cover = Cover::Viewport;
  }
  else if (sampleToClip->Determinant() > 0.0)
  {
    cover = Cover::MirroredBox; // a projection to clip coordinates turns space over once
  }
  program->SetUniformi("in_CoversViewport", cover == Cover::Viewport ? 1 : 0);
  const bool isDrawn = this->DrawRays(renderer, scene, cover);

  for (vtkTextureObject* texture :
    { scene.Atlas->GetBricks(), scene.Atlas->GetBlockIndex(), this->SceneDepth->GetTexture() })
  {
    texture->Deactivate();
  }
  if (scene.Sampling.RefinesImage)
  {
    this->RayImage->Deactivate();
  }
  this->Lookups.Deactivate();
  return isDrawn;
}

void vtkOpenGLFlatBlockRayCaster::SetRays(
  vtkRenderer* renderer, vtkShaderProgram* program, const Scene& scene)
{
  const flatblock::RaySampling& sampling = scene.Sampling;
  const int imageOrigin[2] = { 0, 0 };
  vtkTextureObject* depth = this->SceneDepth->GetTexture();
  const float size[2] = { static_cast<float>(depth->GetWidth()),
    static_cast<float>(depth->GetHeight()) };
  float pixelsPerRay[2] = { 1.0F, 1.0F };
  const bool isToImage = sampling.HasImage() && !sampling.RefinesImage;
  if (isToImage)
  {
    const auto rays = vtkOpenGLFlatBlockRayImage::GetSize(renderer, sampling.PixelsPerRay);
    pixelsPerRay[0] = size[0] / static_cast<float>(rays[0]);
    pixelsPerRay[1] = size[1] / static_cast<float>(rays[1]);
  }
  program->SetUniform2f("in_ViewportSize", size);
  this->SceneDepth->GetTexture()->Activate();
  program->SetUniformi("in_SceneDepth", this->SceneDepth->GetTexture()->GetTextureUnit());
  program->SetUniform2i(
    "in_ViewportOrigin", isToImage ? imageOrigin : this->SceneDepth->GetOrigin());
  program->SetUniform2f("in_PixelsPerRay", pixelsPerRay);
  program->SetUniformf("in_StepLength", static_cast<float>(sampling.Step / sampling.UnitOfLength));
  program->SetUniformf("in_AdaptiveSampling", sampling.Adaptive ? 1.0F : 0.0F);
  if (sampling.RefinesImage)
  {
    this->RayImage->Activate(program);
    program->SetUniformf("in_ImageTolerance", static_cast<float>(sampling.ImageTolerance));
  }
  if (sampling.IsShaded)
  {
    program->SetUniformf(
      "in_ShadingOpacityThreshold", static_cast<float>(sampling.ShadingThreshold));
  }
  if (sampling.MostSamples > 0)
  {
    program->SetUniformi("in_MaximumNumberOfSamples", sampling.MostSamples);
  }
  if (sampling.RayStart > 0.0)
  {
    program->SetUniformf("in_RayStart", static_cast<float>(sampling.RayStart));
  }
}

void vtkOpenGLFlatBlockRayCaster::SetBlocks(vtkShaderProgram* program, const Scene& scene)
{
  const flatblock::BlockGrid& grid = scene.Source->GetGrid();
  vtkTextureObject* bricks = scene.Atlas->GetBricks();
  const int filter =
    scene.LinearInterpolation ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  bricks->SetMinificationFilter(filter);
  bricks->SetMagnificationFilter(filter);
  bricks->Activate();
  scene.Atlas->GetBlockIndex()->Activate();
  program->SetUniformi("in_Atlas", bricks->GetTextureUnit());
  program->SetUniformi("in_BlockIndex", scene.Atlas->GetBlockIndex()->GetTextureUnit());
  const float texel[3] = { 1.0F / static_cast<float>(bricks->GetWidth()),
    1.0F / static_cast<float>(bricks->GetHeight()), 1.0F / static_cast<float>(bricks->GetDepth()) };
  program->SetUniform3f("in_AtlasTexel", texel);
  program->SetUniformi("in_CellsPerBlock", grid.GetCellsPerBlock());
  program->SetUniform1iv("in_Blocks", 3, grid.GetBlocks().data());
  if (scene.Sampling.NeedsMagnitudes())
  {
    flatblock::SetGradientScale(program, scene.SampleToDataSet, scene.Tables, scene.Sampling);
  }
  if (scene.Sampling.CellsPerCube > 0)
  {
    program->SetUniformi("in_CubesPerBlock",
      static_cast<int>(std::lround(
        std::log2(grid.GetCellsPerBlock() / static_cast<double>(scene.Sampling.CellsPerCube)))));
  }
}

// Into an image of their own, or the window itself. OpenGL's state is put back in the end.
bool vtkOpenGLFlatBlockRayCaster::DrawRays(vtkRenderer* renderer, const Scene& scene, Cover cover)
{
  vtkOpenGLState* state =
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (!scene.Sampling.HasImage() || scene.Sampling.RefinesImage)
  {
    state->SetEnumState(GL_BLEND, !scene.Selection);
    this->DrawCover(state, cover);
    return true;
  }
  this->RayImage->DrawInto(renderer,
    { scene.Sampling.PixelsPerRay, scene.Sampling.HasTwoImages(), scene.Sampling.StaysInImage },
    [&]
    {
      vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
      state->vtkglDisable(GL_SCISSOR_TEST);
      state->vtkglDisable(GL_BLEND);
      this->DrawCover(state, cover);
    });
  if (scene.IsOnlyImage || scene.Sampling.StaysInImage)
  {
    return true;
  }
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  return this->RayImage->Draw(renderer);
}

// Of a box only the faces where rays leave it are drawn. They are not cut at the clipping planes of
// the camera: the shader does that along the ray.
void vtkOpenGLFlatBlockRayCaster::DrawCover(vtkOpenGLState* state, Cover cover)
{
  constexpr int ViewportVertices = 3;
  int culledBefore = 0;
  glGetIntegerv(GL_CULL_FACE_MODE, &culledBefore);
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(cover == Cover::Box ? GL_FRONT : GL_BACK);
  const bool clampedBefore = glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE;
  glEnable(GL_DEPTH_CLAMP);

  // Without an array in it: made for this frame, so that no window has to take care of it.
  vtkNew<vtkOpenGLVertexArrayObject> empty;
  empty->Bind();
  glDrawArrays(
    GL_TRIANGLE_STRIP, 0, cover == Cover::Viewport ? ViewportVertices : CubeStripVertices);
  empty->Release();

  if (!clampedBefore)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  state->vtkglCullFace(culledBefore);
}

void vtkOpenGLFlatBlockRayCaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Lookups.ReleaseGraphicsResources(window);
  this->SceneDepth->ReleaseGraphicsResources(window);
  this->RayImage->ReleaseGraphicsResources(window);
}

void vtkOpenGLFlatBlockRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Lookups.Print(os, indent);
}
