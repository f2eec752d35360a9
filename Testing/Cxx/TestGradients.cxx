// Opacity, and colour, by the magnitude of the gradient.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace flatblock::testing;

namespace
{
void ShowWaves(Scene& scene)
{
  scene.SetVolume(MakeWaves(), 0.2);
  scene.SetOpacity({ { 500.0, 0.0 }, { 650.0, 0.2 } });
  scene.SetColor({ { 500.0, 0.8, 0.3, 0.2 }, { 700.0, 0.9, 0.9, 0.7 } });
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.3);
}

void SetGradientOpacity(Scene& scene, const std::vector<std::pair<double, double>>& points)
{
  vtkNew<vtkPiecewiseFunction> function;
  for (const auto& [magnitude, opacity] : points)
  {
    function->AddPoint(magnitude, opacity);
  }
  scene.Property->SetGradientOpacity(function);
}

// Values rise by `rise` from sample to sample along x, seen along x: depths are known.
void ShowRamp(Scene& scene, double rise, const std::array<double, 3>& spacing)
{
  const auto image = MakeVolume({ 65, 33, 33 }, VTK_FLOAT,
    [=](int x, int, int) { return x % 64 == 0 ? 10.0 * x : rise * (x - 32) + 320.0; });
  image->SetSpacing(spacing.data());
  scene.SetVolume(image, 0.2);
  scene.SetOpacity({ { 0.0, 0.01 }, { 1e4, 0.01 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 }, { 640.0, 1.0, 1.0, 1.0 } });
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(4.0 * spacing[0], 60.0 * spacing[0], -1.0, 1e5, -1.0, 1e5);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double y = 16.0 * spacing[1];
  const double z = 16.0 * spacing[2];
  camera->SetPosition(-100.0, y, z);
  camera->SetFocalPoint(32.0, y, z);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(8.0);
  scene.Renderer->ResetCameraClippingRange();
}

void ExpectDepth(Scene& scene, double depth, double bound)
{
  for (const auto& pixel : DrawFloats(scene))
  {
    ASSERT_NEAR(pixel[3], 1.0 - std::exp(-depth), bound);
  }
}

const double DepthOfOne = -std::log1p(-0.01); // a unit of length

// Red, and from a row on green with an opacity of its own.
void SetTwoDimensions(
  Scene& scene, int width, int height, int firstUpper, double lower, double upper)
{
  vtkNew<vtkImageData> function;
  function->SetDimensions(width, height, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const bool isUpper = y >= firstUpper;
      const float color[4] = { isUpper ? 0.0F : 1.0F, isUpper ? 1.0F : 0.0F, 0.0F,
        static_cast<float>(isUpper ? upper : lower) };
      std::copy_n(color, 4, static_cast<float*>(function->GetScalarPointer(x, y, 0)));
    }
  }
  scene.Property->SetTransferFunction2D(function);
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
}
} // namespace

TEST(Gradients, ThinMatterByTheirMagnitude)
{
  Scene scene;
  ShowRamp(scene, 10.0, { 1.0, 1.0, 1.0 });
  ExpectDepth(scene, 56.0 * DepthOfOne, 1e-4);
  SetGradientOpacity(scene, { { 0.0, 0.0 }, { 40.0, 1.0 } });
  ExpectDepth(scene, 0.25 * 56.0 * DepthOfOne, 1e-4);
  SetGradientOpacity(scene, { { 0.0, 1.0 }, { 9.0, 1.0 }, { 9.5, 0.0 } });
  ExpectDepth(scene, 0.0, 0.0);
  scene.Property->DisableGradientOpacityOn();
  ExpectDepth(scene, 56.0 * DepthOfOne, 1e-4);
}

TEST(Gradients, AreMeasuredOverTheMeanSpacing)
{
  Scene scene;
  ShowRamp(scene, 10.0, { 2.0, 1.0, 1.5 });
  SetGradientOpacity(scene, { { 0.0, 0.0 }, { 40.0, 1.0 } });
  ExpectDepth(scene, 10.0 / 2.0 * 1.5 / 40.0 * 112.0 * DepthOfOne, 1e-4);
}

TEST(Gradients, BeyondAQuarterOfTheRangeAreTakenAsThat)
{
  Scene scene;
  ShowRamp(scene, 10.0, { 30.0, 1.0, 240.0 }); // 30 times as large
  scene.Property->SetScalarOpacityUnitDistance(30.0);
  SetGradientOpacity(scene, { { 0.0, 0.0 }, { 320.0, 1.0 } });
  scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  ExpectDepth(scene, std::min(10.0 / 30.0 * 271.0 / 3.0, 160.0) / 320.0 * 56.0 * DepthOfOne, 1e-3);
}

TEST(Gradients, OfAnOpacityOfOneCostNothing)
{
  Scene scene;
  ShowWaves(scene);
  const Picture picture = DrawFloats(scene);
  SetGradientOpacity(scene, { { 0.0, 1.0 }, { 255.0, 1.0 } });
  EXPECT_EQ(LargestDifference(DrawFloats(scene), picture), 0.0);
}

