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

// A translucent ball of radius 20, in colours of its mean curvature.
void ShowBall(Scene& scene, const std::array<double, 3>& spacing, vtkImageData* shape = nullptr)
{
  const auto image = shape ? vtkSmartPointer<vtkImageData>(shape)
                           : MakeVolume({ 64, 64, 64 }, VTK_FLOAT,
                               [&](int x, int y, int z)
                               {
                                 return 100.0 - std::hypot((x - 31.5) * spacing[0],
                                                  (y - 31.5) * spacing[1], (z - 31.5) * spacing[2]);
                               });
  image->SetSpacing(spacing.data());
  scene.SetVolume(image, 0.25);
  scene.SetOpacity({ { 79.0, 0.0 }, { 80.0, 0.4 }, { 81.0, 0.0 } });
  scene.Mapper->SetCurvatureFunctionToMean();
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.2);
}

std::array<double, 4> GetCenter(const Picture& picture, int width)
{
  return picture[picture.size() / 2 + width / 2];
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
      vtkNew<vtkColorTransferFunction> gray;
      gray->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
      gray->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
      scene.Mapper->SetCurvatureColor(gray);
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
  vtkNew<vtkColorTransferFunction> gray;
  gray->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
  gray->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
  scene.Mapper->SetCurvatureColor(gray);
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
      scene.SetVolume(MakeWaves(), 0.2);
      scene.SetOpacity({ { 500.0, 0.0 }, { 650.0, 0.2 } });
      scene.Property->SetShade(isShaded);
      scene.Mapper->SetReconstructionFilter(filter);
      scene.Mapper->SetCurvatureFunctionToShapeIndex();
      scene.Mapper->SetBlockSize(17);
      scene.LookFrom(30.0, 40.0, 1.3);
      const Picture blocks = DrawFloats(scene);
      scene.Mapper->SetBlockSize(65);
      scene.Mapper->SetSkipping(Mapper::SKIP_NOTHING);
      EXPECT_LT(LargestDifference(DrawFloats(scene), blocks), 1.0 / 255.0);
    }
  }
}

TEST(Curvature, IsNeutralWhereThereIsNone)
{
  const std::function<double(int, int, int)> fields[] = { [](int, int, int) { return 5.0; },
    [](int x, int y, int z)
    { return x % 31 == 0 ? 100.0 * (x > 0 ? 1 : 0) : 3.0 * x + 2.0 * y - z; },
    [](int x, int, int) { return std::max(x - 10, 0) * 7.0; } };
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    for (const auto& field : fields)
    {
      for (int function :
        { Mapper::MEAN, Mapper::GAUSSIAN, Mapper::SHAPE_INDEX, Mapper::LINE_FEATURE })
      {
        Scene scene;
        scene.Window->SetSize(64, 64);
        scene.SetVolume(MakeVolume({ 32, 32, 32 }, VTK_FLOAT, field), 0.5);
        scene.SetOpacity({ { -1e3, 0.01 }, { 1e3, 0.01 } });
        scene.Mapper->CroppingOn();
        scene.Mapper->SetCroppingRegionPlanes(14.0, 20.0, 4.0, 27.0, 4.0, 27.0);
        scene.Mapper->SetReconstructionFilter(filter);
        scene.Mapper->SetCurvatureFunction(function);
        vtkNew<vtkColorTransferFunction> gray;
        gray->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
        gray->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
        scene.Mapper->SetCurvatureColor(gray);
        // The shape index does not tell how small curvature is.
        const double most = function == Mapper::SHAPE_INDEX ? 1.0 : 0.01;
        scene.Mapper->SetCurvatureRange(-most, most);
        scene.LookFrom(20.0, 30.0, 1.0);
        for (const auto& pixel : DrawFloats(scene))
        {
          ASSERT_NEAR(pixel[0], 0.5 * pixel[3], 5e-3 * pixel[3] + 1e-6) << CurvatureNames[function];
        }
      }
    }
  }
}

TEST(Curvature, IsSoundInOneVoxelStructures)
{
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    for (int function = Mapper::FIRST_PRINCIPAL; function <= Mapper::LINE_FEATURE; ++function)
    {
      Scene scene;
      scene.Window->SetSize(96, 96);
      scene.SetVolume(MakeVolume({ 24, 24, 24 }, VTK_FLOAT,
                        [](int x, int y, int z)
                        {
                          const bool isPoint = x % 6 == 3 && y % 6 == 3 && z % 6 == 3;
                          const bool isFiber = x == 9 && y == 15;
                          const bool isSheet = z == 20;
                          return isPoint || isFiber || isSheet ? 1e30 : -1e-30;
                        }),
        0.5);
      scene.SetOpacity({ { 0.0, 0.0 }, { 1e29, 0.5 } });
      scene.Mapper->SetReconstructionFilter(filter);
      scene.Mapper->SetCurvatureFunction(function);
      scene.Mapper->SetSilhouetteWidth(0.5);
      scene.Property->ShadeOn();
      scene.LookFrom(20.0, 30.0, 1.0);
      EXPECT_TRUE(IsSound(DrawFloats(scene))) << CurvatureNames[function];
    }
  }
}

// A ball's picture does not depend on what its values are multiplied by, nor on a distant sample
// that makes its gradients a hundred-thousandth of the range.
TEST(Curvature, OfGradientsOfAnySize)
{
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    Picture expected;
    for (const double factor : { 1.0, 1e-25, 1e25 })
    {
      for (const double outlier : { 0.0, 1e3 })
      {
        Scene scene;
        ShowBall(scene, { 1.0, 1.0, 1.0 },
          MakeVolume({ 64, 64, 64 }, VTK_DOUBLE,
            [&](int x, int y, int z)
            {
              const bool isOutlier = x + y + z == 0 && outlier > 0.0;
              return factor *
                     (isOutlier ? outlier : 20.0 - std::hypot(x - 31.5, y - 31.5, z - 31.5));
            }));
        scene.SetOpacity(
          { { -factor, 0.0 }, { 0.0, 0.4 }, { factor, 0.0 }, { 2.0 * factor, 0.0 } });
        scene.Mapper->SetReconstructionFilter(filter);
        const Picture picture = DrawFloats(scene);
        expected = expected.empty() ? picture : expected;
        double largest = 0.0;
        for (std::size_t i = 0; i < picture.size(); ++i)
        {
          if (picture[i][3] > 0.3 && expected[i][3] > 0.3)
          {
            largest = std::max(
              largest, std::abs(picture[i][0] / picture[i][3] - expected[i][0] / expected[i][3]));
          }
        }
        EXPECT_LT(largest, 4.0 / 255.0) << factor << " " << outlier;
        ASSERT_GT(GetCenter(picture, 256)[3], 0.1);
      }
    }
  }
}

TEST(Curvature, HolesAreNeutral)
{
  Scene scene;
  ShowBall(scene, { 1.0, 1.0, 1.0 },
    MakeVolume({ 64, 64, 64 }, VTK_FLOAT,
      [](int x, int y, int z)
      {
        return x == 31 && y % 8 == 0 ? std::nan("")
                                     : 100.0 - std::hypot(x - 31.5, y - 31.5, z - 31.5);
      }));
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    scene.Mapper->SetReconstructionFilter(filter);
    scene.Property->ShadeOn();
    EXPECT_TRUE(IsSound(DrawFloats(scene)));
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
  vtkNew<vtkColorTransferFunction> gray;
  gray->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
  gray->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    Scene scene;
    ShowBall(scene, { 1.0, 1.0, 1.0 });
    scene.Mapper->SetReconstructionFilter(filter);
    scene.Mapper->SetCurvatureColor(gray);
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
