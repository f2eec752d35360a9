// Values of the cubic B-spline.
#include "CurvaturePicture.h"
#include "Volumes.h"

#include "vtkPlane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace flatblock::testing;

namespace
{
using Mapper = vtkFlatBlockVolumeMapper;

void ShowSmoothCloud(Scene& scene)
{
  ShowCloud(scene);
  scene.SetOpacity({ { 500.0, 0.0 }, { 650.0, 0.2 } });
  scene.Mapper->SetReconstructionFilterToCubicBSpline();
}

// Single voxels and a sheet in emptiness.
void ShowVoxels(Scene& scene, double opacityFrom)
{
  scene.SetVolume(MakeVolume({ 49, 49, 49 }, VTK_FLOAT,
                    [](int x, int y, int z)
                    {
                      const bool isVoxel = x % 16 == 0 && y % 16 == 0 && z % 16 == 0;
                      return isVoxel || (x == 17 && y < 20) ? 100.0 : 0.0;
                    }),
    0.25);
  scene.SetOpacity({ { opacityFrom, 0.0 }, { opacityFrom + 1.0, 0.2 }, { 200.0, 0.4 } });
  scene.SetColor({ { 0.0, 1.0, 0.0, 0.0 }, { 100.0, 0.0, 1.0, 0.0 } });
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(25.0, 35.0, 1.2);
  scene.Mapper->SetReconstructionFilterToCubicBSpline();
}
} // namespace

TEST(Splines, HaveTheReferencesValues)
{
  Scene scene;
  ShowVoxels(scene, 2.0);
  constexpr int Stride = 8;
  const Picture expected = DrawReference(scene, Stride, ReferenceFilter::CubicBSpline);
  const Picture drawn = TakeEvery(DrawFloats(scene), 256, Stride);
  EXPECT_LT(RootMeanSquare(drawn, expected), 1e-3);
  scene.Mapper->SetReconstructionFilterToLinear();
  EXPECT_GT(RootMeanSquare(TakeEvery(DrawFloats(scene), 256, Stride), expected), 1e-2);
}

// A block is not hidden, and no cube leapt over, that a sample beside it shows in.
TEST(Splines, AreNotLeaptOver)
{
  for (const bool isInterpolating : { false, true })
  {
    Scene scene;
    ShowVoxels(scene, 0.5);
    scene.Mapper->SetInterpolatingBSpline(isInterpolating);
    const Picture leaping = DrawFloats(scene);
    scene.Mapper->SetSkipping(Mapper::SKIP_NOTHING);
    scene.SetOpacity({ { -1e3, 1e-12 }, { 0.5, 1e-12 }, { 1.5, 0.2 }, { 200.0, 0.4 } });
    const Picture whole = DrawFloats(scene);
    EXPECT_GT(*std::max_element(whole.begin(), whole.end()), (std::array<double, 4>{ 0.1 }));
    EXPECT_LT(LargestDifference(leaping, whole), 2.0 / 255.0) << isInterpolating;
  }
}

TEST(Splines, DoNotShowBlocks)
{
  for (const bool isInterpolating : { false, true })
  {
    Scene scene;
    ShowSmoothCloud(scene);
    scene.Mapper->SetInterpolatingBSpline(isInterpolating);
    scene.Property->ShadeOn();
    const Picture blocks = DrawFloats(scene);
    scene.Mapper->SetBlockSize(65);
    scene.Mapper->SetSkipping(Mapper::SKIP_NOTHING);
    EXPECT_LT(LargestDifference(DrawFloats(scene), blocks), 1.0 / 255.0) << isInterpolating;
  }
}

