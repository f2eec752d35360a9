// Every scalar type of VTK draws the same field alike.
#include "Rendering.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace flatblock::testing;

namespace
{
double Field(int x, int y, int z)
{
  return std::round(60.0 + 30.0 * std::sin(0.4 * x) + 25.0 * std::cos(0.3 * y + 0.2 * z));
}

vtkSmartPointer<vtkImageData> DrawType(int type, double scale, double shift)
{
  const auto volume = MakeVolume(
    { 40, 30, 35 }, type, [=](int x, int y, int z) { return scale * Field(x, y, z) + shift; });
  Scene scene;
  scene.SetVolume(volume, 0.5);
  scene.SetRamp(scale * 5.0 + shift, scale * 115.0 + shift, 0.2);
  scene.LookFrom(33.0, 21.0, 1.3);
  return scene.Draw();
}
} // namespace

TEST(ScalarTypes, AllDrawTheSameField)
{
  const auto reference = DrawType(VTK_DOUBLE, 1.0, 0.0);
  ASSERT_TRUE(ShowsSomething(reference));
  const struct
  {
    int Type;
    double Scale, Shift;
  } cases[] = { { VTK_CHAR, 1.0, 0.0 }, { VTK_SIGNED_CHAR, 2.0, -128.0 },
    { VTK_SIGNED_CHAR, 1.0, 0.0 }, { VTK_UNSIGNED_CHAR, 1.0, 0.0 }, { VTK_UNSIGNED_CHAR, 2.0, 9.0 },
    { VTK_SHORT, 500.0, -32768.0 }, { VTK_SHORT, 1.0, 0.0 }, { VTK_UNSIGNED_SHORT, 500.0, 0.0 },
    { VTK_UNSIGNED_SHORT, 1.0, 65000.0 }, { VTK_INT, 1e6, -1e8 }, { VTK_UNSIGNED_INT, 3e7, 0.0 },
    { VTK_LONG, 1e15, -1e17 }, { VTK_UNSIGNED_LONG, 1e15, 0.0 }, { VTK_LONG_LONG, 1e10, 0.0 },
    { VTK_UNSIGNED_LONG_LONG, 1e10, 0.0 }, { VTK_ID_TYPE, 10.0, 0.0 }, { VTK_FLOAT, 1e-20, 0.0 },
    { VTK_FLOAT, 1e20, 0.0 }, { VTK_DOUBLE, 1e100, -1e101 }, { VTK_DOUBLE, 1e-3, 1e6 } };
  for (const auto& c : cases)
  {
    const double psnr = PSNR(DrawType(c.Type, c.Scale, c.Shift), reference);
    EXPECT_GE(psnr, 50.0) << vtkImageScalarTypeNameMacro(c.Type) << " " << c.Scale << " "
                          << c.Shift;
  }
}

TEST(ScalarTypes, SpacingMayBeOfAnySize)
{
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (double spacing : { 1.0, 1e-12, 1e20 })
  {
    Scene scene;
    const auto volume = MakeVolume({ 40, 30, 35 }, VTK_UNSIGNED_CHAR, Field);
    volume->SetSpacing(spacing, spacing, spacing);
    scene.SetVolume(volume, 0.0);
    scene.SetRamp(5.0, 115.0, 0.2);
    scene.Property->SetScalarOpacityUnitDistance(spacing);
    scene.LookFrom(33.0, 21.0, 1.3);
    pictures.push_back(scene.Draw());
    EXPECT_TRUE(ShowsSomething(pictures.back())) << spacing;
    EXPECT_GE(PSNR(pictures.back(), pictures.front()), 45.0) << spacing;
  }
}

TEST(ScalarTypes, Bits)
{
  const auto isSet = [](int x, int y, int z) { return (x / 8 + y / 8 + z / 8) % 2; };
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (int type : { VTK_BIT, VTK_UNSIGNED_CHAR })
  {
    Scene scene;
    scene.SetVolume(MakeVolume({ 40, 40, 40 }, type, isSet), 0.5);
    scene.SetRamp(0.0, 1.0, 0.3);
    scene.LookFrom(33.0, 21.0, 1.3);
    pictures.push_back(scene.Draw());
  }
  EXPECT_TRUE(ShowsSomething(pictures[0]));
  EXPECT_EQ(LargestDifference(pictures[0], pictures[1]), 0.0);
}

