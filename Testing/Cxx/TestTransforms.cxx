// Where the volume lies: spacing, origin, direction, extent, and the prop's transform.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace flatblock::testing;

namespace
{
// No symmetry: a wrong or swapped axis shows.
vtkSmartPointer<vtkImageData> Lopsided()
{
  return MakeVolume({ 40, 30, 20 }, VTK_UNSIGNED_CHAR,
    [](int x, int y, int z)
    {
      const double ball = std::hypot(x - 30, y - 8, z - 5) < 5.0 ? 90.0 : 0.0;
      return 3.0 * x + y + ball + (z > 12 && x < 12 ? 60.0 : 0.0);
    });
}

void Prepare(Scene& scene, vtkImageData* image, double step = 0.4)
{
  scene.SetVolume(image, step);
  scene.SetRamp(20.0, 240.0, 0.2);
}

void SetDirection(vtkImageData* image, vtkTransform* rotation)
{
  vtkNew<vtkMatrix3x3> direction;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      direction->SetElement(i, j, rotation->GetMatrix()->GetElement(i, j));
    }
  }
  image->SetDirectionMatrix(direction);
}
} // namespace

TEST(Transforms, PropsLookLikeThePeer)
{
  const auto expectAlike = [](const char* what, const std::function<void(Scene&)>& change)
  {
    Scene scene;
    const auto image = Lopsided();
    image->SetSpacing(1.0, 1.3, 0.8);
    image->SetOrigin(5.0, -70.0, 3.0);
    Prepare(scene, image);
    change(scene);
    scene.LookFrom(33.0, 21.0, 1.2);
    const auto picture = scene.Draw();
    EXPECT_TRUE(ShowsSomething(picture)) << what;
    EXPECT_GE(PSNR(picture, scene.DrawWithPeer()), 40.0) << what;
  };
  expectAlike("as it is", [](Scene&) {});
  expectAlike("position and orientation",
    [](Scene& scene)
    {
      scene.Volume->SetPosition(3.0, 4.0, -90.0);
      scene.Volume->SetOrientation(20.0, 30.0, 40.0);
    });
  expectAlike("scale", [](Scene& scene) { scene.Volume->SetScale(2.0, 0.5, 1.5); });
  expectAlike("user transform",
    [](Scene& scene)
    {
      vtkNew<vtkTransform> transform;
      transform->RotateWXYZ(50.0, 1.0, 1.0, 0.0);
      transform->Translate(100.0, 0.0, 0.0);
      scene.Volume->SetUserTransform(transform);
    });
}

TEST(Transforms, DirectionMatrixEqualsTheSameRotationOfTheProp)
{
  vtkNew<vtkTransform> rotation;
  rotation->RotateWXYZ(40.0, 0.3, 1.0, 0.5);

  Scene direction;
  const auto tilted = Lopsided();
  SetDirection(tilted, rotation);
  Prepare(direction, tilted);
  direction.LookFrom(33.0, 21.0, 1.2);

  Scene prop;
  Prepare(prop, Lopsided());
  prop.Volume->SetUserTransform(rotation);
  prop.Renderer->GetActiveCamera()->DeepCopy(direction.Renderer->GetActiveCamera());

  const auto picture = direction.Draw();
  EXPECT_TRUE(ShowsSomething(picture));
  EXPECT_GE(PSNR(picture, prop.Draw()), 55.0);
}

TEST(Transforms, ExtentsMayBeginAnywhere)
{
  Scene scene;
  Prepare(scene, Lopsided());
  scene.LookFrom(33.0, 21.0, 1.2);
  const auto expected = scene.Draw();

  const auto shifted = Lopsided();
  shifted->SetExtent(10, 49, -7, 22, 3, 22);
  shifted->SetOrigin(-10.0, 7.0, -3.0);
  scene.SetVolume(shifted, 0.4);
  EXPECT_EQ(LargestDifference(expected, scene.Draw()), 0.0);
}

TEST(Transforms, MirroredVolumesAreNotTurnedInsideOut)
{
  Scene scene;
  Prepare(scene, Lopsided());
  scene.Volume->SetScale(-1.0, 1.0, 1.0);
  scene.LookFrom(33.0, 21.0, 1.2);
  const auto mirrored = scene.Draw();

  const auto flipped = MakeVolume({ 40, 30, 20 }, VTK_UNSIGNED_CHAR,
    [image = Lopsided()](int x, int y, int z)
    { return image->GetScalarComponentAsDouble(39 - x, y, z, 0); });
  flipped->SetOrigin(-39.0, 0.0, 0.0);
  Scene other;
  Prepare(other, flipped);
  other.Renderer->GetActiveCamera()->DeepCopy(scene.Renderer->GetActiveCamera());
  EXPECT_TRUE(ShowsSomething(mirrored));
  EXPECT_GE(PSNR(mirrored, other.Draw()), 55.0);

  for (Scene* inside : { &scene, &other })
  {
    inside->Renderer->GetActiveCamera()->SetPosition(-10.0, 12.0, 10.0);
    inside->Renderer->GetActiveCamera()->SetFocalPoint(-30.0, 8.0, 5.0);
    inside->Renderer->ResetCameraClippingRange();
  }
  const auto fromInside = scene.Draw();
  EXPECT_TRUE(ShowsSomething(fromInside));
  EXPECT_GE(PSNR(fromInside, other.Draw()), 55.0);
}

TEST(Transforms, ClippingRangeOfTheCameraDoesNotCutHoles)
{
  Scene scene;
  Prepare(scene, Lopsided());
  scene.LookFrom(33.0, 21.0, 1.2);
  const auto whole = scene.Draw();
  double range[2];
  scene.Renderer->GetActiveCamera()->GetClippingRange(range);
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.5 * range[0], 0.5 * (range[0] + range[1]));
  const auto half = scene.Draw();
  // Cut by the near plane only: rays go on to the far side.
  EXPECT_GE(PSNR(half, whole), 50.0);

  scene.Renderer->GetActiveCamera()->SetClippingRange(0.5 * (range[0] + range[1]), range[1]);
  const auto nearCut = scene.Draw();
  EXPECT_LT(PSNR(nearCut, whole), 40.0);
  EXPECT_GE(PSNR(nearCut, scene.DrawWithPeer()), 38.0);
}
