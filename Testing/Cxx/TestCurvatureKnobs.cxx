// What a user sets of curvature: colours, opacity, outlines, and what all that costs.
#include "CurvaturePicture.h"
#include "Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace flatblock::testing;

namespace
{
using Mapper = vtkFlatBlockVolumeMapper;

void ShowTorus(Scene& scene)
{
  ShowField(scene, GetCurvatureField("torus"), 48);
}

double GetFetches(Scene& scene)
{
  scene.Mapper->CountSamplesOn();
  scene.Window->Render();
  scene.Mapper->CountSamplesOff();
  return scene.Mapper->GetFetchesPerRay();
}
} // namespace

TEST(CurvatureColor, OfItsOwnRangeIsOverTheFunctionsValue)
{
  Scene scene;
  ShowTorus(scene);
  scene.Mapper->SetCurvatureFunctionToMean();
  scene.Mapper->SetCurvatureColor(MakeGray(0.0, 8.0));
  scene.Mapper->SetCurvatureRange(0.0, 8.0);
  const Picture whole = DrawFloats(scene);
  scene.Mapper->SetCurvatureColor(MakeGray(-1.0, 0.0));
  EXPECT_LT(LargestDifference(DrawFloats(scene), whole), 1e-6); // stretched
  scene.Mapper->SetCurvatureRange(0.0, 16.0);
  const Picture half = DrawFloats(scene);
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    ASSERT_NEAR(half[i][0], 0.5 * whole[i][0], 1e-5);
  }
}

TEST(CurvatureColor, HasAnAutomaticRangeWithEndsInside)
{
  Scene scene;
  ShowTorus(scene);
  const double spacing = 2.0 / 47.0;
  scene.Mapper->SetCurvatureFunctionToSecondPrincipal();
  scene.Mapper->SetCurvatureColor(MakeGray(0.0, 1.0));
  const Picture automatic = DrawFloats(scene);
  double range[2];
  scene.Mapper->GetUsedCurvatureRange(range);
  EXPECT_NEAR(range[1], 0.25 / spacing, 1e-9);
  EXPECT_NEAR(range[0], -range[1], 1e-9);
  scene.Mapper->SetCurvatureRange(range);
  const Picture same = DrawFloats(scene);
  for (std::size_t i = 0; i < same.size(); ++i)
  {
    ASSERT_NEAR(automatic[i][0], same[i][3] > 0.0 ? 0.02 + 0.96 * same[i][0] : 0.0, 1e-5);
  }
  scene.Mapper->SetCurvatureRange(-1e-6, 1e-6); // cut off at both ends
  for (const auto& pixel : DrawFloats(scene))
  {
    ASSERT_TRUE(pixel[0] < 1e-3 || pixel[0] > 0.999 || pixel[3] < 1.0);
  }
  scene.Mapper->SetCurvatureRange(0.0, 0.0);
  for (const int function : { Mapper::TOTAL, Mapper::GAUSSIAN, Mapper::SHAPE_INDEX })
  {
    scene.Mapper->SetCurvatureFunction(function);
    scene.Window->Render();
    scene.Mapper->GetUsedCurvatureRange(range);
    EXPECT_EQ(range[0], function == Mapper::TOTAL ? 0.0 : -range[1]);
    EXPECT_NEAR(range[1],
      std::pow(0.25 / spacing, function == Mapper::TOTAL      ? 1.0
                               : function == Mapper::GAUSSIAN ? 2.0
                                                              : 0.0),
      1e-9);
  }
}

TEST(CurvatureColor, ShowsAnEditOfItsFunctions)
{
  Scene scene;
  ShowCloud(scene);
  const auto gray = MakeGray(-0.1, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  scene.Mapper->SetCurvatureFunctionToMean();
  scene.Mapper->SetCurvatureColor(gray);
  scene.Mapper->SetCurvatureOpacity(opacity);
  scene.Mapper->SetCurvatureRange(-0.1, 0.1);
  const Picture first = DrawFloats(scene);
  opacity->AddPoint(-0.1, 0.25);
  opacity->AddPoint(0.1, 0.25);
  const Picture thin = DrawFloats(scene);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    // A quarter of the optical depth.
    ASSERT_NEAR(std::log1p(-std::min(thin[i][3], 1.0 - 1e-9)),
      0.25 * std::log1p(-std::min(first[i][3], 1.0 - 1e-9)), first[i][3] > 0.98 ? 2.0 : 2e-3);
  }
  gray->AddRGBPoint(-0.1, 1.0, 1.0, 1.0);
  for (const auto& pixel : DrawFloats(scene))
  {
    ASSERT_NEAR(pixel[0], pixel[3], 1e-5);
  }
}