TEST(Gradients, DoNotShowBlocks)
{
  for (const bool hasColors : { false, true })
  {
    Scene scene;
    ShowWaves(scene);
    scene.Property->ShadeOn();
    if (hasColors)
    {
      SetTwoDimensions(scene, 64, 9, 4, 0.01, 0.05);
    }
    else
    {
      SetGradientOpacity(scene, { { 0.0, 0.0 }, { 60.0, 1.0 } });
    }
    const Picture blocks = DrawFloats(scene);
    scene.Mapper->SetBlockSize(65);
    scene.Mapper->SetSkipping(0);
    EXPECT_LE(RootMeanSquare(DrawFloats(scene), blocks), 1e-3) << hasColors;
  }
}

TEST(Gradients, LookAsWithThePeer)
{
  Scene scene;
  ShowWaves(scene);
  SetGradientOpacity(scene, { { 10.0, 0.0 }, { 60.0, 1.0 } });
  const auto ours = scene.Draw();
  EXPECT_TRUE(ShowsSomething(ours));
  EXPECT_GE(PSNR(ours, scene.DrawWithPeer()), 34.0);
  SetTwoDimensions(scene, 256, 256, 60, 0.01, 0.05);
  scene.SetVolume(
    MakeWaves(), 1.0); // the length that the peer takes opacities for, whatever is set
  EXPECT_GE(PSNR(scene.Draw(), scene.DrawWithPeer()), 34.0);
}

TEST(TwoDimensions, ColourByValueAndMagnitude)
{
  Scene scene;
  ShowRamp(scene, 9.0, { 1.0, 1.0, 1.0 }); // of 160
  SetTwoDimensions(scene, 64, 33, 3, 0.01, 0.5);
  ExpectDepth(scene, 56.0 * DepthOfOne, 1e-4);
  EXPECT_NEAR(DrawFloats(scene)[0][0], DrawFloats(scene)[0][3], 1e-6);
  SetTwoDimensions(scene, 64, 33, 1, 0.5, 0.01);
  ExpectDepth(scene, 56.0 * DepthOfOne, 1e-4);
  EXPECT_NEAR(DrawFloats(scene)[0][1], DrawFloats(scene)[0][3], 1e-6);
}

TEST(TwoDimensions, StayWithinTheMemory)
{
  Scene scene;
  ShowWaves(scene);
  SetTwoDimensions(scene, 1024, 64, 32, 0.01, 0.05);
  const vtkTypeInt64 limit = Beside + 16 * 1024 * 64 + 200000;
  scene.Mapper->SetMaxMemoryInBytes(limit);
  EXPECT_TRUE(ShowsSomething(scene.Draw()));
  EXPECT_LE(scene.Mapper->GetPeakMemoryInBytes(), limit);
  SetTwoDimensions(scene, 512, 64, 32, 0.01, 0.05);
  scene.Draw();
  EXPECT_LE(scene.Mapper->GetPeakMemoryInBytes(), limit);
}

TEST(TwoDimensions, ThatAreMissingAreAnError)
{
  Scene scene;
  ShowWaves(scene);
  const auto good = scene.Draw();
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  const Messages messages = Listen(
    [&]
    {
      scene.Draw();
      scene.Draw();
    });
  ASSERT_EQ(messages.Errors.size(), 1U);
  EXPECT_NE(messages.Errors[0].find("SetTransferFunction2D"), std::string::npos);
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  EXPECT_EQ(LargestDifference(scene.Draw(), good), 0.0);
}

// Rows are values of another array, over its range.
TEST(TwoDimensions, OfTwoArrays)
{
  Scene scene;
  ShowRamp(scene, 10.0, { 1.0, 1.0, 1.0 });
  vtkImageData* image = vtkImageData::SafeDownCast(scene.Mapper->GetInput());
  const auto other = MakeVolume({ 65, 33, 33 }, VTK_SHORT,
    [](int x, int, int z) { return x == 0 ? -100.0 : (x == 64 ? 300.0 : (z < 17 ? 0.0 : 200.0)); });
  other->GetPointData()->GetScalars()->SetName("other");
  image->GetPointData()->AddArray(other->GetPointData()->GetScalars());
  SetTwoDimensions(scene, 64, 41, 20, 0.01, 0.02);
  scene.Mapper->SetTransfer2DYAxisArray("other");
  scene.Property->SetInterpolationTypeToNearest();
  const Picture picture = DrawFloats(scene);
  const auto& below = picture[256 * 40 + 128];
  const auto& above = picture[256 * 200 + 128];
  EXPECT_NEAR(below[3], 1.0 - std::pow(0.99, 56.0), 1e-3);
  EXPECT_NEAR(below[0], below[3], 1e-6);
  EXPECT_NEAR(above[3], 1.0 - std::pow(0.98, 56.0), 1e-3);
  EXPECT_NEAR(above[1], above[3], 1e-6);
  scene.Mapper->SetTransfer2DYAxisArray("none such");
  const Messages messages = Listen([&] { scene.Draw(); });
  ASSERT_EQ(messages.Errors.size(), 1U);
  EXPECT_NE(messages.Errors[0].find("Transfer2DYAxisArray"), std::string::npos);
}
