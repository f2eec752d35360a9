// The light of shaded volumes.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkLight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace flatblock::testing;

namespace
{
using Mapper = vtkFlatBlockVolumeMapper;

void Show(Scene& scene)
{
  const auto image = MakeVolume({ 50, 46, 54 }, VTK_FLOAT, WavesAt);
  image->SetSpacing(1.0, 1.2, 0.9);
  scene.SetVolume(image, 0.25);
  scene.SetOpacity({ { 550.0, 0.0 }, { 650.0, 0.5 } });
  scene.SetColor({ { 500.0, 0.8, 0.3, 0.2 }, { 700.0, 0.9, 0.9, 0.7 } });
  scene.Mapper->SetBlockSize(17);
  scene.Property->ShadeOn();
  scene.Property->SetSpecular(0.3);
  scene.Property->SetSpecularPower(20.0);
  scene.LookFrom(30.0, 40.0, 1.3);
}

void AddSideLight(Scene& scene)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(400.0, 300.0, 100.0);
  light->SetFocalPoint(20.0, 20.0, 20.0);
  light->SetColor(1.0, 0.8, 0.4);
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AddLight(light);
}
} // namespace

class Shading : public testing::TestWithParam<int>
{
};

TEST_P(Shading, AgreesWithTheReference)
{
  Scene scene;
  Show(scene);
  scene.Mapper->SetClassification(GetParam());
  constexpr int Stride = 8;
  const Picture drawn = TakeEvery(DrawFloats(scene), scene.Window->GetSize()[0], Stride);
  const Picture reference = DrawReference(scene, Stride);
  const double error = RootMeanSquare(drawn, reference);
  std::cout << "error: " << error << "\n";
  // Colours that are interpolated are others.
  EXPECT_LE(error, GetParam() == Mapper::PRE_INTERPOLATION ? 0.02 : 0.002);
  EXPECT_GE(RootMeanSquare(reference, Picture(reference.size())), 0.2);
}

INSTANTIATE_TEST_SUITE_P(Classifications, Shading,
  testing::Values(Mapper::PRE_INTEGRATED, Mapper::POST_INTERPOLATION, Mapper::PRE_INTERPOLATION));

// Without highlights, which are not the same in all of VTK's versions; the reference has them.
TEST(ShadingBy, TheHeadlight)
{
  Scene scene;
  Show(scene);
  scene.Property->SetSpecular(0.0);
  EXPECT_GE(PSNR(scene.Draw(), scene.DrawWithPeer()), 38.0);
}

TEST(ShadingBy, ALightOfTheScene)
{
  Scene scene;
  Show(scene);
  AddSideLight(scene);
  EXPECT_GE(PSNR(scene.Draw(), scene.DrawWithPeer()), 30.0); // VTK's highlights are Phong's here
  EXPECT_TRUE(MatchesBaseline(scene.Window, "ShadedBySide"));
}

// A body in front of the light is lit, and what faces away is not.
TEST(ShadingBy, OneSide)
{
  Scene scene;
  Show(scene);
  const auto twoSided = scene.Draw();
  scene.Renderer->TwoSidedLightingOff();
  const auto oneSided = scene.Draw();
  EXPECT_GE(PSNR(oneSided, twoSided), 15.0);
  EXPECT_LE(PSNR(oneSided, twoSided), 40.0);
}

// Gradients reach across the borders of blocks.
TEST(ShadingBy, BlocksOfAnySide)
{
  Scene scene;
  Show(scene);
  const Picture small = DrawFloats(scene);
  scene.Mapper->SetBlockSize(65);
  EXPECT_LE(RootMeanSquare(DrawFloats(scene), small), 1e-3);
}

// Of a ramp, whose gradient is the same at every level.
TEST(ShadingBy, BlocksOfAnyLevel)
{
  Scene scene;
  Show(scene);
  scene.SetVolume(MakeVolume({ 65, 65, 65 }, VTK_FLOAT,
                    [](int x, int y, int z) { return 460.0 + x + 2.0 * y + 1.5 * z; }),
    0.25);
  scene.Mapper->SetSelectionCriterionToDistance();
  scene.Mapper->AdaptiveSamplingOff();
  const Picture fine = DrawFloats(scene);
  EXPECT_EQ(scene.Mapper->GetNumberOfBricks(1), 0);
  scene.Mapper->SetMaxMemoryInBytes(700000);
  const Picture mixed = DrawFloats(scene);
  EXPECT_GT(scene.Mapper->GetNumberOfBricks(0), 5);
  EXPECT_GT(scene.Mapper->GetNumberOfBricks(1), 5);
  EXPECT_LE(LargestDifference(mixed, fine), 2e-3);
}

