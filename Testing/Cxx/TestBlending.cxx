// Blend modes beside composite: what values along a ray become, whatever the blocks and levels.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkContourValues.h"
#include "vtkPlane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace flatblock::testing;

namespace
{
constexpr int Modes[] = { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
  vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND,
  vtkVolumeMapper::ADDITIVE_BLEND, vtkVolumeMapper::ISOSURFACE_BLEND,
  vtkVolumeMapper::SLICE_BLEND };

void SetSlice(
  Scene& scene, const std::array<double, 3>& origin, const std::array<double, 3>& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.data());
  scene.Property->SetSliceFunction(plane);
}

void Show(Scene& scene, vtkImageData* image)
{
  scene.SetVolume(image, 0.5);
  scene.SetOpacity({ { 450.0, 0.0 }, { 900.0, 0.8 } });
  scene.SetColor({ { 100.0, 0.0, 0.0, 1.0 }, { 500.0, 0.9, 0.3, 0.2 }, { 800.0, 0.9, 0.9, 0.6 } });
  scene.Property->SetScalarOpacityUnitDistance(20.0);
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 700.0);
  scene.Property->GetIsoSurfaceValues()->SetValue(1, 550.0);
  SetSlice(scene, { 25.0, 27.0, 24.0 }, { 1.0, 0.5, 0.3 });
  scene.Mapper->SetAverageIPScalarRange(300.0, 900.0);
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.3);
}

// Values rise along x alone: what a ray meets is known.
vtkSmartPointer<vtkImageData> MakeRamp(int samples)
{
  return MakeVolume(
    { samples, samples, samples }, VTK_UNSIGNED_SHORT, [](int x, int, int) { return 10.0 * x; });
}

void LookAlongX(Scene& scene, vtkImageData* image, double step)
{
  scene.SetVolume(image, step);
  scene.SetOpacity({ { 0.0, 0.5 }, { 1e4, 0.5 } });
  scene.SetColor({ { 0.0, 0.0, 0.0, 0.0 }, { 640.0, 1.0, 1.0, 1.0 } });
  scene.Mapper->SetBlockSize(17);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(-100.0, 32.0, 32.0);
  camera->SetFocalPoint(32.0, 32.0, 32.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(20.0);
  scene.Renderer->ResetCameraClippingRange();
}

void ExpectEverywhere(const Picture& picture, double gray, double opacity, double bound)
{
  for (const auto& pixel : picture)
  {
    ASSERT_NEAR(pixel[0], gray, bound);
    ASSERT_NEAR(pixel[3], opacity, bound);
  }
}
} // namespace

TEST(Blending, IsWhatThePeerDraws)
{
  for (const int mode : Modes)
  {
    Scene scene;
    Show(scene, MakeWaves());
    scene.SetVolume(MakeWaves(), 0.1); // the peer finds surfaces within a step
    scene.Mapper->SetBlendMode(mode);
    scene.Peer->SetBlendMode(mode);
    scene.Peer->SetAverageIPScalarRange(300.0, 900.0);
    const auto ours = scene.Draw();
    EXPECT_TRUE(ShowsSomething(ours));
    EXPECT_GE(PSNR(ours, scene.DrawWithPeer()), 38.0) << mode;
  }
}

TEST(Blending, DoesNotShowBlocks)
{
  for (const int mode : Modes)
  {
    Scene scene;
    Show(scene, MakeWaves());
    scene.Mapper->SetBlendMode(mode);
    const Picture blocks = DrawFloats(scene);
    scene.Mapper->SetBlockSize(65);
    scene.Mapper->SetSkipping(0);
    EXPECT_LE(RootMeanSquare(DrawFloats(scene), blocks), 2e-5) << mode;
  }
}