// Isosurfaces of the spline that interpolates go through the samples that are exactly of that
// value; those of the one that smooths do not.
TEST(Splines, InterpolateTheSamples)
{
  const auto valueAt = [](double x, double y, double z)
  { return std::sin(0.9 * x) + std::cos(0.8 * y) + std::sin(0.7 * z); };
  Scene scene;
  scene.SetVolume(
    MakeVolume({ 20, 20, 20 }, VTK_FLOAT, [&](int x, int y, int z) { return valueAt(x, y, z); }),
    0.1);
  scene.SetOpacity({ { -10.0, 0.1 }, { 10.0, 0.1 } });
  scene.SetColor({ { -3.0, 0.0, 0.0, 0.0 }, { 3.0, 1.0, 1.0, 1.0 } });
  scene.Mapper->SetReconstructionFilterToCubicBSpline();
  vtkNew<vtkPlane> plane; // through samples
  plane->SetOrigin(0.0, 0.0, 7.0);
  plane->SetNormal(0.0, 0.0, 1.0);
  scene.Property->SetSliceFunction(plane);
  scene.Mapper->SetBlendModeToSlice();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(9.5, 9.5, 50.0);
  camera->SetFocalPoint(9.5, 9.5, 7.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(16.0); // a sample lies in the middle of four pixels, 8 apart
  scene.Renderer->ResetCameraClippingRange();
  const auto measure = [&](bool isInterpolating)
  {
    scene.Mapper->SetInterpolatingBSpline(isInterpolating);
    const Picture picture = DrawFloats(scene);
    double largest = 0.0;
    for (int y = 1; y < 19; ++y)
    {
      for (int x = 1; x < 19; ++x)
      {
        double mean = 0.0;
        for (int i = 0; i < 4; ++i)
        {
          const int column = 128 + static_cast<int>(std::lround(8.0 * (x - 9.5))) - i % 2;
          const int row = 128 + static_cast<int>(std::lround(8.0 * (y - 9.5))) - i / 2;
          const auto& pixel = picture[row * 256 + column];
          mean += 0.25 * pixel[0] / pixel[3];
        }
        largest = std::max(largest, std::abs(6.0 * mean - 3.0 - valueAt(x, y, 7.0)));
      }
    }
    return largest;
  };
  EXPECT_LT(measure(true), 0.01);
  EXPECT_GT(measure(false), 0.1);
}

TEST(Splines, AtCoarseLevelsShowNoCracks)
{
  Scene scene;
  ShowSmoothCloud(scene);
  const Picture finest = DrawFloats(scene);
  scene.Mapper->SetMaxMemoryInBytes(scene.Mapper->GetMemoryInBytes() / 2);
  scene.Window->Render();
  ASSERT_GT(scene.Mapper->GetNumberOfBricks(1), 0);
  EXPECT_GT(PeakSignalToNoise(DrawFloats(scene), finest), 28.0);
}

// Texels that are classified one by one must be samples, and not the spline's coefficients.
TEST(Splines, AreOfSamplesWhereTheseAreClassified)
{
  const std::function<void(Scene&)> settings[] = { [](Scene& scene)
    { scene.Mapper->SetClassificationToPreInterpolation(); },
    [](Scene& scene)
    {
      scene.Property->ShadeOn();
      scene.Mapper->ComputeNormalFromOpacityOn();
    } };
  for (const auto& set : settings)
  {
    Scene scene;
    ShowSmoothCloud(scene);
    set(scene);
    const Picture smooth = DrawFloats(scene);
    scene.Mapper->InterpolatingBSplineOn();
    EXPECT_EQ(LargestDifference(DrawFloats(scene), smooth), 0.0);
  }
}

// Few bits are on the scale of the blocks that a block's texels come from, and not of others.
TEST(Splines, OfFewBitsAreOnTheScaleOfTheirBlocks)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 65, 17, 17 }, VTK_FLOAT,
                    [](int x, int y, int) { return x < 36 ? 0.01 * y : 100.0; }),
    0.5);
  scene.SetOpacity({ { -1.0, 0.1 }, { 200.0, 0.1 } });
  scene.SetColor({ { 0.0, 0.0, 0.0, 0.0 }, { 0.16, 1.0, 1.0, 1.0 } });
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.0, 15.0, 0.0, 16.0, 0.0, 16.0);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetReconstructionFilterToCubicBSpline();
  scene.LookFrom(0.0, 0.0, 1.0);
  const Picture whole = DrawFloats(scene);
  scene.Mapper->SetAtlasPrecision(4);
  EXPECT_LT(LargestDifference(DrawFloats(scene), whole), 0.05);
}

