// Whole scenes: each against its baseline, and against vtkGPUVolumeRayCastMapper at the same sample
// distance.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

using namespace flatblock::testing;

namespace
{
constexpr double LeastPSNR = 40.0;

void ExpectLikePeerAndBaseline(Scene& scene, const std::string& name)
{
  const auto peer = scene.DrawWithPeer();
  const auto own = scene.Draw();
  EXPECT_TRUE(ShowsSomething(own));
  const double psnr = PSNR(own, peer);
  std::cout << name << ": " << psnr << " dB to vtkGPUVolumeRayCastMapper\n";
  EXPECT_GE(psnr, LeastPSNR);
  EXPECT_TRUE(MatchesBaseline(scene.Window, name));
}

void AddSphere(Scene& scene, const double center[3], double radius, double r, double g, double b)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center[0], center[1], center[2]);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  scene.Renderer->AddActor(actor);
}
} // namespace

TEST(Scenes, MRI)
{
  const auto mri = ReadMRI();
  if (!mri)
  {
    GTEST_SKIP() << "mricron-data is not installed";
  }
  Scene scene;
  scene.SetVolume(*mri, 0.25);
  scene.SetOpacity({ { 30.0, 0.0 }, { 90.0, 0.3 }, { 130.0, 0.8 } });
  scene.SetColor({ { 30.0, 0.3, 0.1, 0.1 }, { 80.0, 0.8, 0.6, 0.5 }, { 130.0, 1.0, 1.0, 0.9 } });
  scene.LookFrom(150.0, 35.0, 1.4);
  ExpectLikePeerAndBaseline(scene, "MRI");
}

TEST(Scenes, MarschnerLobb)
{
  Scene scene;
  scene.SetVolume(MarschnerLobb(128), 0.5 * 2.0 / 127.0);
  scene.SetOpacity({ { 90.0, 0.0 }, { 125.0, 0.6 }, { 160.0, 0.0 } });
  scene.SetColor({ { 90.0, 0.2, 0.4, 0.9 }, { 125.0, 0.9, 0.9, 0.7 }, { 160.0, 0.9, 0.3, 0.1 } });
  scene.Property->SetScalarOpacityUnitDistance(0.01);
  scene.LookFrom(30.0, 40.0, 1.3);
  ExpectLikePeerAndBaseline(scene, "MarschnerLobb");
}

TEST(Scenes, AnisotropicTiltedWavelet)
{
  Scene scene;
  scene.SetVolume(AnisotropicWavelet(64), 0.5);
  scene.SetRamp(60.0, 270.0, 0.08);
  scene.Volume->RotateWXYZ(35.0, 1.0, 2.0, 0.5);
  scene.LookFrom(10.0, 20.0, 1.3);
  ExpectLikePeerAndBaseline(scene, "AnisotropicTiltedWavelet");
}

TEST(Scenes, GeometryInFrontBehindAndWithin)
{
  Scene scene;
  scene.SetVolume(MarschnerLobb(64), 1.0 / 63.0);
  scene.SetRamp(0.0, 255.0, 0.5);
  scene.Property->SetScalarOpacityUnitDistance(0.4);
  const double within[3] = { 0.1, 0.1, -0.2 };
  const double front[3] = { 0.2, -0.6, 1.3 };
  const double behind[3] = { 0.9, 0.9, -1.6 };
  const double across[3] = { 0.8, -0.6, -0.9 };
  AddSphere(scene, within, 0.5, 0.1, 0.9, 0.2);
  AddSphere(scene, front, 0.25, 0.9, 0.1, 0.9);
  AddSphere(scene, behind, 0.6, 0.9, 0.9, 0.1);
  AddSphere(scene, across, 0.4, 0.9, 0.9, 0.9);
  scene.LookFrom(20.0, 25.0);
  ExpectLikePeerAndBaseline(scene, "GeometryInFrontBehindAndWithin");
}

