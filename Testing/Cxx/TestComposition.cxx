// Volumes among other props, and windows that are drawn in several passes.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkActor.h"
#include "vtkLODProp3D.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace flatblock::testing;

namespace
{
void Show(Scene& scene)
{
  scene.SetVolume(MakeVolume({ 50, 46, 54 }, VTK_FLOAT, WavesAt), 0.25);
  scene.SetOpacity({ { 500.0, 0.0 }, { 700.0, 0.2 } });
  scene.SetColor({ { 500.0, 0.8, 0.3, 0.2 }, { 700.0, 0.9, 0.9, 0.7 } });
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.3);
}

vtkActor* AddSphere(
  Scene& scene, const std::array<double, 3>& center, double radius, double opacity)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center[0], center[1], center[2]);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.2, 0.5, 0.9);
  actor->GetProperty()->SetOpacity(opacity);
  scene.Renderer->AddActor(actor);
  return actor;
}

// The window in tiles that are `scale` times as large as it.
vtkSmartPointer<vtkImageData> GrabTiles(vtkRenderWindow* window, int scale)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetScale(scale);
  filter->ReadFrontBufferOff();
  filter->FixBoundaryOff();
  filter->Update();
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->ShallowCopy(filter->GetOutput());
  return picture;
}
} // namespace

TEST(Composition, WithTranslucentGeometryIsAsThePeers)
{
  for (const bool peels : { false, true })
  {
    Scene scene;
    Show(scene);
    AddSphere(scene, { 25.0, 23.0, 27.0 }, 14.0, 1.0);
    AddSphere(scene, { 35.0, 33.0, 40.0 }, 18.0, 0.4);
    scene.Window->SetAlphaBitPlanes(1);
    scene.Renderer->SetUseDepthPeeling(peels);
    scene.Renderer->SetMaximumNumberOfPeels(8);
    const auto ours = scene.Draw();
    EXPECT_TRUE(ShowsSomething(ours));
    EXPECT_GE(PSNR(ours, scene.DrawWithPeer()), 38.0) << peels;
  }
}

// Both eyes see a ball where they see a sphere of geometry. The peer's rays start between them.
TEST(Composition, InStereoIsWhereGeometryIs)
{
  constexpr std::array<double, 3> Center = { 20.0, 30.0, 40.0 };
  constexpr double Radius = 15.0;
  for (const int type : { VTK_STEREO_ANAGLYPH, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL,
         VTK_STEREO_INTERLACED, VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
  {
    Scene scene;
    const auto ball = MakeVolume({ 60, 60, 60 }, VTK_FLOAT,
      [&](int x, int y, int z)
      { return 100.0 - std::hypot(x - Center[0], y - Center[1], z - Center[2]); });
    scene.SetVolume(ball, 0.25);
    scene.SetOpacity({ { 100.0 - Radius, 0.0 }, { 100.1 - Radius, 1.0 } });
    scene.SetColor({ { 0.0, 0.2, 0.5, 0.9 } });
    scene.LookFrom(30.0, 25.0);
    scene.Window->SetStereoType(type);
    scene.Window->StereoRenderOn();
    const auto volume = scene.Draw();
    EXPECT_TRUE(ShowsSomething(volume));
    scene.Renderer->RemoveVolume(scene.Volume);
    vtkActor* actor = AddSphere(scene, Center, Radius, 1.0);
    actor->GetProperty()->LightingOff();
    scene.Window->Render();
    EXPECT_GE(PSNR(volume, Grab(scene.Window)), 28.0) << type;
  }
}

// As if the window were as large: no seams, whatever the knobs.
TEST(Composition, InTilesIsThatOfALargeWindow)
{
  constexpr int Scale = 3;
  for (const bool isParallel : { false, true })
  {
    Scene scene;
    Show(scene);
    scene.Window->SetSize(100, 90);
    scene.Renderer->GetActiveCamera()->SetParallelProjection(isParallel ? 1 : 0);
    scene.Property->ShadeOn();
    scene.Window->Render();
    const auto tiles = GrabTiles(scene.Window, Scale);
    scene.Window->SetSize(100 * Scale, 90 * Scale);
    const auto whole = scene.Draw();
    EXPECT_TRUE(ShowsSomething(whole));
    EXPECT_LE(ShareThatDiffers(whole, tiles, 2), 1e-3) << isParallel;
  }
}

// One after the other, from back to front by the middle of their bounds.
TEST(Composition, OfTwoVolumesIsAsThePeers)
{
  Scene scene;
  Show(scene);
  vtkNew<vtkFlatBlockVolumeMapper> mapper;
  mapper->SetInputData(MakeVolume({ 50, 46, 54 }, VTK_FLOAT, WavesAt));
  mapper->SetSampleDistance(0.25);
  vtkNew<vtkVolume> other;
  other->SetMapper(mapper);
  other->SetProperty(scene.Property);
  other->SetPosition(30.0, 10.0, -20.0);
  scene.Renderer->AddVolume(other);
  const auto ours = scene.Draw();
  vtkNew<vtkVolumeProperty> property;
  property->DeepCopy(scene.Property);
  const auto peer = scene.DrawWithPeer();
  EXPECT_GE(PSNR(ours, peer), 38.0);
  scene.Renderer->RemoveVolume(other);
  EXPECT_LE(PSNR(ours, scene.Draw()), 30.0);
}

TEST(Composition, ByALODPropIsThatOfTheVolume)
{
  Scene scene;
  Show(scene);
  const auto plain = scene.Draw();
  vtkNew<vtkLODProp3D> prop;
  const int id = prop->AddLOD(scene.Mapper, scene.Property, 0.0);
  prop->AutomaticLODSelectionOff();
  prop->SetSelectedLODID(id);
  scene.Renderer->RemoveVolume(scene.Volume);
  scene.Renderer->AddViewProp(prop);
  scene.Window->Render();
  EXPECT_EQ(LargestDifference(Grab(scene.Window), plain), 0.0);
}
