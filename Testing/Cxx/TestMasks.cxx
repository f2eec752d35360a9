// Masks: what is drawn at all, and by which functions.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

using namespace flatblock::testing;

namespace
{
constexpr std::array<int, 3> Samples = { 50, 46, 54 };
using Label = std::function<double(int, int, int)>;

vtkSmartPointer<vtkImageData> MakeMask(const Label& label)
{
  return MakeVolume(Samples, VTK_UNSIGNED_CHAR, label);
}

double LabelAt(int x, int y, int z)
{
  return x > 30 ? 2.0 : (z > 36 ? 7.0 : (std::hypot(x - 18, y - 24, z - 24) < 14.0 ? 1.0 : 0.0));
}

void Show(Scene& scene, double step = 0.5)
{
  scene.SetVolume(MakeVolume(Samples, VTK_FLOAT, WavesAt), step);
  scene.SetOpacity({ { 450.0, 0.0 }, { 900.0, 0.2 } });
  scene.SetColor({ { 100.0, 0.0, 0.0, 1.0 }, { 500.0, 0.9, 0.3, 0.2 }, { 800.0, 0.9, 0.9, 0.6 } });
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.3);
}

void SetLabel(Scene& scene, int label, double red, double green, double blue, double opacity)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, red, green, blue);
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(400.0, 0.0);
  function->AddPoint(700.0, opacity);
  scene.Property->SetLabelColor(label, color);
  scene.Property->SetLabelScalarOpacity(label, function);
}

vtkSmartPointer<vtkImageData> DrawPeerWithMask(Scene& scene, vtkImageData* mask, int type)
{
  auto* peer = vtkGPUVolumeRayCastMapper::SafeDownCast(scene.Peer);
  peer->SetMaskInput(mask);
  peer->SetMaskType(type);
  return scene.DrawWithPeer();
}
} // namespace

TEST(Masks, LookAsWithThePeer)
{
  Scene scene;
  Show(scene);
  const auto binary =
    MakeMask([](int x, int y, int z) { return LabelAt(x, y, z) > 0.0 ? 255 : 0; });
  scene.Mapper->SetMaskInput(binary);
  scene.Mapper->SetMaskTypeToBinary();
  const auto ours = scene.Draw();
  EXPECT_TRUE(ShowsSomething(ours));
  EXPECT_GE(PSNR(ours, DrawPeerWithMask(scene, binary, 0)), 40.0);

  Scene labelled;
  Show(labelled, 1.0); // for which the peer takes opacities of labels, whatever is set
  SetLabel(labelled, 1, 0.0, 1.0, 0.0, 0.2);
  SetLabel(labelled, 2, 0.2, 0.3, 1.0, 0.2);
  SetLabel(labelled, 7, 1.0, 1.0, 0.0, 0.1);
  const auto labels = MakeMask(LabelAt);
  labelled.Mapper->SetMaskInput(labels);
  EXPECT_GE(PSNR(labelled.Draw(), DrawPeerWithMask(labelled, labels, 1)), 28.0);
}

TEST(Masks, ThatAreZeroShowNothing)
{
  Scene scene;
  Show(scene);
  scene.Mapper->SetMaskInput(MakeMask([](int, int, int) { return 0.0; }));
  scene.Mapper->SetMaskTypeToBinary();
  for (const auto& pixel : DrawFloats(scene))
  {
    ASSERT_EQ(pixel[3], 0.0);
  }
  EXPECT_EQ(scene.Mapper->GetNumberOfVisibleBlocks(), 0);
}

TEST(Masks, OfASingleLabelChooseItsFunctions)
{
  for (const bool isShaded : { false, true })
  {
    Scene scene;
    Show(scene);
    scene.Mapper->SetClassificationToPostInterpolation();
    scene.Property->SetShade(isShaded ? 1 : 0);
    const Picture plain = DrawFloats(scene);
    SetLabel(scene, 3, 0.1, 0.8, 0.4, 0.3);
    scene.Mapper->SetMaskInput(MakeMask([](int, int, int) { return 3.0; }));
    const Picture label = DrawFloats(scene);
    scene.Mapper->SetMaskBlendFactor(0.0F);
    EXPECT_LE(LargestDifference(DrawFloats(scene), plain), 1e-2);
    EXPECT_LE(RootMeanSquare(DrawFloats(scene), plain), 1e-3);
    scene.Mapper->SetMaskInput(nullptr);
    scene.SetOpacity({ { 400.0, 0.0 }, { 700.0, 0.3 } });
    scene.SetColor({ { 0.0, 0.1, 0.8, 0.4 } });
    EXPECT_LE(RootMeanSquare(DrawFloats(scene), label), 1e-3);
  }
}

// Labels without functions of their own, and values that no label has.
TEST(Masks, OfOtherLabelsChooseTheDefault)
{
  Scene scene;
  Show(scene);
  scene.Mapper->SetClassificationToPostInterpolation();
  const Picture plain = DrawFloats(scene);
  scene.Mapper->SetMaskInput(MakeMask([](int x, int, int) { return x % 3; }));
  EXPECT_LE(LargestDifference(DrawFloats(scene), plain), 1e-2);
  SetLabel(scene, 9, 1.0, 0.0, 0.0, 1.0);
  EXPECT_LE(LargestDifference(DrawFloats(scene), plain), 1e-2);
  SetLabel(scene, 2, 1.0, 0.0, 0.0, 1.0);
  EXPECT_GE(LargestDifference(DrawFloats(scene), plain), 1e-1);
}

