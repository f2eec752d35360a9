// Curvature against the reference on the CPU, against closed forms, and where there is none.
#include "CurvaturePicture.h"
#include "Volumes.h"

#include "vtkColorTransferFunction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace flatblock::testing;

namespace
{
using Mapper = vtkFlatBlockVolumeMapper;

// 1/length: the cube is 2 long, and the fields bend up to 10 or so.
double GetMost(int function)
{
  return function == Mapper::SHAPE_INDEX ? 1.0 : function == Mapper::GAUSSIAN ? 400.0 : 20.0;
}

struct Errors
{
  double Mean = 0.0;
  double OfMost = 0.0; // but for a hundredth
};

template <typename Expected>
Errors Compare(const std::vector<CurvaturePixel>& pixels, const Expected& expected)
{
  std::vector<double> errors;
  for (const CurvaturePixel& pixel : pixels)
  {
    errors.push_back(std::abs(pixel.Value - expected(pixel)));
  }
  std::sort(errors.begin(), errors.end());
  return { std::accumulate(errors.begin(), errors.end(), 0.0) / errors.size(),
    errors[errors.size() * 99 / 100] };
}

void ShowSmallField(Scene& scene, const char* name, int n, int filter)
{
  scene.Window->SetSize(96, 96);
  ShowField(scene, GetCurvatureField(name), n);
  scene.Mapper->SetReconstructionFilter(filter);
}

// Mean error of a principal curvature against that of the formula where the ray meets the surface.
double MeasureError(const char* name, int n, int filter, int function)
{
  Scene scene;
  ShowSmallField(scene, name, n, filter);
  const SampledField field(ReadReferenceVolume(scene), GetFilter(scene));
  auto pixels = FindPixels(scene, field);
  MeasureCurvature(scene, function, GetMost(function), pixels);
  EXPECT_GT(pixels.size(), 500U);
  return Compare(pixels,
    [&](const CurvaturePixel& pixel)
    {
      std::array<double, 3> point;
      std::transform(pixel.Point.begin(), pixel.Point.end(), point.begin(),
        [n](double sample) { return 2.0 * sample / (n - 1) - 1.0; });
      return GetCurvature(
        function, GetPrincipalCurvatures(GetCurvatureField(name).Derivatives(point)));
    })
    .Mean;
}

} // namespace

TEST(Curvature, AgreesWithTheReference)
{
  for (const char* name : { "torus", "Gaussians" })
  {
    for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
    {
      Scene scene;
      ShowSmallField(scene, name, 32, filter);
      const SampledField field(ReadReferenceVolume(scene), GetFilter(scene));
      const auto toLength = GetReferenceView(scene).SampleToLength;
      auto pixels = FindPixels(scene, field);
      for (int function = Mapper::FIRST_PRINCIPAL; function <= Mapper::LINE_FEATURE; ++function)
      {
        MeasureCurvature(scene, function, GetMost(function), pixels);
        ASSERT_GT(pixels.size(), 1000U);
        const Errors errors = Compare(pixels,
          [&](const CurvaturePixel& pixel)
          {
            return GetCurvature(function,
              GetPrincipalCurvatures(ToLengths(field.GetDerivatives(pixel.Point), toLength)));
          });
        EXPECT_LT(errors.Mean, 2e-4 * GetMost(function)) << name << CurvatureNames[function];
        EXPECT_LT(errors.OfMost, 5e-3 * GetMost(function)) << name << CurvatureNames[function];
      }
    }
  }
}

// A quarter of the spacing leaves a 16th of the error, or nearly so. Samples lie at the same
// places.
TEST(Curvature, ConvergesWithTheSquareOfTheSpacing)
{
  for (const char* name : { "ellipsoid", "torus", "cylinder", "saddle", "gyroid", "Gaussians" })
  {
    for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
    {
      const double coarse = MeasureError(name, 17, filter, Mapper::FIRST_PRINCIPAL);
      const double fine = MeasureError(name, 65, filter, Mapper::FIRST_PRINCIPAL);
      EXPECT_GT(coarse / fine, 11.0) << name << filter << " " << coarse << " " << fine;
    }
  }
}

// To the rounding of the samples, which second differences are small beside.
TEST(Curvature, OfABallIsTheSameAllAround)
{
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    for (int function : { Mapper::FIRST_PRINCIPAL, Mapper::SECOND_PRINCIPAL })
    {
      EXPECT_LT(MeasureError("sphere", 33, filter, function), 2e-3 / 0.6) << filter << function;
    }
  }
}

TEST(Curvature, IsThatOfTheDataSetsLengths)
{
  const double radius = 20.0;
  for (const auto& spacing : { std::array<double, 3>{ 1.0, 1.0, 1.0 },
         std::array<double, 3>{ 0.8, 1.3, 1.0 }, std::array<double, 3>{ 1.0, 1.0, 1.6 } })
  {
    for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
    {
      Scene scene;
      ShowBall(scene, spacing);
      scene.Mapper->SetReconstructionFilter(filter);
      scene.Volume->SetScale(0.5, 2.0, 1.0); // not the data set's
      scene.LookFrom(30.0, 40.0, 1.2);
      scene.Mapper->SetCurvatureColor(MakeGray(0.0, 1.0));
      scene.Mapper->SetCurvatureRange(0.0, 2.0 / radius);
      const auto pixel = GetCenter(DrawFloats(scene), 256);
      ASSERT_GT(pixel[3], 0.1);
      EXPECT_NEAR(pixel[0] / pixel[3], 0.5, 0.02);
    }
  }
}

