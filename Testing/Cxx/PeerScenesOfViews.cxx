#include "PeerSceneParts.h"
#include "PeerScenes.h"

#include "Volumes.h"

#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkPointData.h"
#include "vtkTransform.h"
#include "vtkVersionMacros.h"

#include <algorithm>

namespace flatblock::testing
{
namespace
{
void SetTransfer2D(Scene& scene)
{
  constexpr int Size = 256;
  vtkNew<vtkImageData> function;
  function->SetDimensions(Size, Size, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const float color[4] = { x / 255.0F, y / 255.0F, 0.5F,
        0.1F * std::clamp((x - 100.0F) / 80.0F, 0.0F, 1.0F) * std::min(y / 60.0F, 1.0F) };
      std::copy_n(color, 4, static_cast<float*>(function->GetScalarPointer(x, y, 0)));
    }
  }
  scene.Property->SetTransferFunction2D(function);
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
}

void LookFromInside(Scene& scene)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double* bounds = scene.Volume->GetBounds();
  camera->SetFocalPoint(
    0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]));
  camera->SetPosition(0.3 * bounds[0] + 0.7 * bounds[1], 0.4 * bounds[2] + 0.6 * bounds[3],
    0.25 * bounds[4] + 0.75 * bounds[5]);
  scene.Renderer->ResetCameraClippingRange();
}

void Transform(Scene& scene, double scale)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(10.0, -5.0, 3.0);
  transform->RotateWXYZ(40.0, 1.0, 2.0, 0.5);
  transform->Scale(scale, 1.0, 1.0 / scale);
  scene.Volume->SetUserTransform(transform);
  scene.LookFrom(30.0, 25.0, 1.2);
}

void SetLights(Scene& scene, bool isPositional)
{
  SetPlain(scene);
  Shade(scene);
  scene.Renderer->RemoveAllLights();
  for (const double side : { -1.0, 1.0 })
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(24.0 + 60.0 * side, 70.0, 90.0);
    light->SetFocalPoint(24.0, 22.0, 26.0);
    light->SetColor(0.7 + 0.3 * side, 0.8, 0.7 - 0.3 * side);
    light->SetPositional(isPositional ? 1 : 0);
    light->SetConeAngle(40.0);
    scene.Renderer->AddLight(light);
  }
}
} // namespace

std::vector<PeerScene> GetPeerScenesOfViews()
{
  return
  {
    { "CameraInside", 38.0, 0.99,
      [](Scene& s)
      {
        SetPlain(s);
        LookFromInside(s);
      },
      "" },
      { "CameraInsideClipping", 34.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Clip(s);
          LookFromInside(s);
        },
        "the peer's first sample lies a part of a step behind the plane" },
      { "CameraInsideSmallSpacing", 38.0, 0.99,
        [](Scene& s)
        {
          const auto image = MakeImage();
          image->SetSpacing(1e-3, 1e-3, 1e-3);
          SetImage(s, image, 5e-4);
          SetFunctions(s);
          s.Property->SetScalarOpacityUnitDistance(1e-3);
          LookFromInside(s);
        },
        "" },
      { "CameraInsideTransformation", 43.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Transform(s, 1.0);
          LookFromInside(s);
        },
        "" },
      { "CameraInsideNonUniformScaleTransform", 45.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Transform(s, 1.5);
          LookFromInside(s);
        },
        "" },
      { "Clipping", 33.0, 0.98,
        [](Scene& s)
        {
          SetPlain(s);
          Clip(s);
        },
        "the peer's first sample lies a part of a step behind the plane" },
      { "ClippingUserTransform", 40.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Transform(s, 1.0);
          Clip(s);
        },
        "" },
      { "ShadedClipping", 34.0, 0.97,
        [](Scene& s)
        {
          SetPlain(s);
          Shade(s);
          Clip(s);
        },
        "the peer takes gradients to what is cut off" },
      { "Cropping", 37.0, 0.98,
        [](Scene& s)
        {
          SetPlain(s);
          Both(s,
            [](auto* m)
            {
              m->CroppingOn();
              m->SetCroppingRegionPlanes(12.0, 36.0, 10.0, 34.0, 14.0, 40.0);
              m->SetCroppingRegionFlagsToFence();
            });
        },
        "" },
      { "Cropping1", 36.0, 0.98,
        [](Scene& s)
        {
          SetPlain(s);
          Both(s,
            [](auto* m)
            {
              m->CroppingOn();
              m->SetCroppingRegionPlanes(12.0, 36.0, 10.0, 34.0, 14.0, 40.0);
              m->SetCroppingRegionFlagsToInvertedCross();
            });
        },
        "" },
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
      { "ComputeNormalFromOpacity", 33.0, 0.95,
        [](Scene& s)
        {
          SetPlain(s);
          Shade(s);
          s.SetOpacity({ { 100.0, 0.0 }, { 130.0, 0.2 }, { 160.0, 0.0 } });
          Both(s, [](auto* m) { m->ComputeNormalFromOpacityOn(); });
        },
        "" },
      { "MapperShadows", 36.0, 0.98,
        [](Scene& s)
        {
          SetPlain(s);
          Shade(s);
          s.Property->SetScatteringAnisotropy(0.3F);
          Both(s,
            [](auto* m)
            {
              m->SetVolumetricScatteringBlending(1.5F);
              m->SetGlobalIlluminationReach(0.5F);
            });
        },
        "slanted shadows are darker in VTK" },
