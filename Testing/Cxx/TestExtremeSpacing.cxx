// Spacings, origins and matrices far from what is usual.
#include "Extremes.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

using namespace flatblock::testing;

namespace
{
const char* const Group = "spacings, origins and matrices";
constexpr double Bound = 0.01; // a step of half a voxel

vtkImageData* GetImage(Scene& scene)
{
  return vtkImageData::SafeDownCast(scene.Mapper->GetInputDataObject(0, 0));
}

// With the step and the unit of opacity in proportion.
void SetSpacing(Scene& scene, double x, double y, double z)
{
  const double smallest = std::min({ x, y, z });
  GetImage(scene)->SetSpacing(x, y, z);
  scene.Mapper->SetSampleDistance(0.5 * smallest);
  scene.Property->SetScalarOpacityUnitDistance(smallest);
  scene.LookFrom(33.0, 21.0, 1.2);
}
} // namespace

TEST(ExtremeSpacing, OfEverySize)
{
  for (double spacing : { 1e-9, 1e-3, 1e3, 1e9 })
  {
    Scene scene;
    ShowWaves(scene, { 17, 18, 19 });
    SetSpacing(scene, spacing, spacing, spacing);
    ExpectRight(scene, Group, "spacing " + ToText(spacing), Bound);
  }
}

// Far along one axis; so a needle, or a sheet.
TEST(ExtremeSpacing, RatiosOfEverySize)
{
  for (double ratio : { 10.0, 1e3, 1e6 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Scene scene;
      ShowWaves(scene, { 9, 8, 10 });
      double spacing[3] = { 1.0, 1.0, 1.0 };
      spacing[axis] = ratio;
      SetSpacing(scene, spacing[0], spacing[1], spacing[2]);
      scene.Property->SetScalarOpacityUnitDistance(axis == 0 ? 1.0 : ratio);
      scene.LookFrom(33.0, 21.0, ratio > 100.0 ? 0.05 * ratio : 1.2);
      ExpectRight(scene, Group, "spacing 1 : " + ToText(ratio), Bound);
    }
  }
}

// From close by, where the needle fills the picture.
TEST(ExtremeSpacing, NeedlesSeenFromTheSide)
{
  Scene scene;
  ShowWaves(scene, { 9, 8, 10 });
  SetSpacing(scene, 1.0, 1.0, 1e6);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(25.0, 9.0, 4.5e6 + 3.0);
  camera->SetFocalPoint(4.0, 3.5, 4.5e6);
  scene.Renderer->ResetCameraClippingRange();
  camera->SetClippingRange(1.0, 1e7);
  ExpectRight(scene, Group, "spacing 1 : 1000000, from close by", Bound);
}

TEST(ExtremeSpacing, OriginsFarAway)
{
  for (double origin : { 1e6, 1e8, -1e8 })
  {
    Scene scene;
    ShowWaves(scene, { 17, 18, 19 });
    GetImage(scene)->SetOrigin(origin, -2.0 * origin, origin);
    scene.LookFrom(33.0, 21.0, 1.2);
    ExpectRight(scene, Group, "origin at " + ToText(origin), Bound);
  }
}

TEST(ExtremeSpacing, MirroredAndShearedMatrices)
{
  const double mirrored[16] = { -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  const double sheared[16] = { 1, 0.8, -0.3, 5, 0, 1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  const double both[16] = { 1, 0.8, 0, 0, 0, -2, 0.5, 0, 0.1, 0, 0.5, 0, 0, 0, 0, 1 };
  for (const auto& [matrix, name] : std::vector<std::pair<const double*, std::string>>{
         { mirrored, "mirrored" }, { sheared, "sheared" }, { both, "mirrored and sheared" } })
  {
    Scene scene;
    ShowWaves(scene, { 17, 18, 19 });
    vtkNew<vtkMatrix4x4> user;
    user->DeepCopy(matrix);
    scene.Volume->SetUserMatrix(user);
    scene.LookFrom(33.0, 21.0, 1.2);
    ExpectRight(scene, Group, "a prop that is " + name, Bound);
  }
  Scene scene;
  ShowWaves(scene, { 17, 18, 19 });
  GetImage(scene)->SetDirectionMatrix(0, 1, 0, 1, 0, 0, 0, 0, 1);
  scene.LookFrom(33.0, 21.0, 1.2);
  ExpectRight(scene, Group, "a mirrored direction matrix", Bound);
}