TEST(Blending, FollowsTheRampFromEndToEnd)
{
  Scene scene;
  LookAlongX(scene, MakeRamp(65), 0.5);
  scene.Mapper->SetBlendModeToMaximumIntensity();
  ExpectEverywhere(DrawFloats(scene), 0.5, 0.5, 1e-4);
  scene.Mapper->SetBlendModeToMinimumIntensity();
  ExpectEverywhere(DrawFloats(scene), 0.0, 0.5, 1e-4);
  scene.Mapper->SetBlendModeToAverageIntensity();
  ExpectEverywhere(DrawFloats(scene), 0.25, 1.0, 1e-4);
  scene.Mapper->SetAverageIPScalarRange(160.0, 480.0);
  ExpectEverywhere(DrawFloats(scene), 0.25, 1.0, 1e-2);
  scene.Mapper->SetAverageIPScalarRange(320.0, 640.0);
  ExpectEverywhere(DrawFloats(scene), 0.375, 1.0, 1e-2);
  scene.Mapper->SetBlendModeToAdditive();
  scene.Property->SetScalarOpacityUnitDistance(40.0);
  ExpectEverywhere(DrawFloats(scene), 0.5 * 0.5 * 64.0 / 40.0, 1.0, 1e-4);
}

// Only what is at or above all others may hide them, seen or not.
TEST(Blending, OfAMaximumThatIsTransparentShowsNothing)
{
  Scene scene;
  LookAlongX(scene, MakeRamp(65), 0.5);
  scene.SetOpacity(
    { { 0.0, 0.0 }, { 200.0, 0.0 }, { 300.0, 0.5 }, { 400.0, 0.5 }, { 500.0, 0.0 } });
  scene.Mapper->SetBlendModeToMaximumIntensity();
  ExpectEverywhere(DrawFloats(scene), 0.0, 0.0, 0.0);
  scene.SetOpacity({ { 0.0, 0.0 }, { 300.0, 0.5 }, { 1e4, 0.5 } });
  EXPECT_GT(scene.Mapper->GetNumberOfBlocks(), 0);
  ExpectEverywhere(DrawFloats(scene), 0.5, 0.5, 1e-4);
}

TEST(Blending, LeavesOutBlocksThatCannotChangeAnExtreme)
{
  for (const bool isMaximum : { true, false })
  {
    Scene scene;
    const auto image = MakeVolume({ 65, 65, 65 }, VTK_UNSIGNED_CHAR,
      [=](int x, int y, int z)
      {
        const int value = x < 16 ? 200 + (x + y + z) % 16 : 100 + (x * y + z) % 64;
        return isMaximum ? value : 255 - value;
      });
    LookAlongX(scene, image, 0.5);
    scene.SetColor({ { 0.0, 0.0, 0.0, 0.0 }, { 255.0, 1.0, 1.0, 1.0 } });
    scene.Mapper->SetBlendMode(isMaximum ? vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND
                                         : vtkVolumeMapper::MINIMUM_INTENSITY_BLEND);
    scene.Mapper->CountSamplesOn();
    const Picture blocks = DrawFloats(scene);
    EXPECT_LE(scene.Mapper->GetSamplesPerRay(), 40.0); // of 129
    scene.Mapper->SetBlockSize(65);
    EXPECT_EQ(LargestDifference(DrawFloats(scene), blocks), 0.0);
    EXPECT_GE(scene.Mapper->GetSamplesPerRay(), 125.0);
  }
}

// A plane of values is found wherever steps fall.
TEST(Blending, FindsIsosurfacesBetweenSamples)
{
  Scene scene;
  Show(scene, MakeWaves());
  scene.Property->ShadeOn();
  scene.SetOpacity({ { 0.0, 0.6 }, { 1e4, 0.6 } });
  scene.Mapper->SetBlendModeToIsoSurface();
  scene.Mapper->SetSampleDistance(0.05);
  const Picture fine = DrawFloats(scene);
  scene.Mapper->SetSampleDistance(1.0);
  EXPECT_LE(RootMeanSquare(DrawFloats(scene), fine), 4e-3);
}