// Between levels, too, there are only labels that the mask has.
TEST(Masks, OfCoarseLevelsMixNoLabels)
{
  Scene scene;
  Show(scene);
  SetLabel(scene, 1, 0.0, 1.0, 0.0, 0.2);
  SetLabel(scene, 2, 1.0, 0.0, 0.0, 0.9); // between them, and nowhere
  SetLabel(scene, 3, 0.0, 0.0, 1.0, 0.2);
  scene.SetColor({ { 0.0, 0.0, 0.0, 0.0 } });
  scene.Mapper->SetMaskInput(
    MakeMask([](int x, int y, int z) { return (x / 16 + y / 16 + z / 16) % 2 ? 3.0 : 1.0; }));
  scene.Mapper->SetMaxMemoryInBytes(Beside + 1000000);
  scene.Mapper->SetLevelFilterToTent();
  const Picture picture = DrawFloats(scene);
  EXPECT_GT(scene.Mapper->GetNumberOfBricks(0), 0);
  EXPECT_GT(scene.Mapper->GetNumberOfBricks(1), 0);
  for (const auto& pixel : picture)
  {
    ASSERT_LE(pixel[0], 1e-6);
  }
}

TEST(Masks, ThatAreBinaryGoWithAllBlendModes)
{
  for (int mode = vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND; mode <= vtkVolumeMapper::SLICE_BLEND;
       ++mode)
  {
    Scene scene;
    Show(scene);
    scene.Property->GetIsoSurfaceValues()->SetValue(0, 600.0);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(25.0, 22.0, 25.0);
    plane->SetNormal(1.0, 0.5, 0.3);
    scene.Property->SetSliceFunction(plane);
    scene.Property->SetInterpolationTypeToNearest();
    scene.Mapper->SetBlendMode(mode);
    const Picture whole = DrawFloats(scene);
    scene.Mapper->SetMaskInput(MakeMask([](int x, int, int) { return x < 20 ? 1.0 : 0.0; }));
    scene.Mapper->SetMaskTypeToBinary();
    const Picture masked = DrawFloats(scene);
    EXPECT_GE(RootMeanSquare(masked, whole), 5e-3) << mode;
    scene.Mapper->SetMaskInput(nullptr);
    scene.Mapper->CroppingOn();
    scene.Mapper->SetCroppingRegionPlanes(-1.0, 19.5, -1.0, 99.0, -1.0, 99.0);
    EXPECT_LE(RootMeanSquare(DrawFloats(scene), masked), 3e-2) << mode;
  }
}

TEST(Masks, LeaveOutBlocks)
{
  Scene scene;
  Show(scene);
  scene.Draw();
  const auto all = scene.Mapper->GetNumberOfVisibleBlocks();
  scene.Mapper->SetMaskInput(MakeMask([](int x, int, int) { return x < 16 ? 1.0 : 0.0; }));
  scene.Mapper->SetMaskTypeToBinary();
  scene.Draw();
  EXPECT_LE(scene.Mapper->GetNumberOfVisibleBlocks(), all / 3);
  scene.Mapper->SetMaskInput(nullptr);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetNumberOfVisibleBlocks(), all);
}

TEST(Masks, FollowTheirChanges)
{
  Scene scene;
  Show(scene);
  const auto mask = MakeMask([](int x, int, int) { return x < 16 ? 1.0 : 0.0; });
  scene.Mapper->SetMaskInput(mask);
  scene.Mapper->SetMaskTypeToBinary();
  const Picture before = DrawFloats(scene);
  mask->GetPointData()->GetScalars()->Fill(1.0);
  mask->GetPointData()->GetScalars()->Modified();
  const Picture after = DrawFloats(scene);
  EXPECT_GE(RootMeanSquare(after, before), 1e-2);
  Scene fresh;
  Show(fresh);
  fresh.Mapper->SetMaskInput(mask);
  fresh.Mapper->SetMaskTypeToBinary();
  EXPECT_EQ(LargestDifference(DrawFloats(fresh), after), 0.0);
  scene.Mapper->SetMaskInput(MakeMask([](int x, int, int) { return x < 16 ? 1.0 : 0.0; }));
  EXPECT_EQ(LargestDifference(DrawFloats(scene), before), 0.0);
}

TEST(Masks, ThatDoNotFitAreAnError)
{
  Scene scene;
  Show(scene);
  const auto good = scene.Draw();
  const auto expectError = [&](const std::string& words)
  {
    const Messages messages = Listen(
      [&]
      {
        scene.Draw();
        scene.Draw();
      });
    ASSERT_EQ(messages.Errors.size(), 1U);
    EXPECT_NE(messages.Errors[0].find(words), std::string::npos) << messages.Errors[0];
  };
  scene.Mapper->SetMaskInput(
    MakeVolume({ 5, 5, 5 }, VTK_UNSIGNED_CHAR, [](int, int, int) { return 1; }));
  expectError("The mask needs point scalars");
  scene.Mapper->SetMaskInput(MakeMask(LabelAt));
  scene.Mapper->SetBlendModeToMaximumIntensity();
  expectError("composite blending");
  scene.Mapper->SetBlendModeToComposite();
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  expectError("1D transfer functions");
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  vtkNew<vtkPiecewiseFunction> opacity;
  scene.Property->SetLabelGradientOpacity(2, opacity);
  expectError("label 2 has one of its own");
  scene.Property->SetLabelGradientOpacity(2, nullptr);
  scene.Mapper->SetMaskInput(nullptr);
  scene.Mapper->SetBlendModeToComposite();
  EXPECT_EQ(LargestDifference(scene.Draw(), good), 0.0);
}
