// Classification: opacity correction, editing, tables.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace flatblock::testing;

namespace
{
// Values grow along x, so that an interval of values is a layer of blocks.
vtkSmartPointer<vtkImageData> Layers(int type = VTK_UNSIGNED_CHAR)
{
  return MakeVolume({ 129, 33, 33 }, type, [](int x, int, int) { return x; });
}

void ShowLayer(Scene& scene, double from, double to)
{
  scene.SetOpacity({ { from, 0.0 }, { 0.5 * (from + to), 0.4 }, { to, 0.0 } });
  scene.SetColor({ { 0.0, 0.9, 0.2, 0.1 }, { 128.0, 0.1, 0.9, 0.9 } });
}

Scene& Prepare(Scene& scene)
{
  scene.SetVolume(Layers(), 0.5);
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(20.0, 30.0);
  return scene;
}
} // namespace

TEST(TransferFunction, EditsUploadOnlyWhatTheyShow)
{
  constexpr int BrickBytes = 17 * 17 * 17;
  Scene scene;
  Prepare(scene);
  ShowLayer(scene, 20.0, 62.0);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetNumberOfVisibleBlocks(), 12);
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 12 * BrickBytes);
  ShowLayer(scene, 20.0, 78.0);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetNumberOfVisibleBlocks(), 16);
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 4 * BrickBytes);
  ShowLayer(scene, 36.0, 78.0);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetNumberOfVisibleBlocks(), 12);
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);
}

TEST(TransferFunction, EditsEndLikeAFreshMapper)
{
  Scene edited;
  Prepare(edited);
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{
         { 0, 128 }, { 60, 70 }, { 3, 9 }, { 90, 127 }, { 40, 80 } })
  {
    ShowLayer(edited, from, to);
    const auto after = edited.Draw();
    Scene fresh;
    Prepare(fresh);
    ShowLayer(fresh, from, to);
    EXPECT_EQ(LargestDifference(after, fresh.Draw()), 0.0) << from << " to " << to;
    EXPECT_TRUE(ShowsSomething(after));
  }
}

TEST(TransferFunction, EditingPointsInPlaceIsSeen)
{
  Scene scene;
  Prepare(scene);
  ShowLayer(scene, 20.0, 60.0);
  const auto before = scene.Draw();
  scene.Property->GetScalarOpacity()->AddPoint(100.0, 0.5);
  const auto after = scene.Draw();
  EXPECT_LT(PSNR(before, after), 40.0);
  scene.Property->GetRGBTransferFunction()->AddRGBPoint(60.0, 1.0, 1.0, 1.0);
  EXPECT_LT(PSNR(after, scene.Draw()), 40.0);
}

// So close that VTK's estimate of the table's size overflows.
TEST(TransferFunction, StepsAreSharp)
{
  Scene scene;
  scene.SetVolume(
    MakeVolume({ 65, 33, 33 }, VTK_DOUBLE, [](int x, int, int) { return 1e5 * x / 64.0; }), 0.05);
  scene.SetOpacity({ { 0.0, 0.0 }, { 5e4, 0.0 }, { 5e4 + 1e-5, 0.9 }, { 1e5, 0.9 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 } });
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0);
  const auto picture = scene.Draw();
  // A voxel is 6.6 pixels wide here: the edge lies between two neighbouring pixels.
  EXPECT_EQ(picture->GetScalarComponentAsDouble(127, 128, 0, 0), 0.0);
  EXPECT_GE(picture->GetScalarComponentAsDouble(129, 128, 0, 0), 250.0);
}

TEST(TransferFunction, OpacityDoesNotDependOnTheStep)
{
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (double step : { 0.1, 0.2, 0.4, 0.8 })
  {
    Scene scene;
    scene.SetVolume(AnisotropicWavelet(40), step);
    scene.SetRamp(0.0, 270.0, 0.08);
    scene.LookFrom(33.0, 21.0, 1.3);
    pictures.push_back(scene.Draw());
    EXPECT_GE(PSNR(pictures.back(), pictures.front()), 45.0) << step;
  }
}