TEST(Curvature, TurnsWithTheDirectionOfTheData)
{
  Scene scene;
  ShowBall(scene, { 0.8, 1.3, 1.0 });
  scene.Mapper->SetCurvatureFunctionToFirstPrincipal();
  scene.Mapper->SetCurvatureRange(0.0, 0.1);
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetInput());
  const double c = std::sqrt(0.5);
  image->SetDirectionMatrix(c, -c, 0.0, c, c, 0.0, 0.0, 0.0, 1.0);
  scene.LookFrom(30.0, 40.0, 1.2);
  const auto pixel = GetCenter(DrawFloats(scene), 256);
  scene.Mapper->SetCurvatureColor(MakeGray(0.0, 1.0));
  const auto measured = GetCenter(DrawFloats(scene), 256);
  ASSERT_GT(pixel[3], 0.1);
  EXPECT_NEAR(measured[0] / measured[3], 0.5, 0.02);
}

TEST(Curvature, DoesNotShowBlocks)
{
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    for (const bool isShaded : { false, true })
    {
      Scene scene;
      ShowCloud(scene);
      scene.Property->SetShade(isShaded);
      scene.Mapper->SetReconstructionFilter(filter);
      scene.Mapper->SetCurvatureFunctionToShapeIndex();
      const Picture blocks = DrawFloats(scene);
      scene.Mapper->SetBlockSize(65);
      scene.Mapper->SetSkipping(Mapper::SKIP_NOTHING);
      EXPECT_LT(LargestDifference(DrawFloats(scene), blocks), 1.0 / 255.0);
    }
  }
}

// On the faces of the cube, as well.
TEST(Curvature, AtTheVolumesFacesIsAsInside)
{
  for (const char* name : { "cylinder", "gyroid" })
  {
    for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
    {
      Scene scene;
      ShowSmallField(scene, name, 33, filter);
      const SampledField field(ReadReferenceVolume(scene), GetFilter(scene));
      auto pixels = FindPixels(scene, field, 0.0);
      MeasureCurvature(scene, Mapper::FIRST_PRINCIPAL, 20.0, pixels);
      const Errors errors = Compare(pixels,
        [&](const CurvaturePixel& pixel)
        {
          std::array<double, 3> point;
          std::transform(pixel.Point.begin(), pixel.Point.end(), point.begin(),
            [](double sample) { return sample / 16.0 - 1.0; });
          return GetPrincipalCurvatures(GetCurvatureField(name).Derivatives(point)).First;
        });
      EXPECT_LT(errors.OfMost, 0.25) << name << filter; // a tenth
    }
  }
}

// A ball is as round in coarse blocks as in fine ones, and where they meet.
TEST(Curvature, OfCoarseLevelsShowsNoSeams)
{
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    Scene scene;
    ShowBall(scene, { 1.0, 1.0, 1.0 });
    scene.Mapper->SetReconstructionFilter(filter);
    scene.Mapper->SetCurvatureColor(MakeGray(0.0, 1.0));
    scene.Mapper->SetCurvatureRange(0.0, 0.1);
    scene.Window->Render();
    scene.Mapper->SetMaxMemoryInBytes(scene.Mapper->GetMemoryInBytes() * 7 / 10);
    scene.Window->Render();
    ASSERT_GT(scene.Mapper->GetNumberOfBricks(0), 0);
    ASSERT_GT(scene.Mapper->GetNumberOfBricks(1), 0);
    double largest = 0.0;
    for (const auto& pixel : DrawFloats(scene))
    {
      largest = pixel[3] > 0.3 ? std::max(largest, std::abs(pixel[0] / pixel[3] - 0.5)) : largest;
    }
    EXPECT_LT(largest, 0.05) << filter;
  }
}

// What is drawn of one component may have a mask, or a second array that opacity follows.
TEST(Curvature, IsSeenThroughAMask)
{
  Scene scene;
  ShowBall(scene, { 1.0, 1.0, 1.0 });
  const auto mask =
    MakeVolume({ 64, 64, 64 }, VTK_UNSIGNED_CHAR, [](int x, int, int) { return x < 40 ? 255 : 0; });
  scene.Mapper->SetMaskInput(mask);
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  white->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
  scene.Mapper->SetCurvatureColor(white);
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    scene.Mapper->SetReconstructionFilter(filter);
    double seen = 0.0;
    for (const auto& pixel : DrawFloats(scene))
    {
      ASSERT_NEAR(pixel[1], pixel[3], 1e-5);
      seen += pixel[3];
    }
    EXPECT_GT(seen, 1000.0);
  }
}
