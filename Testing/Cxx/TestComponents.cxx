// Arrays of several components: independent ones with their own functions, or colours with opacity.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace flatblock::testing;

namespace
{
constexpr int Side = 48;

double WaveOf(int component, int x, int y, int z)
{
  const double phase = 0.9 * component;
  return std::round(127.0 + 120.0 * std::sin(0.2 * x + phase) * std::cos(0.17 * y - phase) *
                              std::sin(0.15 * z + 2.0 * phase + 1.0));
}

vtkSmartPointer<vtkImageData> MakeWave(int component, int type = VTK_UNSIGNED_CHAR)
{
  return MakeVolume({ Side, Side, Side }, type,
    [component](int x, int y, int z) { return WaveOf(component, x, y, z); });
}

vtkSmartPointer<vtkImageData> MakeWaves(int components, int type = VTK_UNSIGNED_CHAR)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  image->AllocateScalars(type, components);
  for (int i = 0; i < components; ++i)
  {
    image->GetPointData()->GetScalars()->CopyComponent(
      i, MakeWave(i, type)->GetPointData()->GetScalars(), 0);
  }
  return image;
}

void SetFunctions(Scene& scene, int component, double opacity)
{
  constexpr std::array<double, 3> Colors[] = { { 1.0, 0.3, 0.2 }, { 0.2, 0.9, 0.3 },
    { 0.3, 0.4, 1.0 }, { 1.0, 1.0, 0.3 } };
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(140.0, 0.0);
  function->AddPoint(230.0, opacity);
  scene.Property->SetScalarOpacity(component, function);
  const std::array<double, 3>& color = Colors[component];
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.5 * color[0], 0.5 * color[1], 0.5 * color[2]);
  colors->AddRGBPoint(255.0, color[0], color[1], color[2]);
  scene.Property->SetColor(component, colors);
}

void Show(Scene& scene, vtkImageData* image, int components, bool areIndependent)
{
  scene.SetVolume(image, 0.5);
  scene.Property->SetIndependentComponents(areIndependent ? 1 : 0);
  for (int i = 0; i < components; ++i)
  {
    SetFunctions(scene, i, 0.15);
  }
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.3);
}

struct Kind
{
  int Components;
  bool AreIndependent;
};
constexpr Kind Kinds[] = { { 2, true }, { 3, true }, { 4, true }, { 2, false }, { 4, false } };
} // namespace

TEST(Components, AreDrawnAsThePeerDoes)
{
  for (const Kind& kind : Kinds)
  {
    for (const int type : { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT })
    {
      // Of opacities of 16 bit the peer shows nothing.
      if (type == VTK_UNSIGNED_SHORT && kind.Components == 4 && !kind.AreIndependent)
      {
        continue;
      }
      for (const bool isShaded : { false, true })
      {
        Scene scene;
        Show(scene, MakeWaves(kind.Components, type), kind.Components, kind.AreIndependent);
        for (int i = 0; i < kind.Components; ++i)
        {
          scene.Property->SetComponentWeight(i, kind.AreIndependent ? 0.3 + 0.2 * i : 1.0);
          scene.Property->SetShade(i, isShaded ? 1 : 0);
        }
        const auto ours = scene.Draw();
        EXPECT_TRUE(ShowsSomething(ours));
        EXPECT_GE(PSNR(ours, scene.DrawWithPeer()), 38.0)
          << kind.Components << " " << kind.AreIndependent << " " << isShaded;
      }
    }
  }
}

TEST(Components, HaveMaterialsOfTheirOwn)
{
  Scene scene;
  Show(scene, MakeWaves(2), 2, true);
  for (int i = 0; i < 2; ++i)
  {
    scene.Property->SetShade(i, 1);
    scene.Property->SetSpecular(i, 0.0);
  }
  const auto same = scene.Draw();
  scene.Property->SetAmbient(1, 0.6);
  scene.Property->SetDiffuse(1, 0.1);
  const auto ours = scene.Draw();
  EXPECT_GE(PSNR(ours, scene.DrawWithPeer()), 38.0);
  EXPECT_LE(PSNR(ours, same), 34.0);
}