// Blocks without a value have none that others are on the scale of.
TEST(Splines, FindExtremesBesideHoles)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 49, 49, 49 }, VTK_FLOAT,
                    [](int x, int y, int z)
                    { return x > 16 && x < 34 && y < 34 ? std::nan("") : 3.0 * x + y - z; }),
    0.5);
  scene.SetOpacity({ { -50.0, 0.0 }, { 200.0, 1.0 } });
  scene.SetColor({ { -50.0, 0.1, 0.2, 0.9 }, { 200.0, 0.9, 0.2, 0.1 } });
  scene.Mapper->SetReconstructionFilterToCubicBSpline();
  scene.Mapper->SetBlendModeToMaximumIntensity();
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.2);
  const Picture blocks = DrawFloats(scene);
  scene.Mapper->SetBlockSize(65);
  scene.Mapper->SetSkipping(Mapper::SKIP_NOTHING);
  // But for a few rays that graze a hole.
  EXPECT_LT(RootMeanSquare(DrawFloats(scene), blocks), 5e-3);
}

// What a leap may pass over follows from the spline that is drawn, and not from one before.
TEST(Splines, AreLeaptOverAsTheyAreNow)
{
  Scene scene;
  ShowVoxels(scene, 0.5);
  scene.Mapper->SetVariationTolerance(2.0);
  scene.Window->Render();
  scene.Mapper->InterpolatingBSplineOn();
  const Picture edited = DrawFloats(scene);
  Scene fresh;
  ShowVoxels(fresh, 0.5);
  fresh.Mapper->SetVariationTolerance(2.0);
  fresh.Mapper->InterpolatingBSplineOn();
  EXPECT_EQ(LargestDifference(DrawFloats(fresh), edited), 0.0);
}

// They go through the samples at a level's stride, whatever its filter.
TEST(Splines, ThatInterpolateAreNotFiltered)
{
  Scene scene;
  ShowSmoothCloud(scene);
  scene.Mapper->InterpolatingBSplineOn();
  scene.Window->Render();
  scene.Mapper->SetMaxMemoryInBytes(scene.Mapper->GetMemoryInBytes() / 2);
  const Picture subsampled = DrawFloats(scene);
  ASSERT_GT(scene.Mapper->GetNumberOfBricks(1), 0);
  scene.Mapper->SetLevelFilterToTent();
  EXPECT_LT(LargestDifference(DrawFloats(scene), subsampled), 1.0 / 255.0);
}

// Distortion is that of integers, though coefficients are not.
TEST(Splines, ThatInterpolateBytesAreAsWrongAsTheyAre)
{
  const auto measure = [](bool isInterpolating, double memory)
  {
    Scene scene;
    scene.SetVolume(MakeVolume({ 65, 65, 65 }, VTK_UNSIGNED_CHAR,
                      [](int x, int y, int z) { return (7 * x + 5 * y * z) % 200; }),
      0.5);
    scene.SetOpacity({ { 0.0, 0.1 }, { 100.2, 0.1 }, { 100.3, 0.9 }, { 101.2, 0.1 } });
    scene.SetColor({ { 0.0, 0.0, 0.0, 1.0 }, { 100.4, 1.0, 0.0, 0.0 }, { 101.1, 0.0, 1.0, 0.0 } });
    scene.Mapper->SetReconstructionFilterToCubicBSpline();
    scene.Mapper->SetInterpolatingBSpline(isInterpolating);
    scene.Mapper->SetSelectionCriterionToDistortion();
    scene.Mapper->SetNumberOfLevels(2);
    scene.Mapper->SetBlockSize(17);
    scene.LookFrom(30.0, 40.0, 1.2);
    scene.Window->Render();
    scene.Mapper->SetMaxMemoryInBytes(
      static_cast<vtkTypeInt64>(memory * scene.Mapper->GetMemoryInBytes()));
    scene.Window->Render();
    EXPECT_EQ(scene.Mapper->GetNumberOfBricks(0), 0);
    return scene.Mapper->GetTotalDistortion();
  };
  const double expected = measure(false, 0.644);
  EXPECT_GT(expected, 0.0);
  EXPECT_EQ(measure(true, 0.333), expected);
}
