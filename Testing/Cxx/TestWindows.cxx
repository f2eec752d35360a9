// Graphics resources: given back, made again, in one window and another.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkPolyDataMapper.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

using namespace flatblock::testing;

namespace
{
void Prepare(Scene& scene)
{
  scene.SetVolume(MarschnerLobb(48), 1.0 / 47.0);
  scene.SetRamp(0.0, 255.0, 0.5);
  scene.Property->SetScalarOpacityUnitDistance(0.2);
  scene.LookFrom(30.0, 30.0);
}
} // namespace

TEST(Windows, ResourcesAreMadeAgainAfterRelease)
{
  Scene scene;
  Prepare(scene);
  const auto before = scene.Draw();
  ASSERT_TRUE(ShowsSomething(before));
  EXPECT_GT(scene.Mapper->GetAtlasBytes(), 0);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(scene.Mapper->GetAtlasBytes(), 0);
  EXPECT_EQ(LargestDifference(before, scene.Draw()), 0.0);
  EXPECT_GT(scene.Mapper->GetUploadedBytes(), 0);
}

TEST(Windows, VolumeMovesToAnotherWindow)
{
  Scene first;
  Prepare(first);
  const auto before = first.Draw();
  Scene second;
  Prepare(second);
  first.Renderer->RemoveVolume(first.Volume);
  second.Renderer->RemoveVolume(second.Volume);
  second.Renderer->AddVolume(first.Volume);
  second.Window->Render();
  EXPECT_EQ(LargestDifference(before, Grab(second.Window)), 0.0);
}

TEST(Windows, VolumeOutlivesItsWindow)
{
  auto one = std::make_unique<Scene>();
  Prepare(*one);
  const auto before = one->Draw();
  vtkSmartPointer<vtkVolume> volume = one->Volume.Get();
  one.reset();

  Scene other;
  Prepare(other);
  other.Renderer->RemoveVolume(other.Volume);
  other.Renderer->AddVolume(volume);
  other.Window->Render();
  EXPECT_EQ(LargestDifference(before, Grab(other.Window)), 0.0);
}

TEST(Windows, OneVolumeInTwoWindowsAtOnce)
{
  Scene first;
  Prepare(first);
  const auto expected = first.Draw();
  Scene second;
  Prepare(second);
  second.Renderer->RemoveVolume(second.Volume);
  second.Renderer->AddVolume(first.Volume);
  for (int i = 0; i < 3; ++i)
  {
    second.Window->Render();
    EXPECT_EQ(LargestDifference(expected, Grab(second.Window)), 0.0);
    first.Window->Render();
    EXPECT_EQ(LargestDifference(expected, Grab(first.Window)), 0.0);
  }
}

// The mapper is not in any renderer when its window goes.
TEST(Windows, MapperOutlivesItsWindowUnnoticed)
{
  vtkNew<vtkFlatBlockVolumeMapper> mapper;
  vtkSmartPointer<vtkImageData> before;
  {
    Scene first;
    Prepare(first);
    mapper->SetInputData(MarschnerLobb(48));
    mapper->SetSampleDistance(first.Mapper->GetSampleDistance());
    first.Volume->SetMapper(mapper);
    first.Window->Render();
    before = Grab(first.Window);
    first.Volume->SetMapper(first.Mapper);
    first.Window->Render();
  }
  Scene second;
  Prepare(second);
  second.Volume->SetMapper(mapper);
  second.Window->Render();
  EXPECT_TRUE(ShowsSomething(before));
  EXPECT_EQ(LargestDifference(before, Grab(second.Window)), 0.0);
}

TEST(Windows, RemovalFromOneWindowLeavesTheOthersActors)
{
  Scene first;
  Prepare(first);
  Scene second;
  Prepare(second);
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> sphereMapper;
  sphereMapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(sphereMapper);
  second.Renderer->RemoveVolume(second.Volume);
  second.Renderer->AddActor(actor);
  second.Window->Render();
  const auto alone = Grab(second.Window);
  ASSERT_TRUE(ShowsSomething(alone));
  second.Renderer->AddVolume(first.Volume);
  second.Window->Render();
  first.Window->Render();
  second.Renderer->RemoveVolume(first.Volume);
  second.Window->Render();
  EXPECT_EQ(LargestDifference(alone, Grab(second.Window)), 0.0);
}

TEST(Windows, SizeMayChange)
{
  Scene scene;
  Prepare(scene);
  const auto before = scene.Draw();
  scene.Window->SetSize(200, 150);
  EXPECT_TRUE(ShowsSomething(scene.Draw()));
  scene.Window->SetSize(256, 256);
  EXPECT_EQ(LargestDifference(before, scene.Draw()), 0.0);
}

TEST(Windows, TwoMappersShareOne)
{
  Scene scene;
  Prepare(scene);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0);
  vtkNew<vtkFlatBlockVolumeMapper> mapper;
  mapper->SetInputData(MarschnerLobb(48));
  vtkNew<vtkVolume> beside;
  beside->SetMapper(mapper);
  beside->SetProperty(scene.Property);
  beside->SetPosition(2.5, 0.0, 0.0);
  scene.Renderer->AddVolume(beside);
  scene.LookFrom(0.0, 0.0);
  scene.Draw();
  scene.Draw();
  auto left = vtkSmartPointer<vtkImageData>::New();
  left->DeepCopy(Grab(scene.Window));
  EXPECT_TRUE(ShowsSomething(left));
  EXPECT_EQ(mapper->GetUploadedBytes(), 0);
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);
}
