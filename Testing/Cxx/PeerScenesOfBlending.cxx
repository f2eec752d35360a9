#include "PeerSceneParts.h"
#include "PeerScenes.h"

#include "vtkActor.h"
#include "vtkContourValues.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

namespace flatblock::testing
{
namespace
{
void SetBlend(Scene& scene, int mode, int type = VTK_UNSIGNED_CHAR)
{
  SetImage(scene, MakeImage(type));
  const double scale = type == VTK_UNSIGNED_CHAR || type == VTK_CHAR ? 1.0 : 10.0;
  SetFunctions(scene, 0.9, scale, type == VTK_CHAR ? -128.0 : 0.0);
  Both(scene, [mode](auto* mapper) { mapper->SetBlendMode(mode); });
}

void AddSphere(Scene& scene, double opacity)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(24.0, 22.0, 30.0);
  sphere->SetRadius(14.0);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.2, 0.8, 0.3);
  actor->GetProperty()->SetOpacity(opacity);
  scene.Renderer->AddActor(actor);
}

void SetIsosurfaces(Scene& scene)
{
  SetPlain(scene);
  scene.SetVolume(MakeImage(VTK_FLOAT), 0.1); // the peer finds surfaces within a step
  SetFunctions(scene, 0.8, 10.0);
  Shade(scene);
  vtkContourValues* values = scene.Property->GetIsoSurfaceValues();
  values->SetValue(0, 1500.0);
  values->SetValue(1, 1900.0);
  scene.SetOpacity({ { 1500.0, 0.4 }, { 1900.0, 0.9 } });
  Both(scene, [](auto* mapper) { mapper->SetBlendModeToIsoSurface(); });
}

void SetSlice(Scene& scene)
{
  SetPlain(scene);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(24.0, 22.0, 26.0);
  plane->SetNormal(1.0, 0.4, 0.3);
  scene.Property->SetSliceFunction(plane);
  Both(scene, [](auto* mapper) { mapper->SetBlendModeToSlice(); });
}
} // namespace

std::vector<PeerScene> GetPeerScenesOfBlending()
{
  using Mapper = vtkVolumeMapper;
  return {
    { "Additive", 43.0, 0.99,
      [](Scene& s)
      {
        SetBlend(s, Mapper::ADDITIVE_BLEND);
        s.SetOpacity({ { 120.0, 0.0 }, { 220.0, 0.05 } });
      },
      "" },
    { "AverageIP", 40.0, 0.99,
      [](Scene& s)
      {
        SetBlend(s, Mapper::AVERAGE_INTENSITY_BLEND);
        Both(s, [](auto* m) { m->SetAverageIPScalarRange(60.0, 230.0); });
      },
      "" },
    { "BlendModes", 39.0, 0.99, [](Scene& s) { SetBlend(s, Mapper::MINIMUM_INTENSITY_BLEND); },
      "" },
    { "CompositeToMIP", 50.0, 0.99,
      [](Scene& s)
      {
        SetPlain(s);
        s.Draw();
        s.DrawWithPeer();
        Both(s, [](auto* m) { m->SetBlendModeToMaximumIntensity(); });
      },
      "" },
    { "MIPToComposite", 44.0, 0.99,
      [](Scene& s)
      {
        SetBlend(s, Mapper::MAXIMUM_INTENSITY_BLEND);
        s.Draw();
        s.DrawWithPeer();
        SetFunctions(s);
        Both(s, [](auto* m) { m->SetBlendModeToComposite(); });
      },
      "" },
    { "DataTypesMIP", 46.0, 0.99,
      [](Scene& s) { SetBlend(s, Mapper::MAXIMUM_INTENSITY_BLEND, VTK_SHORT); }, "" },
    { "DataTypesMinIP", 41.0, 0.99,
      [](Scene& s) { SetBlend(s, Mapper::MINIMUM_INTENSITY_BLEND, VTK_DOUBLE); }, "" },
    { "NearestDataTypesMIP", 42.0, 0.98,
      [](Scene& s)
      {
        SetBlend(s, Mapper::MAXIMUM_INTENSITY_BLEND, VTK_UNSIGNED_INT);
        s.Property->SetInterpolationTypeToNearest();
      },
      "" },
    { "Isosurface", 34.0, 0.97, SetIsosurfaces, "the peer's surfaces lie within a step" },
    { "SlicePlane", 50.0, 0.99, SetSlice, "" },
    { "DepthPeeling", 44.0, 0.99,
      [](Scene& s)
      {
        SetPlain(s);
        AddSphere(s, 0.4);
        s.Window->SetAlphaBitPlanes(1);
        s.Renderer->UseDepthPeelingOn();
      },
      "" },
    { "DepthPeelingBlendModes", 44.0, 0.99,
      [](Scene& s)
      {
        SetBlend(s, Mapper::MAXIMUM_INTENSITY_BLEND);
        AddSphere(s, 0.4);
        s.Window->SetAlphaBitPlanes(1);
        s.Renderer->UseDepthPeelingOn();
      },
      "" },
    { "DepthPeelingClip", 33.0, 0.98,
      [](Scene& s)
      {
        SetPlain(s);
        Clip(s);
        AddSphere(s, 0.4);
        s.Window->SetAlphaBitPlanes(1);
        s.Renderer->UseDepthPeelingOn();
      },
      "the peer's first sample lies a part of a step behind the plane" },
    { "DepthPeelingOpaque", 43.0, 0.99,
      [](Scene& s)
      {
        SetPlain(s);
        AddSphere(s, 1.0);
        s.Window->SetAlphaBitPlanes(1);
        s.Renderer->UseDepthPeelingOn();
      },
      "" },
    { "VolumePolyData", 43.0, 0.99,
      [](Scene& s)
      {
        SetPlain(s);
        AddSphere(s, 1.0);
      },
      "" },
    { "ClippingPolyData", 33.0, 0.98,
      [](Scene& s)
      {
        SetPlain(s);
        Clip(s);
        AddSphere(s, 1.0);
      },
      "the peer's first sample lies a part of a step behind the plane" },
  };
}
} // namespace flatblock::testing