TEST(CurvatureColor, KeepsSharesOfOpacityFrom0To1)
{
  Scene scene;
  ShowCloud(scene);
  vtkNew<vtkPiecewiseFunction> opacity;
  scene.Mapper->SetCurvatureFunctionToMean();
  scene.Mapper->SetCurvatureOpacity(opacity);
  const auto draw = [&](double share)
  {
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.0, share);
    opacity->AddPoint(1.0, share);
    return DrawFloats(scene);
  };
  EXPECT_EQ(LargestDifference(draw(7.0), draw(1.0)), 0.0);
  const Picture none = draw(-7.0);
  EXPECT_EQ(LargestDifference(none, Picture(none.size())), 0.0);
}

TEST(CurvatureColor, IsRefusedWhereItIsNotFinite)
{
  Scene scene;
  ShowCloud(scene);
  scene.Mapper->SetCurvatureFunctionToMean();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.5);
  opacity->AddPoint(1.0, std::nan(""));
  scene.Mapper->SetCurvatureOpacity(opacity);
  const Messages messages = Listen([&scene] { scene.Window->Render(); });
  ASSERT_EQ(messages.Errors.size(), 1U);
  EXPECT_NE(messages.Errors[0].find("CurvatureOpacity"), std::string::npos);
}

// What curvature makes transparent hides nothing.
TEST(CurvatureOpacity, IsNotTakenForDense)
{
  Scene scene;
  ShowCloud(scene);
  scene.SetOpacity({ { 0.0, 1.0 }, { 1000.0, 1.0 } });
  scene.Mapper->SetSelectionCriterionToDistortion();
  scene.Mapper->SetCurvatureFunctionToMean();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.01);
  opacity->AddPoint(1.0, 0.01);
  scene.Mapper->SetCurvatureOpacity(opacity);
  scene.Window->Render();
  scene.Mapper->SetMaxMemoryInBytes(scene.Mapper->GetMemoryInBytes() / 2);
  const Picture plain = DrawFloats(scene);
  scene.Mapper->VisibilityWeightingOn();
  EXPECT_EQ(LargestDifference(DrawFloats(scene), plain), 0.0);
}

// On a ball of radius r what turns away within the width T is a ring that is T wide, whatever r.
TEST(Silhouettes, AreAsWideAsAsked)
{
  for (const double radius : { 10.0, 25.0 })
  {
    Scene scene;
    scene.SetVolume(
      MakeVolume({ 64, 64, 64 }, VTK_FLOAT,
        [](int x, int y, int z) { return 100.0 - std::hypot(x - 31.5, y - 31.5, z - 31.5); }),
      0.25);
    scene.Mapper->SetBlendMode(vtkVolumeMapper::ISOSURFACE_BLEND);
    scene.Property->GetIsoSurfaceValues()->SetValue(0, 100.0 - radius);
    scene.SetOpacity({ { 0.0, 1.0 }, { 100.0, 1.0 } });
    scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 }, { 100.0, 1.0, 1.0, 1.0 } });
    scene.Mapper->SetReconstructionFilterToCubicBSpline();
    scene.LookFrom(0.0, 0.0, 1.0);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(32.0); // 4 pixels a sample
    const double width = 2.0;
    scene.Mapper->SetSilhouetteWidth(width);
    scene.Mapper->SetSilhouetteColor(1.0, 0.0, 0.0);
    double area = 0.0;
    for (const auto& pixel : DrawFloats(scene))
    {
      area += pixel[3] - pixel[1];
    }
    const double inner = radius - width;
    const double expected = 16.0 * vtkMath::Pi() * (radius * radius - inner * inner);
    EXPECT_NEAR(area / expected, 1.0, 0.06) << radius;
  }
}

TEST(Silhouettes, AreNotOnFlatSurfaces)
{
  Scene scene;
  scene.SetVolume(
    MakeVolume({ 32, 32, 32 }, VTK_FLOAT, [](int x, int, int) { return 1.0 * x; }), 0.25);
  scene.Mapper->SetBlendMode(vtkVolumeMapper::ISOSURFACE_BLEND);
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 15.5);
  scene.SetOpacity({ { 0.0, 1.0 }, { 100.0, 1.0 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 }, { 100.0, 1.0, 1.0, 1.0 } });
  scene.LookFrom(85.0, 0.0, 1.2);
  const Picture plain = DrawFloats(scene);
  scene.Mapper->SetSilhouetteWidth(1.0);
  EXPECT_LT(LargestDifference(DrawFloats(scene), plain), 1e-3);
}

