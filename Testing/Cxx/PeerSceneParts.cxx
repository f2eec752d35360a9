#include "PeerSceneParts.h"

#include "Volumes.h"

#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"

#include <array>
#include <cmath>

namespace flatblock::testing
{
double ValueAt(int x, int y, int z)
{
  return std::round(
    127.0 + 42.0 * (std::sin(0.21 * x) + std::cos(0.17 * y - 0.12 * x) + std::sin(0.19 * z)));
}

vtkSmartPointer<vtkImageData> MakeImage(int type)
{
  const double scale = type == VTK_UNSIGNED_CHAR || type == VTK_CHAR ? 1.0 : 10.0;
  const double shift = type == VTK_CHAR || type == VTK_SIGNED_CHAR ? -128.0 : 0.0;
  return MakeVolume(
    PeerSamples, type, [=](int x, int y, int z) { return scale * ValueAt(x, y, z) + shift; });
}

void SetImage(Scene& scene, vtkImageData* image, double step)
{
  scene.SetVolume(image, step);
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 25.0, 1.2);
}

void SetFunctions(Scene& scene, double opacity, double scale, double shift)
{
  const auto at = [=](double value) { return scale * value + shift; };
  scene.SetOpacity({ { at(120.0), 0.0 }, { at(220.0), opacity } });
  scene.SetColor(
    { { at(0.0), 0.1, 0.2, 0.8 }, { at(127.0), 0.9, 0.4, 0.2 }, { at(255.0), 1.0, 0.9, 0.7 } });
}

void SetPlain(Scene& scene)
{
  SetImage(scene, MakeImage());
  SetFunctions(scene);
}

void Shade(Scene& scene)
{
  scene.Property->ShadeOn();
  scene.Property->SetSpecular(0.0); // which is Phong's or Blinn's by VTK's version
  scene.Property->SetAmbient(0.2);
  scene.Property->SetDiffuse(0.8);
}

void AddPlane(
  vtkVolumeMapper* mapper, const std::array<double, 3>& origin, const std::array<double, 3>& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.data());
  mapper->AddClippingPlane(plane);
}

void Clip(Scene& scene)
{
  Both(scene,
    [](auto* mapper)
    {
      AddPlane(mapper, { 24.0, 22.0, 26.0 }, { 1.0, 0.3, -0.2 });
      AddPlane(mapper, { 40.0, 22.0, 26.0 }, { -1.0, 0.0, 0.3 });
    });
}

void SetGradientOpacity(Scene& scene)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(2.0, 0.0);
  function->AddPoint(15.0, 1.0);
  scene.Property->SetGradientOpacity(function);
}
} // namespace flatblock::testing