// A component that alone has weight is drawn as if it were the only one.
TEST(Components, WithoutWeightAreNotSeen)
{
  for (int alone = 0; alone < 3; ++alone)
  {
    Scene scene;
    Show(scene, MakeWaves(3), 3, true);
    for (int i = 0; i < 3; ++i)
    {
      scene.Property->SetComponentWeight(i, i == alone ? 1.0 : 0.0);
    }
    const Picture picture = DrawFloats(scene);
    scene.Mapper->SetInputData(MakeWave(alone));
    SetFunctions(scene, alone, 0.15);
    vtkNew<vtkVolumeProperty> property;
    property->DeepCopy(scene.Property);
    scene.Property->SetScalarOpacity(0, property->GetScalarOpacity(alone));
    scene.Property->SetColor(0, property->GetRGBTransferFunction(alone));
    EXPECT_LE(RootMeanSquare(DrawFloats(scene), picture), 1e-3) << alone;
  }
}

// As with the peer: the light is the weighted sum, and the opacity that of a mean.
TEST(Components, OfTheSameMatterShineTogether)
{
  Scene scene;
  Show(scene, MakeWave(0), 1, true);
  scene.Mapper->SetClassificationToPostInterpolation();
  const Picture one = DrawFloats(scene);
  const auto image = MakeWaves(2);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  values->CopyComponent(1, MakeWave(0)->GetPointData()->GetScalars(), 0);
  scene.Property->SetScalarOpacity(1, scene.Property->GetScalarOpacity(0));
  scene.Property->SetColor(1, scene.Property->GetRGBTransferFunction(0));
  scene.Mapper->SetInputData(image);
  const Picture two = DrawFloats(scene);
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    ASSERT_NEAR(two[i][3], one[i][3], 2e-3);
    ASSERT_NEAR(two[i][0], 2.0 * one[i][0], 2e-3);
  }
}

TEST(Components, OfColoursAreThoseOfThePicture)
{
  Scene scene;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(20, 20, 20);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  constexpr std::array<double, 4> Color = { 100.0, 50.0, 200.0, 255.0 };
  for (int i = 0; i < 4; ++i)
  {
    image->GetPointData()->GetScalars()->FillComponent(i, Color[i]);
  }
  scene.SetVolume(image, 0.5);
  scene.Property->IndependentComponentsOff();
  scene.SetOpacity({ { 0.0, 0.0 }, { 255.0, 1.0 } });
  scene.LookFrom(0.0, 0.0, 4.0);
  for (const auto& pixel : DrawFloats(scene))
  {
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_NEAR(pixel[i], Color[i] / 255.0, 1e-5);
    }
  }
}

TEST(Components, DoNotShowBlocksAndGoOnAtCoarseLevels)
{
  for (const Kind& kind : Kinds)
  {
    Scene scene;
    Show(scene, MakeWaves(kind.Components), kind.Components, kind.AreIndependent);
    for (int i = 0; i < kind.Components; ++i)
    {
      scene.Property->SetShade(i, 1);
    }
    const Picture blocks = DrawFloats(scene);
    const auto fine = scene.Draw();
    scene.Mapper->SetBlockSize(65);
    scene.Mapper->SetSkipping(0);
    EXPECT_LE(RootMeanSquare(DrawFloats(scene), blocks), 2e-4) << kind.Components;
    scene.Mapper->SetBlockSize(17);
    scene.Mapper->SetSkipping(2);
    scene.Mapper->SetSelectionCriterionToDistortion();
    const vtkTypeInt64 limit = Beside + 60000 * (kind.Components == 3 ? 4 : kind.Components);
    scene.Mapper->SetMaxMemoryInBytes(limit);
    scene.Draw();
    EXPECT_GE(PSNR(scene.Draw(), fine), 22.0) << kind.Components;
    EXPECT_LE(scene.Mapper->GetPeakMemoryInBytes(), limit);
    EXPECT_GT(scene.Mapper->GetNumberOfBricks(1), 0);
  }
}

