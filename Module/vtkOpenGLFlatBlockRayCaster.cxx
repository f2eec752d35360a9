#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockRayCaster.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLFlatBlockAtlas.h"
#include "vtkOpenGLFlatBlockSceneDepth.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include "FlatBlockBlocksGLSL.h"
#include "FlatBlockRayCasterFragmentGLSL.h"
#include "FlatBlockRayCasterVertexGLSL.h"
#include "FlatBlockRayGLSL.h"

#include <array>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkOpenGLFlatBlockRayCaster);

namespace
{
constexpr int CubeStripVertices = 14;
constexpr float EnoughOpacity = 1.0F - 1.0F / 255.0F;

// VTK's key matrices are transposed; from here on they are not.
void GetSampleToClip(vtkRenderer* renderer, vtkMatrix4x4* sampleToWorld, vtkMatrix4x4* sampleToClip)
{
  vtkMatrix4x4* view;
  vtkMatrix3x3* normal;
  vtkMatrix4x4* projection;
  vtkMatrix4x4* clip;
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  camera->GetKeyMatrices(renderer, view, normal, projection, clip);
  vtkNew<vtkMatrix4x4> worldToClip;
  vtkMatrix4x4::Transpose(clip, worldToClip);
  vtkMatrix4x4::Multiply4x4(worldToClip, sampleToWorld, sampleToClip);
}

// Perspective: (-eye, 1); parallel: (direction of sight, 0); in samples. The eye is where x, y and
// w of clip coordinates vanish: so stereo and sheared projections are right, too.
std::array<float, 4> GetEye(vtkMatrix4x4* sampleToClip, bool parallel)
{
  vtkNew<vtkMatrix4x4> clipToSample;
  vtkMatrix4x4::Invert(sampleToClip, clipToSample);
  const double eyeInClip[4] = { 0.0, 0.0, -1.0, 0.0 };
  double eye[4];
  clipToSample->MultiplyPoint(eyeInClip, eye);
  double length = eye[3];
  if (parallel)
  {
    length = std::hypot(eye[0], eye[1], eye[2]);
  }
  return { static_cast<float>(-eye[0] / length), static_cast<float>(-eye[1] / length),
    static_cast<float>(-eye[2] / length), parallel ? 0.0F : 1.0F };
}

// The window's cache of shaders compiles it once; nothing here outlives the window.
vtkShaderProgram* ReadyProgram(vtkOpenGLRenderWindow* window)
{
  std::string fragment = FlatBlockRayCasterFragmentGLSL;
  vtkShaderProgram::Substitute(fragment, "//FlatBlock::Ray", FlatBlockRayGLSL);
  vtkShaderProgram::Substitute(fragment, "//FlatBlock::Blocks", FlatBlockBlocksGLSL);
  return window->GetShaderCache()->ReadyShaderProgram(
    FlatBlockRayCasterVertexGLSL, fragment.c_str(), "");
}

void SetRow(vtkShaderProgram* program, const char* name, vtkMatrix4x4* matrix, int row)
{
  float values[4];
  for (int i = 0; i < 4; ++i)
  {
    values[i] = static_cast<float>(matrix->GetElement(row, i));
  }
  program->SetUniform4f(name, values);
}

void SetDirections(
  vtkShaderProgram* program, const char* name, vtkMatrix4x4* matrix, double unitOfLength)
{
  float columns[9];
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(matrix->GetElement(i % 3, i / 3) / unitOfLength);
  }
  program->SetUniformMatrix3x3(name, columns);
}

std::array<float, 3> ToFloats(const flatblock::Index3& index, int offset)
{
  return { static_cast<float>(index[0] + offset), static_cast<float>(index[1] + offset),
    static_cast<float>(index[2] + offset) };
}
} // namespace

vtkOpenGLFlatBlockRayCaster::vtkOpenGLFlatBlockRayCaster() = default;
vtkOpenGLFlatBlockRayCaster::~vtkOpenGLFlatBlockRayCaster() = default;

void vtkOpenGLFlatBlockRayCaster::SetMemoryCounter(flatblock::MemoryCounter* counter)
{
  this->TableBytes.SetCounter(counter);
  this->SceneDepth->SetMemoryCounter(counter);
}

void vtkOpenGLFlatBlockRayCaster::ReleaseStale(
  vtkRenderer* renderer, const flatblock::TransferTable& table)
{
  this->SceneDepth->ReleaseIfStale(renderer);
  if (this->TransferTexture->GetWidth() != table.GetEntries().size())
  {
    this->TransferTexture->ReleaseGraphicsResources(renderer->GetRenderWindow());
    this->TableBytes.Set(0);
  }
}

void vtkOpenGLFlatBlockRayCaster::SetTransferTable(
  vtkOpenGLRenderWindow* window, const flatblock::TransferTable& table)
{
  static_assert(sizeof(flatblock::TransferTable::Entry) == 4 * sizeof(float));
  const auto& entries = table.GetEntries();
  this->TransferTexture->SetContext(window);
  this->TransferTexture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->TransferTexture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->TransferTexture->SetMinificationFilter(vtkTextureObject::Linear);
  this->TransferTexture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->TransferTexture->Create2DFromRaw(static_cast<unsigned int>(entries.size()), 1, 4, VTK_FLOAT,
    const_cast<flatblock::TransferTable::Entry*>(entries.data()));
  this->TableBytes.Set(static_cast<std::int64_t>(entries.size() * sizeof(entries[0])));
  this->TableLowest = table.GetLowest();
  this->TableHighest = table.GetHighest();
}