// A ball whose values fall from its middle on, at levels that lie as they come.
TEST(ShadingBy, BlocksOfMixedLevelsHasNoSeams)
{
  Scene scene;
  scene.SetVolume(
    MakeVolume({ 97, 97, 97 }, VTK_FLOAT,
      [](int x, int y, int z) { return 100.0 - std::hypot(x - 48.0, y - 47.0, z - 49.0); }),
    0.25);
  scene.SetOpacity({ { 58.0, 0.0 }, { 64.0, 0.6 } });
  scene.SetColor({ { 0.0, 0.8, 0.6, 0.5 } });
  scene.Property->ShadeOn();
  scene.Property->SetSpecular(0.2);
  scene.Property->SetSpecularPower(10.0);
  scene.Mapper->SetBlockSize(65);
  scene.LookFrom(30.0, 20.0);
  const auto whole = scene.Draw();
  EXPECT_EQ(scene.Mapper->GetNumberOfBricks(1), 0);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->AdaptiveSamplingOff();
  scene.Mapper->UseCameraAsPointOfInterestOff();
  for (const std::array<double, 3>& point :
    { std::array<double, 3>{ 90.0, 60.0, 80.0 }, { 20.0, 90.0, 70.0 }, { 40.0, 10.0, 90.0 } })
  {
    scene.Mapper->SetPointOfInterest(point.data());
    scene.Mapper->SetMaxMemoryInBytes(Beside + 3000000);
    const auto mixed = scene.Draw();
    EXPECT_GT(scene.Mapper->GetNumberOfBricks(0), 10);
    EXPECT_GT(scene.Mapper->GetNumberOfBricks(1), 10);
    EXPECT_LE(ShareThatDiffers(whole, mixed, 2), 1e-3);
  }
}

// Near enough for the distance to matter, and with a cone whose edge is seen.
TEST(ShadingBy, PositionalLights)
{
  for (const double coneAngle : { 180.0, 20.0 })
  {
    Scene scene;
    Show(scene);
    scene.Property->SetSpecular(0.0); // which is another in VTK
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->PositionalOn();
    light->SetPosition(70.0, 60.0, 90.0);
    light->SetFocalPoint(25.0, 27.0, 24.0);
    light->SetConeAngle(coneAngle);
    light->SetExponent(2.0);
    light->SetAttenuationValues(0.5, 0.0, 1e-4);
    light->SetColor(1.0, 0.9, 0.6);
    scene.Renderer->RemoveAllLights();
    scene.Renderer->AddLight(light);
    const auto near = scene.Draw();
    EXPECT_GE(PSNR(near, scene.DrawWithPeer()), 33.0) << coneAngle;
    light->PositionalOff();
    EXPECT_LE(PSNR(near, scene.Draw()), 30.0);
  }
}

// Of a shell whose opacity falls where values rise: its far side faces the other way.
TEST(ShadingBy, NormalsOfOpacity)
{
  Scene scene;
  Show(scene);
  scene.Renderer->TwoSidedLightingOff();
  scene.SetOpacity({ { 500.0, 0.3 }, { 700.0, 0.1 } });
  const Picture values = DrawFloats(scene);
  scene.Mapper->ComputeNormalFromOpacityOn();
  const Picture falling = DrawFloats(scene);
  EXPECT_GE(RootMeanSquare(falling, values), 2e-2);
  scene.SetOpacity({ { 400.0, 0.0 }, { 900.0, 0.3 } }); // along values, nearly in proportion
  const Picture rising = DrawFloats(scene);
  scene.Mapper->ComputeNormalFromOpacityOff();
  EXPECT_LE(RootMeanSquare(DrawFloats(scene), rising), 2e-2);
}

// Bricks have an apron only where it is read.
TEST(ShadingBy, BricksWithAnApron)
{
  Scene scene;
  scene.SetVolume(
    MakeVolume({ 33, 33, 33 }, VTK_UNSIGNED_CHAR, [](int x, int, int) { return x; }), 0.5);
  scene.Mapper->SetBlockSize(33);
  for (int shade : { 0, 1, 0 })
  {
    scene.Property->SetShade(shade);
    scene.Window->Render();
    const int side = shade ? 35 : 33;
    EXPECT_EQ(scene.Mapper->GetUploadedBytes(), side * side * side) << shade;
  }
}

TEST(ShadingBy, ShadowsOfSkipping)
{
  Scene scene;
  Show(scene);
  const Picture leapt = DrawFloats(scene);
  scene.Mapper->SetSkippingToNothing();
  EXPECT_LE(LargestDifference(DrawFloats(scene), leapt), 1.0 / 255.0);
}

TEST(ShadingOpacityThreshold, IsTheErrorOfAPiece)
{
  Scene scene;
  Show(scene);
  scene.Mapper->SetShadingOpacityThreshold(1e-3);
  const Picture fast = DrawFloats(scene);
  scene.Mapper->SetShadingOpacityThreshold(0.0);
  const Picture exact = DrawFloats(scene);
  const double difference = LargestDifference(fast, exact);
  EXPECT_LE(difference, 0.05); // of some fifty such pieces along a ray
  EXPECT_GT(difference, 0.0);
}

TEST(ShadingOf, HolesAndCoarseLevelsIsSound)
{
  Scene scene;
  Show(scene);
  scene.SetVolume(
    MakeVolume({ 50, 46, 54 }, VTK_FLOAT,
      [](int x, int y, int z) { return x * y * z % 97 == 5 ? std::nan("") : WavesAt(x, y, z); }),
    0.5);
  scene.Mapper->SetMaxMemoryInBytes(400000);
  EXPECT_TRUE(IsSound(DrawFloats(scene)));
}