TEST(TransferFunction, UnitDistanceScalesOpacity)
{
  Scene scene;
  scene.SetVolume(AnisotropicWavelet(40), 0.5);
  scene.SetRamp(0.0, 270.0, 0.3);
  scene.LookFrom(33.0, 21.0, 1.3);
  for (double unit : { 0.5, 4.0, 20.0 })
  {
    scene.Property->SetScalarOpacityUnitDistance(unit);
    EXPECT_GE(PSNR(scene.Draw(), scene.DrawWithPeer()), 40.0) << unit;
  }
}

TEST(TransferFunction, AutomaticStepIsHalfTheSmallestSpacing)
{
  Scene scene;
  scene.SetVolume(AnisotropicWavelet(40), 0.5);
  scene.SetRamp(0.0, 270.0, 0.1);
  scene.LookFrom(33.0, 21.0, 1.3);
  const auto given = scene.Draw();
  scene.Mapper->SetSampleDistance(0.0);
  EXPECT_EQ(LargestDifference(given, scene.Draw()), 0.0);
}

// Not against the peer: vtkGPUVolumeRayCastMapper takes no notice of a gray function.
TEST(TransferFunction, GrayFunctionsEqualColorsOfEqualChannels)
{
  Scene scene;
  scene.SetVolume(Layers(VTK_SHORT), 0.25);
  scene.SetOpacity({ { 20.0, 0.0 }, { 100.0, 0.2 } });
  scene.SetColor({ { 0.0, 0.2, 0.2, 0.2 }, { 128.0, 1.0, 1.0, 1.0 } });
  scene.LookFrom(20.0, 30.0);
  const auto colored = scene.Draw();
  EXPECT_TRUE(ShowsSomething(colored));
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 0.2);
  gray->AddPoint(128.0, 1.0);
  scene.Property->SetColor(gray);
  EXPECT_LE(LargestDifference(colored, scene.Draw()), 1.0);
}

// What vtkColorTransferFunction::GetTable() gives for its first node is black.
TEST(TransferFunction, TheFirstNodeHasItsColor)
{
  for (int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    Scene scene;
    scene.SetVolume(
      MakeVolume({ 20, 20, 20 }, type, [](int x, int, int) { return x < 12 ? 50.0 : 10.0; }), 0.5);
    scene.SetOpacity({ { 0.0, 0.0 }, { 49.0, 0.0 }, { 50.0, 0.9 }, { 60.0, 0.9 } });
    scene.SetColor({ { 50.0, 0.8, 0.4, 0.2 }, { 200.0, 0.1, 0.1, 0.9 } });
    scene.LookFrom(180.0, 0.0);
    for (int classification = 0; classification < 3; ++classification)
    {
      scene.Mapper->SetClassification(classification);
      const auto pixel = DrawFloats(scene)[128 * 256 + 150];
      EXPECT_GE(pixel[3], 0.99);
      EXPECT_NEAR(pixel[0] / pixel[3], 0.8, 0.01);
      EXPECT_NEAR(pixel[1] / pixel[3], 0.4, 0.01);
      EXPECT_NEAR(pixel[2] / pixel[3], 0.2, 0.01);
    }
  }
}

// A layer of less than one value: the extinction -ln(1 - opacity), integrated along x.
TEST(TransferFunction, CloseNodesAreNotLost)
{
  constexpr double First = 50.30;
  constexpr double Width = 0.5;
  constexpr double Opacity = 0.8;
  Scene scene;
  scene.SetVolume(Layers(VTK_FLOAT), 0.01);
  scene.SetOpacity({ { First, 0.0 }, { First + 0.5 * Width, Opacity }, { First + Width, 0.0 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 } });
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(90.0, 0.0);
  const auto picture = scene.Draw();

  double extinction = 0.0;
  constexpr int Intervals = 1000;
  for (int i = 0; i < Intervals; ++i)
  {
    const double middle = (i + 0.5) / Intervals;
    extinction -= std::log1p(-Opacity * (1.0 - std::abs(2.0 * middle - 1.0))) * Width / Intervals;
  }
  EXPECT_NEAR(picture->GetScalarComponentAsDouble(128, 128, 0, 0),
    255.0 * (1.0 - std::exp(-extinction)), 2.0);
}