TEST(GradientModulation, ScalesTheMaterialByTheGradient)
{
  // Values rise by 1/8 of the range from sample to sample: half of the steepest.
  Scene scene;
  scene.SetVolume(
    MakeVolume({ 9, 33, 33 }, VTK_FLOAT, [](int x, int, int) { return 10.0 * x; }), 0.25);
  scene.SetOpacity({ { 0.0, 0.2 }, { 100.0, 0.2 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 }, { 100.0, 1.0, 1.0, 1.0 } });
  scene.Property->ShadeOn();
  scene.Property->SetAmbient(0.2);
  scene.Property->SetDiffuse(0.4);
  scene.Property->SetSpecular(0.3);
  scene.Property->SetSpecularPower(1.0);
  scene.LookFrom(90.0, 0.0, 1.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  const auto brightness = [&scene](double ambient, double diffuse, double specular)
  {
    scene.Mapper->SetGradientModulation(ambient, diffuse, specular);
    const Picture picture = DrawFloats(scene);
    const auto& pixel = picture[128 * 256 + 128];
    return pixel[0] / pixel[3];
  };
  EXPECT_NEAR(brightness(0.0, 0.0, 0.0), 0.9, 2e-3);
  EXPECT_NEAR(brightness(1.0, 0.0, 0.0), 0.8, 2e-3);
  EXPECT_NEAR(brightness(0.0, 1.0, 0.0), 0.7, 2e-3);
  EXPECT_NEAR(brightness(0.0, 0.0, 0.5), 0.825, 2e-3);
}

TEST(CurvatureKnobs, CostNothingWhereTheyAreOff)
{
  Scene scene;
  ShowCloud(scene);
  scene.Mapper->SetCurvatureColor(MakeGray(0.0, 1.0));
  scene.Mapper->SetCurvatureRange(1.0, 2.0);
  scene.Mapper->SetInterpolatingBSpline(true);
  scene.Mapper->SetDerivativesOnDemand(false);
  const double fetches = GetFetches(scene);
  const vtkTypeInt64 memory = scene.Mapper->GetMemoryInBytes();
  Scene plain;
  ShowCloud(plain);
  EXPECT_EQ(fetches, GetFetches(plain));
  EXPECT_EQ(memory, plain.Mapper->GetMemoryInBytes());
  plain.Mapper->SetCurvatureFunctionToMean();
  EXPECT_GT(GetFetches(plain), fetches);
  EXPECT_GT(plain.Mapper->GetMemoryInBytes(), memory); // an apron, and a table
}

TEST(CurvatureKnobs, OnDemandDrawsTheSameWithFewerFetches)
{
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    Scene scene;
    ShowCloud(scene);
    scene.Mapper->SetReconstructionFilter(filter);
    scene.Mapper->SetCurvatureFunctionToShapeIndex();
    scene.Property->ShadeOn();
    const Picture onDemand = DrawFloats(scene);
    const double few = GetFetches(scene);
    scene.Mapper->DerivativesOnDemandOff();
    EXPECT_LT(LargestDifference(DrawFloats(scene), onDemand), 1.0 / 255.0);
    EXPECT_GT(GetFetches(scene), 1.5 * few);
  }
}

TEST(CurvatureKnobs, StillsMayHaveAnotherFilter)
{
  Scene scene;
  ShowCloud(scene);
  scene.Mapper->SetCurvatureFunctionToShapeIndex();
  scene.Mapper->AutoAdjustSampleDistancesOff();
  const Picture linear = DrawFloats(scene);
  scene.Mapper->SetReconstructionFilterToCubicBSpline();
  const Picture spline = DrawFloats(scene);
  EXPECT_GT(LargestDifference(linear, spline), 0.01);
  scene.Mapper->SetReconstructionFilterToLinear();
  scene.Mapper->SetStillReconstructionFilterToCubicBSpline();
  EXPECT_EQ(LargestDifference(DrawFloats(scene), spline), 0.0);
  scene.Window->SetDesiredUpdateRate(30.0);
  EXPECT_LT(LargestDifference(DrawFloats(scene), linear), 1e-4); // leaps are shorter
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);                // bricks are for both
  scene.Window->SetDesiredUpdateRate(0.001);
  EXPECT_EQ(LargestDifference(DrawFloats(scene), spline), 0.0);
}

TEST(CurvatureKnobs, WarnWhereTheyAreIgnored)
{
  Scene scene;
  ShowCloud(scene);
  scene.Mapper->SetCurvatureFunctionToMean();
  scene.Mapper->SetBlendModeToMaximumIntensity();
  const Messages messages = Listen([&scene] { scene.Window->Render(); });
  ASSERT_EQ(messages.Warnings.size(), 1U);
  EXPECT_NE(messages.Warnings[0].find("curvature in blend modes"), std::string::npos);
  EXPECT_TRUE(messages.Errors.empty());
}
