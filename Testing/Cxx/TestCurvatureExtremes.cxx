// Curvature where there is none, or hardly any, or too much of it.
#include "CurvaturePicture.h"
#include "Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace flatblock::testing;

namespace
{
using Mapper = vtkFlatBlockVolumeMapper;
} // namespace

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
        scene.Mapper->SetCurvatureColor(MakeGray(0.0, 1.0));
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

// A plane whose slope is a tenth of the steps that its samples are rounded to.
TEST(Curvature, DoesNotShowTheRoundingOfSamples)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_INT })
  {
    for (const bool isInterpolating : { false, true })
    {
      for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
      {
        Scene scene;
        scene.Window->SetSize(96, 96);
        scene.SetVolume(MakeVolume({ 48, 48, 48 }, type,
                          [](int x, int y, int z)
                          {
                            const bool isFar = x == 47 && y == 47;
                            return isFar ? (z % 2) * 255.0 : std::round(100.0 + 0.1 * (x + y));
                          }),
          0.5);
        scene.SetOpacity({ { 0.0, 0.01 }, { 255.0, 0.01 } });
        scene.Mapper->CroppingOn();
        scene.Mapper->SetCroppingRegionPlanes(4.0, 30.0, 4.0, 30.0, 4.0, 30.0);
        scene.Mapper->SetReconstructionFilter(filter);
        scene.Mapper->SetInterpolatingBSpline(isInterpolating);
        scene.Mapper->SetCurvatureFunctionToMean();
        scene.Mapper->SetCurvatureColor(MakeGray(0.0, 1.0));
        scene.Mapper->SetCurvatureRange(-0.5, 0.5);
        scene.LookFrom(20.0, 30.0, 1.0);
        for (const auto& pixel : DrawFloats(scene))
        {
          ASSERT_NEAR(pixel[0], 0.5 * pixel[3], 0.05 * pixel[3] + 1e-6) << type << filter;
        }
      }
    }
  }
}

// But that is all there is to a mask of 0 and 1.
TEST(Curvature, OfAMaskIsThatOfItsShape)
{
  Scene scene;
  ShowBall(scene, { 1.0, 1.0, 1.0 },
    MakeVolume({ 64, 64, 64 }, VTK_UNSIGNED_CHAR,
      [](int x, int y, int z) { return std::hypot(x - 31.5, y - 31.5, z - 31.5) < 20.0 ? 1 : 0; }));
  scene.SetOpacity({ { 0.3, 0.0 }, { 0.5, 0.4 }, { 0.7, 0.0 } });
  scene.Mapper->SetReconstructionFilterToCubicBSpline();
  scene.Mapper->SetCurvatureColor(MakeGray(0.0, 1.0));
  scene.Mapper->SetCurvatureRange(0.0, 0.1);
  double sum = 0.0;
  double opacity = 0.0;
  for (const auto& pixel : DrawFloats(scene))
  {
    sum += pixel[0];
    opacity += pixel[3];
  }
  EXPECT_NEAR(sum / opacity, 0.5, 0.15);
}

TEST(Silhouettes, AreNotOnConstantMatter)
{
  Scene scene;
  scene.SetVolume(
    MakeVolume({ 24, 24, 24 }, VTK_FLOAT, [](int x, int, int) { return x < 2 ? 9.0 : 5.0; }), 0.5);
  scene.SetOpacity({ { 0.0, 0.05 }, { 10.0, 0.05 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 }, { 10.0, 1.0, 1.0, 1.0 } });
  scene.LookFrom(20.0, 30.0, 1.0);
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    scene.Mapper->SetReconstructionFilter(filter);
    scene.Mapper->SetSilhouetteWidth(0.0);
    const Picture plain = DrawFloats(scene);
    scene.Mapper->SetSilhouetteWidth(1.0);
    scene.Mapper->SetSilhouetteColor(0.0, 1.0, 0.0);
    EXPECT_LT(LargestDifference(DrawFloats(scene), plain), 1e-3) << filter;
  }
}

// Light that falls on slopes is the same, whether curvature asks for them or not.
TEST(Curvature, OfVolumesOfOneCell)
{
  for (const auto& samples : { std::array<int, 3>{ 2, 33, 33 }, std::array<int, 3>{ 33, 2, 33 },
         std::array<int, 3>{ 33, 33, 2 }, std::array<int, 3>{ 33, 33, 3 } })
  {
    Scene scene;
    scene.SetVolume(
      MakeVolume(samples, VTK_FLOAT, [](int x, int y, int z) { return x + 2.0 * y + 1.5 * z; }),
      0.25);
    scene.SetOpacity({ { 0.0, 0.2 }, { 150.0, 0.2 } });
    scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 }, { 150.0, 1.0, 1.0, 1.0 } });
    scene.Property->ShadeOn();
    scene.Property->SetSpecular(0.5);
    scene.LookFrom(50.0, 30.0, 1.2);
    const Picture plain = DrawFloats(scene);
    scene.Mapper->SetCurvatureFunctionToMean();
    scene.Mapper->SetCurvatureColor(MakeGray(-2.0, -1.0)); // nothing but white
    scene.Mapper->SetCurvatureRange(-2.0, -1.0);
    EXPECT_LT(LargestDifference(DrawFloats(scene), plain), 1.0 / 255.0) << samples[0] << samples[1];
  }
}