TEST(Scenes, CameraInside)
{
  Scene scene;
  scene.SetVolume(MarschnerLobb(64), 0.25 * 2.0 / 63.0);
  scene.SetOpacity({ { 90.0, 0.0 }, { 125.0, 0.6 }, { 160.0, 0.0 } });
  scene.SetColor({ { 90.0, 0.2, 0.4, 0.9 }, { 125.0, 0.9, 0.9, 0.7 }, { 160.0, 0.9, 0.3, 0.1 } });
  scene.Property->SetScalarOpacityUnitDistance(0.05);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.3, -0.6, 0.75);
  camera->SetFocalPoint(0.0, 0.3, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(70.0);
  scene.Renderer->ResetCameraClippingRange();
  ExpectLikePeerAndBaseline(scene, "CameraInside");
}

TEST(Scenes, ParallelProjection)
{
  Scene scene;
  scene.SetVolume(AnisotropicWavelet(64), 0.5);
  scene.SetRamp(60.0, 270.0, 0.08);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(40.0, 30.0, 1.3);
  ExpectLikePeerAndBaseline(scene, "ParallelProjection");
}

// Sheared projections, and those of each eye: an opaque cube of voxels must lie where the same cube
// of polygons lies. Not against the peer: vtkGPUVolumeRayCastMapper looks from between the eyes.
TEST(Scenes, StereoAndShearAgreeWithGeometry)
{
  Scene scene;
  const auto isCube = [](int x, int y, int z)
  { return std::abs(x - 20) < 4 && std::abs(y - 20) < 4 && std::abs(z - 20) < 4 ? 1.0 : 0.0; };
  scene.SetVolume(MakeVolume({ 41, 41, 41 }, VTK_UNSIGNED_CHAR, isCube), 0.02);
  scene.SetOpacity({ { 0.0, 0.0 }, { 0.5, 0.0 }, { 1.0, 1.0 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 } });
  scene.Property->SetInterpolationTypeToNearest();
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(16.5, 23.5, 16.5, 23.5, 16.5, 23.5);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  scene.Renderer->AddActor(actor);
  scene.LookFrom(30.0, 30.0, 4.0);
  scene.Window->StereoCapableWindowOn();
  scene.Renderer->GetActiveCamera()->SetEyeAngle(15.0);

  const auto expectAgreement = [&scene, &actor](const std::string& what)
  {
    actor->VisibilityOff();
    scene.Volume->VisibilityOn();
    const auto voxels = scene.Draw();
    actor->VisibilityOn();
    scene.Volume->VisibilityOff();
    const double psnr = PSNR(voxels, scene.Draw());
    std::cout << what << ": " << psnr << " dB to the polygons\n";
    EXPECT_TRUE(ShowsSomething(voxels)) << what;
    EXPECT_GE(psnr, 35.0) << what;
  };
  expectAgreement("one eye");
  scene.Window->StereoRenderOn();
  for (int type : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
  {
    scene.Window->SetStereoType(type);
    expectAgreement("stereo " + std::to_string(type));
  }
  scene.Window->StereoRenderOff();
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(10.0);
  expectAgreement("parallel");
  scene.Renderer->GetActiveCamera()->SetViewShear(0.3, -0.2, 1.0);
  expectAgreement("sheared");
}

TEST(Scenes, NearestInterpolation)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 9, 9, 9 }, VTK_UNSIGNED_CHAR,
                    [](int x, int y, int z) { return (37 * x + 59 * y + 83 * z) % 256; }),
    0.02);
  scene.SetOpacity({ { 150.0, 0.0 }, { 160.0, 0.95 } });
  scene.SetColor({ { 150.0, 0.1, 0.2, 0.8 }, { 200.0, 0.9, 0.8, 0.3 }, { 255.0, 1.0, 0.2, 0.1 } });
  scene.Property->SetInterpolationTypeToNearest();
  scene.LookFrom(25.0, 35.0, 1.3);
  ExpectLikePeerAndBaseline(scene, "NearestInterpolation");
}