TEST(Blending, DrawsEachIsosurfaceWithItsColourAndOpacity)
{
  Scene scene;
  LookAlongX(scene, MakeRamp(65), 0.7);
  scene.SetOpacity({ { 100.0, 0.25 }, { 320.0, 0.5 } });
  vtkContourValues* values = scene.Property->GetIsoSurfaceValues();
  values->SetValue(0, 320.0);
  values->SetValue(1, 100.0);
  scene.Mapper->SetBlendModeToIsoSurface();
  const double near = 100.0 / 640.0;
  ExpectEverywhere(DrawFloats(scene), 0.25 * near + 0.75 * 0.5 * 0.5, 0.25 + 0.75 * 0.5, 1e-4);
  scene.Renderer->GetActiveCamera()->SetPosition(164.0, 32.0, 32.0);
  scene.Renderer->ResetCameraClippingRange();
  ExpectEverywhere(DrawFloats(scene), 0.5 * 0.5 + 0.5 * 0.25 * near, 0.25 + 0.75 * 0.5, 1e-4);
  values->SetNumberOfContours(1);
  values->SetValue(0, 1e6);
  ExpectEverywhere(DrawFloats(scene), 0.0, 0.0, 0.0);
}

TEST(Blending, ShowsASliceWhereItLies)
{
  Scene scene;
  LookAlongX(scene, MakeRamp(65), 0.5);
  scene.Mapper->SetBlendModeToSlice();
  for (const double x : { 0.0, 16.0, 20.3, 64.0 })
  {
    SetSlice(scene, { x, 0.0, 0.0 }, { 1.0, 0.0, 0.0 });
    ExpectEverywhere(DrawFloats(scene), 0.5 * x / 64.0, 0.5, 1e-4);
  }
  SetSlice(scene, { 65.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 });
  ExpectEverywhere(DrawFloats(scene), 0.0, 0.0, 0.0);
}

TEST(Blending, RefinesTheBlocksOfASliceFirst)
{
  Scene scene;
  Show(scene, MakeWaves());
  SetSlice(scene, { 25.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 });
  scene.Mapper->SetBlendModeToSlice();
  const Picture whole = DrawFloats(scene);
  scene.Mapper->SetMaxMemoryInBytes(Beside + 500000);
  EXPECT_LE(LargestDifference(DrawFloats(scene), whole), 1e-5);
  EXPECT_LT(scene.Mapper->GetNumberOfBricks(0), CountBricks(scene.Mapper));
}

TEST(Blending, GoesOnAtCoarseLevels)
{
  for (const int mode : Modes)
  {
    Scene scene;
    Show(scene, MakeWaves());
    scene.Mapper->SetBlendMode(mode);
    const auto fine = scene.Draw();
    scene.Mapper->SetMaxMemoryInBytes(Beside + 250000);
    const auto coarse = scene.Draw();
    EXPECT_GT(scene.Mapper->GetNumberOfBricks(1), 0) << mode;
    EXPECT_GE(PSNR(fine, coarse), 24.0) << mode;
  }
}

TEST(Blending, PassesHoles)
{
  Scene scene;
  const auto image = MakeVolume({ 65, 65, 65 }, VTK_FLOAT,
    [](int x, int, int) { return x > 40 && x < 60 ? std::nan("") : 10.0 * std::min(x, 40); });
  LookAlongX(scene, image, 0.5);
  scene.SetColor({ { 0.0, 0.0, 0.0, 0.0 }, { 400.0, 1.0, 1.0, 1.0 } });
  Listen(
    [&]
    {
      scene.Mapper->SetBlendModeToMaximumIntensity();
      ExpectEverywhere(DrawFloats(scene), 0.5, 0.5, 1e-4);
      scene.Mapper->SetBlendModeToMinimumIntensity();
      ExpectEverywhere(DrawFloats(scene), 0.0, 0.5, 1e-4);
      scene.Mapper->SetBlendModeToAverageIntensity();
      ExpectEverywhere(
        DrawFloats(scene), 0.5 * (20.0 * 40.0 + 40.0 * 4.0) / 44.0 / 40.0, 1.0, 1e-2);
    });
}
