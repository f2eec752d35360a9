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
#include <string>

vtkStandardNewMacro(vtkOpenGLFlatBlockRayCaster);

namespace
{
constexpr int CubeStripVertices = 14;
constexpr float EnoughOpacity = 1.0F - 1.0F / 255.0F;

// VTK's key matrices are transposed; from here on they are not.
void GetCameraMatrices(vtkRenderer* renderer, vtkMatrix4x4* worldToView, vtkMatrix4x4* worldToClip)
{
  vtkMatrix4x4* view;
  vtkMatrix3x3* normal;
  vtkMatrix4x4* projection;
  vtkMatrix4x4* clip;
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  camera->GetKeyMatrices(renderer, view, normal, projection, clip);
  vtkMatrix4x4::Transpose(view, worldToView);
  vtkMatrix4x4::Transpose(clip, worldToClip);
}

// Perspective: (-eye, 1); parallel: (direction of sight, 0); in samples.
std::array<float, 4> GetEye(vtkMatrix4x4* sampleToView, bool parallel)
{
  vtkNew<vtkMatrix4x4> viewToSample;
  vtkMatrix4x4::Invert(sampleToView, viewToSample);
  const double eyeInView[4] = { 0.0, 0.0, parallel ? -1.0 : 0.0, parallel ? 0.0 : 1.0 };
  double eye[4];
  viewToSample->MultiplyPoint(eyeInView, eye);
  const double sign = parallel ? 1.0 : -1.0 / eye[3];
  return { static_cast<float>(sign * eye[0]), static_cast<float>(sign * eye[1]),
    static_cast<float>(sign * eye[2]), parallel ? 0.0F : 1.0F };
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

void SetDirections(vtkShaderProgram* program, const char* name, vtkMatrix4x4* matrix)
{
  float columns[9];
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(matrix->GetElement(i % 3, i / 3));
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
  if (!this->ReadyProgram(window))
  {
    return false;
  }
  this->SetGeometry(renderer, scene);
  this->SetBlocks(scene);
  this->SetClassification(scene);

  vtkNew<vtkMatrix4x4> sampleToWorld;
  vtkMatrix4x4::Multiply4x4(scene.DataSetToWorld, scene.SampleToDataSet, sampleToWorld);
  this->DrawBox(window, sampleToWorld->Determinant() < 0.0);

  for (vtkTextureObject* texture : { scene.Atlas->GetBricks(), scene.Atlas->GetBlockIndex(),
         this->TransferTexture.Get(), this->SceneDepth->GetTexture() })
  {
    texture->Deactivate();
  }
  return true;
}

bool vtkOpenGLFlatBlockRayCaster::ReadyProgram(vtkOpenGLRenderWindow* window)
{
  if (!this->Box.Program)
  {
    std::string fragment = FlatBlockRayCasterFragmentGLSL;
    vtkShaderProgram::Substitute(fragment, "//FlatBlock::Ray", FlatBlockRayGLSL);
    vtkShaderProgram::Substitute(fragment, "//FlatBlock::Blocks", FlatBlockBlocksGLSL);
    this->Box.Program = window->GetShaderCache()->ReadyShaderProgram(
      FlatBlockRayCasterVertexGLSL, fragment.c_str(), "");
    this->Box.VAO->ShaderProgramChanged();
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Box.Program);
  }
  return this->Box.Program != nullptr;
}

void vtkOpenGLFlatBlockRayCaster::SetGeometry(vtkRenderer* renderer, const Scene& scene)
{
  vtkNew<vtkMatrix4x4> worldToView;
  vtkNew<vtkMatrix4x4> worldToClip;
  GetCameraMatrices(renderer, worldToView, worldToClip);
  vtkNew<vtkMatrix4x4> sampleToWorld;
  vtkNew<vtkMatrix4x4> sampleToView;
  vtkNew<vtkMatrix4x4> sampleToClip;
  vtkMatrix4x4::Multiply4x4(scene.DataSetToWorld, scene.SampleToDataSet, sampleToWorld);
  vtkMatrix4x4::Multiply4x4(worldToView, sampleToWorld, sampleToView);
  vtkMatrix4x4::Multiply4x4(worldToClip, sampleToWorld, sampleToClip);

  vtkShaderProgram* program = this->Box.Program;
  const bool parallel = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  program->SetUniform4f("in_Eye", GetEye(sampleToView, parallel).data());
  const auto lastSample = ToFloats(scene.Source->GetGrid().GetSamples(), -1);
  program->SetUniform3f("in_LastSample", lastSample.data());
  SetDirections(program, "in_SampleToDataSet", scene.SampleToDataSet);
  SetRow(program, "in_SampleToClipZ", sampleToClip, 2);
  SetRow(program, "in_SampleToClipW", sampleToClip, 3);
  sampleToClip->Transpose();
  program->SetUniformMatrix("in_SampleToClip", sampleToClip);

  this->SceneDepth->GetTexture()->Activate();
  program->SetUniformi("in_SceneDepth", this->SceneDepth->GetTexture()->GetTextureUnit());
  program->SetUniform2i("in_ViewportOrigin", this->SceneDepth->GetOrigin());
}

void vtkOpenGLFlatBlockRayCaster::SetBlocks(const Scene& scene)
{
  vtkShaderProgram* program = this->Box.Program;
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
void vtkOpenGLFlatBlockRayCaster::SetClassification(const Scene& scene)
{
  vtkShaderProgram* program = this->Box.Program;
  const flatblock::TexelEncoding& encoding = scene.Source->GetEncoding();
  const double entries = this->TransferTexture->GetWidth();
  const double span = this->TableHighest - this->TableLowest;
  const double valueToTable = span > 0.0 ? (entries - 1.0) / entries / span : 0.0;
  const float texelToTable[2] = { static_cast<float>(encoding.Scale * valueToTable),
    static_cast<float>((encoding.Offset - this->TableLowest) * valueToTable + 0.5 / entries) };
  this->TransferTexture->Activate();
  program->SetUniformi("in_TransferTable", this->TransferTexture->GetTextureUnit());
  program->SetUniform2f("in_TexelToTable", texelToTable);
  program->SetUniformf("in_Step", static_cast<float>(scene.Step));
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

  this->Box.VAO->Bind();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, CubeStripVertices);
  this->Box.VAO->Release();

  if (!clampedBefore)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  state->vtkglCullFace(culledBefore);
}

void vtkOpenGLFlatBlockRayCaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Box.ReleaseGraphicsResources(window);
  this->TransferTexture->ReleaseGraphicsResources(window);
  this->SceneDepth->ReleaseGraphicsResources(window);
}

void vtkOpenGLFlatBlockRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TransferTable range: " << this->TableLowest << " " << this->TableHighest << "\n";
}