TEST(ScalarTypes, ConstantVolumeEqualsTheClosedForm)
{
  // White fog of opacity 0.02 a unit over black, seen along an axis: 1 - 0.98^40 after 40 units.
  for (int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_DOUBLE })
  {
    Scene scene;
    scene.SetVolume(MakeVolume({ 41, 41, 41 }, type, [](int, int, int) { return 7.0; }), 0.25);
    scene.SetOpacity({ { 0.0, 0.02 }, { 255.0, 0.02 } });
    scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 } });
    scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.LookFrom(0.0, 0.0);
    const auto picture = scene.Draw();
    const double expected = 255.0 * (1.0 - std::pow(0.98, 40.0));
    EXPECT_NEAR(picture->GetScalarComponentAsDouble(128, 128, 0, 0), expected, 1.0);
  }
}

// A value of exactly zero opacity stays invisible next to others, however far from the type's end.
TEST(ScalarTypes, LabelsHaveNoHaze)
{
  for (const auto& [type, shift] : std::vector<std::pair<int, double>>{ { VTK_SHORT, 0.0 },
         { VTK_UNSIGNED_SHORT, 65000.0 }, { VTK_UNSIGNED_CHAR, 0.0 }, { VTK_INT, 1e6 } })
  {
    Scene scene;
    const auto isLabel = [](int x, int y, int z)
    { return std::abs(x - 20) < 4 && std::abs(y - 20) < 4 && std::abs(z - 20) < 4; };
    scene.SetVolume(MakeVolume({ 41, 41, 41 }, type,
                      [&isLabel, shift = shift](int x, int y, int z)
                      { return shift + (isLabel(x, y, z) ? 5.0 : 0.0); }),
      0.5);
    scene.SetOpacity({ { shift, 0.0 }, { shift + 1.0, 1.0 } });
    scene.SetColor({ { shift, 1.0, 1.0, 1.0 } });
    scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    scene.LookFrom(0.0, 0.0);
    const auto picture = scene.Draw();
    EXPECT_EQ(picture->GetScalarComponentAsDouble(90, 90, 0, 0), 0.0) << shift;
    EXPECT_EQ(picture->GetScalarComponentAsDouble(128, 128, 0, 0), 255.0) << shift;
  }
}

TEST(ScalarTypes, FogBehindTheCameraIsNotSeen)
{
  Scene scene;
  scene.SetVolume(
    MakeVolume({ 41, 41, 41 }, VTK_UNSIGNED_CHAR, [](int, int, int) { return 7.0; }), 0.25);
  scene.SetOpacity({ { 0.0, 0.02 }, { 255.0, 0.02 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 } });
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(20.0, 20.0, 30.0);
  camera->SetFocalPoint(20.0, 20.0, 0.0);
  scene.Renderer->ResetCameraClippingRange();
  camera->SetClippingRange(1e-3, 100.0);
  const auto picture = scene.Draw();
  const double expected = 255.0 * (1.0 - std::pow(0.98, 30.0));
  EXPECT_NEAR(picture->GetScalarComponentAsDouble(128, 128, 0, 0), expected, 1.0);
}

TEST(ScalarTypes, ValuesThatAreNotFiniteDoNoHarm)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  Scene scene;
  scene.SetVolume(MakeVolume({ 40, 40, 40 }, VTK_FLOAT,
                    [=](int x, int y, int z)
                    {
                      const bool corner = x < 4 && y < 4 && z < 4;
                      return corner ? (x % 2 ? nan : infinity) : Field(x, y, z);
                    }),
    0.5);
  scene.SetRamp(5.0, 115.0, 0.2);
  scene.LookFrom(33.0, 21.0, 1.3);
  const auto broken = scene.Draw();
  scene.SetVolume(MakeVolume({ 40, 40, 40 }, VTK_FLOAT, Field), 0.5);
  const auto whole = scene.Draw();
  EXPECT_GE(PSNR(broken, whole), 30.0);

  // What counts as the lowest value is drawn as such in every block.
  scene.SetVolume(MakeVolume({ 65, 65, 65 }, VTK_FLOAT,
                    [=](int x, int y, int z) { return x < 40 ? nan : Field(x, y, z); }),
    0.5);
  scene.SetOpacity({ { 0.0, 0.1 }, { 30.0, 0.0 } });
  scene.LookFrom(33.0, 21.0);
  scene.Mapper->SetBlockSize(65);
  const auto oneBlock = scene.Draw();
  EXPECT_TRUE(ShowsSomething(oneBlock));
  scene.Mapper->SetBlockSize(17);
  EXPECT_GE(PSNR(scene.Draw(), oneBlock), 55.0);
  scene.SetRamp(5.0, 115.0, 0.2);

  scene.SetVolume(MakeVolume({ 20, 20, 20 }, VTK_DOUBLE, [=](int, int, int) { return nan; }), 0.5);
  EXPECT_FALSE(ShowsSomething(scene.Draw()));
}