#endif
      { "GradientOpacity", 41.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          SetGradientOpacity(s);
        },
        "" },
      { "GradientOpacityLight", 42.0, 0.98,
        [](Scene& s)
        {
          SetPlain(s);
          SetGradientOpacity(s);
          Shade(s);
        },
        "" },
      { "ImageSampleXY", 44.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Both(s, [](auto* m) { m->SetImageSampleDistance(2.0F); });
        },
        "" },
      { "Jittering", 45.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Both(s, [](auto* m) { m->UseJitteringOn(); });
        },
        "" },
      { "LightKit", 36.0, 0.98,
        [](Scene& s)
        {
          SetPlain(s);
          Shade(s);
          s.Renderer->RemoveAllLights();
          vtkNew<vtkLightKit> kit;
          kit->AddLightsToRenderer(s.Renderer);
        },
        "" },
      { "MapperSampleDistance", 47.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Both(s, [](auto* m) { m->SetSampleDistance(0.25F); });
        },
        "" },
      { "PerspectiveParallel", 48.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          s.Renderer->GetActiveCamera()->ParallelProjectionOn();
          s.LookFrom(0.0, 0.0);
        },
        "" },
      { "PositionalLights", 35.0, 0.98, [](Scene& s) { SetLights(s, true); }, "" },
      { "ReleaseResources", 44.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          s.Draw();
          s.Mapper->ReleaseGraphicsResources(s.Window);
        },
        "" },
      { "Transfer2D", 44.0, 0.99,
        [](Scene& s)
        {
          SetImage(s, MakeImage(), 1.0);
          SetFunctions(s);
          SetTransfer2D(s);
        },
        "" },
      { "Transfer2DYScalars", 33.0, 0.96,
        [](Scene& s)
        {
          const auto image = MakeImage();
          const auto other = MakeVolume(
            PeerSamples, VTK_UNSIGNED_CHAR, [](int x, int y, int z) { return ValueAt(z, x, y); });
          other->GetPointData()->GetScalars()->SetName("other");
          image->GetPointData()->AddArray(other->GetPointData()->GetScalars());
          SetImage(s, image, 1.0);
          SetFunctions(s);
          SetTransfer2D(s);
          Both(s, [](auto* m) { m->SetTransfer2DYAxisArray("other"); });
        },
        "" },
      { "VolumeLightKit", 35.0, 0.98, [](Scene& s) { SetLights(s, false); }, "" },
      { "VolumePlane", 45.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Both(s, [](auto* m) { AddPlane(m, { 24.0, 22.0, 26.0 }, { 0.0, 0.0, 1.0 }); });
        },
        "" },
      { "VolumeRotation", 48.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Transform(s, 1.0);
        },
        "" },
      { "VolumeScale", 48.0, 0.99,
        [](Scene& s)
        {
          SetPlain(s);
          Transform(s, 1.5);
        },
        "" },
  };
}
} // namespace flatblock::testing
