#include "FloatPicture.h"

#include "ReferenceShading.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatblock::testing
{
namespace
{
// As vtkFlatBlockVolumeMapper has it: of what is opaque, over the smallest spacing.
constexpr double MostExtinction = 256.0;

vtkOpenGLRenderWindow* AsOpenGL(vtkRenderWindow* window)
{
  return vtkOpenGLRenderWindow::SafeDownCast(window);
}

double GetSmallestSpacing(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
}

std::array<double, 2> GetFiniteRange(const std::vector<double>& values)
{
  std::array<double, 2> range = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (double value : values)
  {
    if (std::isfinite(value))
    {
      range = { std::min(range[0], value), std::max(range[1], value) };
    }
  }
  return range[0] <= range[1] ? range : std::array<double, 2>{ 0.0, 0.0 };
}

// The functions themselves, so finely that a ray caster's own table does not matter.
ReferenceTable SampleProperty(
  vtkVolumeProperty* property, const std::array<double, 2>& range, double smallestSpacing)
{
  const double span = range[1] - range[0];
  int entries = span > 0.0 ? 65536 + 1 : 2;
  if (span > 0.0 && span == std::floor(span) && span <= 65536.0)
  {
    const int steps = static_cast<int>(span);
    entries = 65536 / steps * steps + 1;
  }
  std::vector<double> colors(3 * entries);
  std::vector<double> opacities(entries);
  // Not by GetTable(), which leaves an entry that falls on the first node black.
  for (int i = 0; i < entries; ++i)
  {
    property->GetRGBTransferFunction()->GetColor(
      range[0] + i * span / (entries - 1), colors.data() + 3 * static_cast<std::size_t>(i));
  }
  property->GetScalarOpacity()->GetTable(range[0], range[1], entries, opacities.data());
  ReferenceTable table;
  table.Lowest = range[0];
  table.Highest = span > 0.0 ? range[1] : range[0] + 1.0 + std::abs(range[0]);
  table.Entries.resize(entries);
  for (int i = 0; i < entries; ++i)
  {
    const double opacity = std::clamp(opacities[i], 0.0, 1.0);
    table.Entries[i] = { colors[3 * i], colors[3 * i + 1], colors[3 * i + 2],
      std::min(-std::log1p(-opacity) / property->GetScalarOpacityUnitDistance(),
        MostExtinction / smallestSpacing) };
  }
  return table;
}

} // namespace

FloatFramebuffer::FloatFramebuffer(vtkRenderWindow* window, int width, int height)
  : Width(width), Height(height)
{
  vtkOpenGLRenderWindow* context = AsOpenGL(window);
  context->MakeCurrent();
  vtkOpenGLState* state = context->GetState();
  this->Color->SetContext(context);
  this->Color->Allocate2D(width, height, 4, VTK_FLOAT);
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(context);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->AddDepthAttachment();
  this->Framebuffer->ActivateDrawBuffer(0);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  state->vtkglClearDepth(1.0);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

FloatFramebuffer::~FloatFramebuffer()
{
  this->Framebuffer->GetContext()->GetState()->PopFramebufferBindings();
}

Picture FloatFramebuffer::Read()
{
  std::vector<float> floats(4 * static_cast<std::size_t>(this->Width) * this->Height);
  this->Framebuffer->ActivateReadBuffer(0);
  glReadPixels(0, 0, this->Width, this->Height, GL_RGBA, GL_FLOAT, floats.data());
  Picture picture(floats.size() / 4);
  for (std::size_t i = 0; i < floats.size(); ++i)
  {
    picture[i / 4][i % 4] = floats[i];
  }
  return picture;
}

Picture DrawFloats(Scene& scene)
{
  const int* size = scene.Window->GetSize();
  if (scene.Window->GetNeverRendered())
  {
    scene.Window->Render();
  }
  FloatFramebuffer framebuffer(scene.Window, size[0], size[1]);
  scene.Volume->GetMapper()->Update();
  scene.Mapper->Render(scene.Renderer, scene.Volume);
  return framebuffer.Read();
}

ReferenceVolume ReadReferenceVolume(Scene& scene)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetInputDataObject(0, 0));
  ReferenceVolume volume;
  image->GetDimensions(volume.Samples.data());
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  volume.Values.resize(scalars->GetNumberOfTuples());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    volume.Values[i] = scalars->GetComponent(i, 0);
  }
  return volume;
}

ReferenceView GetReferenceView(Scene& scene)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetInputDataObject(0, 0));
  vtkNew<vtkMatrix4x4> sampleToDataSet;
  sampleToDataSet->DeepCopy(image->GetIndexToPhysicalMatrix());
  const int* extent = image->GetExtent();
  const double first[4] = { double(extent[0]), double(extent[2]), double(extent[4]), 1.0 };
  double origin[4];
  sampleToDataSet->MultiplyPoint(first, origin);
  vtkNew<vtkMatrix4x4> matrix;
  scene.Volume->GetMatrix(matrix);
  ReferenceView view;
  view.Width = scene.Window->GetSize()[0];
  view.Height = scene.Window->GetSize()[1];
  for (int i = 0; i < 3; ++i)
  {
    sampleToDataSet->SetElement(i, 3, origin[i]);
    for (int j = 0; j < 3; ++j)
    {
      view.SampleToLength[3 * i + j] = sampleToDataSet->GetElement(i, j);
    }
  }
  vtkMatrix4x4::Multiply4x4(matrix, sampleToDataSet, matrix);
  vtkMatrix4x4* worldToClip =
    scene.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      scene.Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  vtkMatrix4x4::Multiply4x4(worldToClip, matrix, matrix);
  std::copy_n(&matrix->Element[0][0], 16, view.SampleToClip.begin());
  return view;
}

Picture DrawReference(Scene& scene, int stride, ReferenceFilter filter)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetInputDataObject(0, 0));
  ReferenceVolume volume = ReadReferenceVolume(scene);
  const ReferenceTable table =
    SampleProperty(scene.Property, GetFiniteRange(volume.Values), GetSmallestSpacing(image));
  const ReferenceView view = GetReferenceView(scene);
  vtkVolumeProperty* property = scene.Property;
  if (property->GetShade() != 0)
  {
    const ReferenceMaterial material = { property->GetAmbient(), property->GetDiffuse(),
      property->GetSpecular(), property->GetSpecularPower() };
    return ReferenceShading(std::move(volume), table, material).Render(view, stride);
  }
  return ReferenceRayCaster(std::move(volume), table, filter).Render(view, stride);
}

Picture TakeEvery(const Picture& picture, int width, int stride)
{
  Picture taken;
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    if (i % width % stride == 0 && i / width % stride == 0)
    {
      taken.push_back(picture[i]);
    }
  }
  return taken;
}

bool IsSound(const Picture& picture)
{
  return std::all_of(picture.begin(), picture.end(),
    [](const auto& pixel)
    {
      return std::all_of(pixel.begin(), pixel.end(),
        [](double channel) { return channel >= -1e-4 && channel <= 1.0 + 1e-4; });
    });
}
} // namespace flatblock::testing
