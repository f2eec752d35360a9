// Opaque geometry in all kinds of framebuffers.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

using namespace flatblock::testing;

namespace
{
vtkSmartPointer<vtkActor> Slab(double lowest, double highest)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-0.5, 0.5, -0.5, 0.5, lowest, highest);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.1, 0.9, 0.2);
  return actor;
}

void Prepare(Scene& scene)
{
  scene.SetVolume(MarschnerLobb(48), 1.0 / 47.0);
  scene.SetRamp(0.0, 255.0, 0.5);
  scene.Property->SetScalarOpacityUnitDistance(0.4);
  scene.Renderer->AddActor(Slab(-0.2, 0.3));
}
} // namespace

TEST(Geometry, MultisampledWindowsLookLikeThePeer)
{
  for (bool stencil : { false, true })
  {
    Scene scene;
    scene.Window->SetMultiSamples(4);
    scene.Window->SetStencilCapable(stencil ? 1 : 0);
    Prepare(scene);
    scene.LookFrom(30.0, 30.0);
    const auto messages = Listen(
      [&]
      {
        const auto picture = scene.Draw();
        EXPECT_TRUE(ShowsSomething(picture));
        EXPECT_GE(PSNR(picture, scene.DrawWithPeer()), 38.0) << "stencil " << stencil;

        Scene plain;
        Prepare(plain);
        plain.LookFrom(30.0, 30.0);
        EXPECT_GE(PSNR(picture, plain.Draw()), 28.0) << "stencil " << stencil;
      });
    EXPECT_TRUE(messages.Errors.empty());
  }
}

TEST(Geometry, ViewportsDoNotMixTheirDepths)
{
  Scene whole;
  whole.Window->SetSize(128, 256);
  Prepare(whole);
  whole.LookFrom(30.0, 30.0);
  const auto expected = whole.Draw();

  Scene parts;
  parts.Window->SetSize(256, 256);
  Prepare(parts);
  parts.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  other->AddActor(Slab(-1.0, 1.0));
  parts.Window->AddRenderer(other);
  parts.LookFrom(30.0, 30.0);
  parts.Draw();
  const auto both = Grab(parts.Window);
  auto right = vtkSmartPointer<vtkImageData>::New();
  right->DeepCopy(both);
  int extent[6] = { 128, 255, 0, 255, 0, 0 };
  right->Crop(extent);
  EXPECT_TRUE(ShowsSomething(expected));
  EXPECT_GE(PSNR(right, expected), 50.0);
}

TEST(Geometry, StateOfOpenGLIsLeftAsItWasFound)
{
  // Geometry drawn after the volume, in a second layer, must look as without the volume.
  const auto draw = [](bool withVolume)
  {
    Scene scene;
    Prepare(scene);
    scene.Volume->SetVisibility(withVolume ? 1 : 0);
    scene.LookFrom(30.0, 30.0);
    vtkNew<vtkRenderer> layer;
    layer->SetLayer(1);
    layer->AddActor(Slab(-1.0, 1.0));
    layer->SetViewport(0.0, 0.0, 0.3, 0.3);
    scene.Window->SetNumberOfLayers(2);
    scene.Window->AddRenderer(layer);
    scene.Draw();
    scene.Draw();
    auto picture = Grab(scene.Window);
    int extent[6] = { 0, 75, 0, 75, 0, 0 };
    picture->Crop(extent);
    return picture;
  };
  const auto with = draw(true);
  const auto without = draw(false);
  EXPECT_TRUE(ShowsSomething(with));
  // The layer is blended over the volume: compare where the slab is, in the middle.
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_EQ(with->GetScalarComponentAsDouble(38, 38, 0, channel),
      without->GetScalarComponentAsDouble(38, 38, 0, channel));
  }
}