TEST(Components, ThatAreNotFiniteAreHoles)
{
  Scene scene;
  const auto image = MakeWaves(2, VTK_FLOAT);
  Show(scene, image, 2, true);
  const Picture whole = DrawFloats(scene);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); i += 97)
  {
    values->SetComponent(i, 1, std::nan(""));
  }
  values->Modified();
  Picture holes;
  EXPECT_EQ(Listen([&] { holes = DrawFloats(scene); }).Warnings.size(), 1U);
  EXPECT_TRUE(IsSound(holes));
  EXPECT_GE(RootMeanSquare(whole, holes), 1e-3);
}

TEST(Components, ChangeFromOneFrameToTheNext)
{
  Scene scene;
  Show(scene, MakeWave(0), 1, true);
  const Picture one = DrawFloats(scene);
  for (int i = 1; i < 4; ++i)
  {
    SetFunctions(scene, i, 0.15);
  }
  scene.Mapper->SetInputData(MakeWaves(4));
  const Picture four = DrawFloats(scene);
  scene.Property->IndependentComponentsOff();
  const Picture colors = DrawFloats(scene);
  EXPECT_GE(RootMeanSquare(four, colors), 1e-2);
  scene.Property->IndependentComponentsOn();
  EXPECT_EQ(LargestDifference(DrawFloats(scene), four), 0.0);
  scene.Mapper->SetInputData(MakeWave(0));
  EXPECT_EQ(LargestDifference(DrawFloats(scene), one), 0.0);
}

TEST(Components, OfAnotherBlendModeAreAnError)
{
  Scene scene;
  Show(scene, MakeWaves(2), 2, true);
  const auto good = scene.Draw();
  scene.Mapper->SetBlendModeToIsoSurface();
  const Messages messages = Listen([&] { scene.Draw(); });
  ASSERT_EQ(messages.Errors.size(), 1U);
  EXPECT_NE(messages.Errors[0].find("2 components"), std::string::npos);
  scene.Mapper->SetBlendModeToComposite();
  EXPECT_EQ(LargestDifference(scene.Draw(), good), 0.0);
}

TEST(Components, WithoutAnyWeightShowNothing)
{
  Scene scene;
  Show(scene, MakeWaves(2), 2, true);
  scene.Property->SetComponentWeight(0, 0.0);
  scene.Property->SetComponentWeight(1, 0.0);
  for (const auto& pixel : DrawFloats(scene))
  {
    ASSERT_EQ(pixel[3], 0.0);
  }
}

// Of two that are the same, each with half of the weight, what one of them gives.
TEST(Components, HaveTheExtremesAndSumsOfEach)
{
  for (const int mode :
    { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND,
      vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND })
  {
    Scene scene;
    Show(scene, MakeWave(0), 1, true);
    scene.Mapper->SetBlendMode(mode);
    scene.Mapper->SetAverageIPScalarRange(60.0, 220.0);
    const Picture one = DrawFloats(scene);
    const auto image = MakeWaves(2);
    image->GetPointData()->GetScalars()->CopyComponent(
      1, MakeWave(0)->GetPointData()->GetScalars(), 0);
    scene.Property->SetScalarOpacity(1, scene.Property->GetScalarOpacity(0));
    scene.Property->SetColor(1, scene.Property->GetRGBTransferFunction(0));
    scene.Property->SetComponentWeight(0, 0.5);
    scene.Property->SetComponentWeight(1, 0.5);
    scene.Mapper->SetInputData(image);
    EXPECT_LE(LargestDifference(DrawFloats(scene), one), 1e-4) << mode;
  }
}