bool vtkOpenGLFlatBlockRayCaster::HasTransferTable() const
{
  return this->TransferTexture->GetHandle() != 0;
}

bool vtkOpenGLFlatBlockRayCaster::Draw(vtkRenderer* renderer, const Scene& scene)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->SceneDepth->Capture(renderer);
  vtkShaderProgram* program = ReadyProgram(window);
  if (!program)
  {
    return false;
  }
  vtkNew<vtkMatrix4x4> sampleToWorld;
  vtkNew<vtkMatrix4x4> sampleToClip;
  vtkMatrix4x4::Multiply4x4(scene.DataSetToWorld, scene.SampleToDataSet, sampleToWorld);
  GetSampleToClip(renderer, sampleToWorld, sampleToClip);
  const bool parallel = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  program->SetUniform4f("in_Eye", GetEye(sampleToClip, parallel).data());
  this->SetGeometry(program, scene, sampleToClip);
  this->SetBlocks(program, scene);
  this->SetClassification(program, scene);

  // A projection to clip coordinates turns space over once.
  this->DrawBox(window, sampleToClip->Determinant() > 0.0);

  for (vtkTextureObject* texture : { scene.Atlas->GetBricks(), scene.Atlas->GetBlockIndex(),
         this->TransferTexture.Get(), this->SceneDepth->GetTexture() })
  {
    texture->Deactivate();
  }
  return true;
}

void vtkOpenGLFlatBlockRayCaster::SetGeometry(
  vtkShaderProgram* program, const Scene& scene, vtkMatrix4x4* sampleToClip)
{
  const auto lastSample = ToFloats(scene.Source->GetGrid().GetSamples(), -1);
  program->SetUniform3f("in_LastSample", lastSample.data());
  SetDirections(program, "in_SampleToSteps", scene.SampleToDataSet, scene.Step);
  SetRow(program, "in_SampleToClipZ", sampleToClip, 2);
  SetRow(program, "in_SampleToClipW", sampleToClip, 3);
  vtkNew<vtkMatrix4x4> columns;
  vtkMatrix4x4::Transpose(sampleToClip, columns);
  program->SetUniformMatrix("in_SampleToClip", columns);

  this->SceneDepth->GetTexture()->Activate();
  program->SetUniformi("in_SceneDepth", this->SceneDepth->GetTexture()->GetTextureUnit());
  program->SetUniform2i("in_ViewportOrigin", this->SceneDepth->GetOrigin());
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
}

// A texel t is the value offset + scale * t, and lies in the table's texture where entry 0 has its
// centre at 0.5 / entries and the last one at 1 - 0.5 / entries.
void vtkOpenGLFlatBlockRayCaster::SetClassification(vtkShaderProgram* program, const Scene& scene)
{
  const flatblock::TexelEncoding& encoding = scene.Source->GetEncoding();
  const double entries = this->TransferTexture->GetWidth();
  const double span = this->TableHighest - this->TableLowest;
  const double valueToTable = span > 0.0 ? (entries - 1.0) / entries / span : 0.0;
  const float texelToTable[2] = { static_cast<float>(encoding.Scale * valueToTable),
    static_cast<float>((encoding.Offset - this->TableLowest) * valueToTable + 0.5 / entries) };
  this->TransferTexture->Activate();
  program->SetUniformi("in_TransferTable", this->TransferTexture->GetTextureUnit());
  program->SetUniform2f("in_TexelToTable", texelToTable);
  program->SetUniformf("in_EnoughOpacity", EnoughOpacity);
}

// Only the faces where rays leave the box are drawn, so that the eye may be inside. They are not
// cut at the clipping planes of the camera: the shader does that along the ray.
void vtkOpenGLFlatBlockRayCaster::DrawBox(vtkOpenGLRenderWindow* window, bool mirrored)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  int culledBefore = 0;
  glGetIntegerv(GL_CULL_FACE_MODE, &culledBefore);

  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(mirrored ? GL_BACK : GL_FRONT);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const bool clampedBefore = glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE;
  glEnable(GL_DEPTH_CLAMP);

  // Without an array in it: made for this frame, so that no window has to take care of it.
  vtkNew<vtkOpenGLVertexArrayObject> empty;
  empty->Bind();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, CubeStripVertices);
  empty->Release();

  if (!clampedBefore)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  state->vtkglCullFace(culledBefore);
}

void vtkOpenGLFlatBlockRayCaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->TransferTexture->ReleaseGraphicsResources(window);
  this->TableBytes.Set(0);
  this->SceneDepth->ReleaseGraphicsResources(window);
}

void vtkOpenGLFlatBlockRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TransferTable range: " << this->TableLowest << " " << this->TableHighest << "\n";
}
