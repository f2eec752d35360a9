// Each function of curvature, with both filters: regression images, nine views in a window.
#include "CurvatureFields.h"
#include "Rendering.h"
#include "Volumes.h"

#include "vtkContourValues.h"
#include "vtkExtractVOI.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

using namespace flatblock::testing;

namespace
{
using Mapper = vtkFlatBlockVolumeMapper;

struct View
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkFlatBlockVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
};

// From FirstPrincipal, top left, to LineFeature.
class Sheet
{
public:
  Sheet(vtkImageData* image, vtkVolumeProperty* property, int filter)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(384, 384);
    for (int i = 0; i < 9; ++i)
    {
      this->Views.push_back(std::make_unique<View>());
      View& view = *this->Views.back();
      const double left = i % 3 / 3.0;
      const double bottom = (2 - i / 3) / 3.0;
      view.Renderer->SetViewport(left, bottom, left + 1.0 / 3.0, bottom + 1.0 / 3.0);
      view.Mapper->SetInputData(image);
      view.Mapper->SetSampleDistance(0.5 * image->GetSpacing()[0]);
      view.Mapper->SetReconstructionFilter(filter);
      view.Mapper->SetCurvatureFunction(Mapper::FIRST_PRINCIPAL + i);
      view.Volume->SetMapper(view.Mapper);
      view.Volume->SetProperty(property);
      view.Renderer->AddVolume(view.Volume);
      this->Window->AddRenderer(view.Renderer);
    }
  }

  void LookFrom(double azimuth, double elevation, double roll, double zoom)
  {
    for (const auto& view : this->Views)
    {
      view->Renderer->ResetCamera();
      vtkCamera* camera = view->Renderer->GetActiveCamera();
      camera->Azimuth(azimuth);
      camera->Elevation(elevation);
      camera->Roll(roll);
      camera->Zoom(zoom);
      view->Renderer->ResetCameraClippingRange();
    }
  }

  vtkNew<vtkRenderWindow> Window;
  std::vector<std::unique_ptr<View>> Views;
};

const char* GetName(int filter)
{
  return filter == Mapper::LINEAR ? "Linear" : "CubicBSpline";
}
} // namespace

TEST(CurvaturePictures, OfTheTorus)
{
  const double spacing = 2.0 / 63.0;
  const auto image = MakeVolume({ 64, 64, 64 }, VTK_FLOAT,
    [&](int x, int y, int z)
    {
      return GetCurvatureField("torus").Value(
        { x * spacing - 1.0, y * spacing - 1.0, z * spacing - 1.0 });
    });
  image->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkVolumeProperty> property;
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(-0.02, 0.0);
  property->GetScalarOpacity()->AddPoint(0.02, 1.0);
  property->SetScalarOpacityUnitDistance(spacing);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    Sheet sheet(image, property, filter);
    for (const auto& view : sheet.Views)
    {
      view->Mapper->SetSilhouetteColor(1.0, 1.0, 1.0);
      view->Mapper->SetSilhouetteWidth(filter == Mapper::LINEAR ? 0.0 : 1.5 * spacing);
    }
    sheet.LookFrom(20.0, 35.0, 0.0, 2.1);
    EXPECT_TRUE(MatchesBaseline(sheet.Window, std::string("CurvatureOfTorus") + GetName(filter)));
  }
}

TEST(CurvaturePictures, OfTheMRI)
{
  const auto mri = ReadMRI();
  if (!mri)
  {
    GTEST_SKIP() << "No MRI: install mricron-data, or name the file in FLATBLOCK_MRI.";
  }
  vtkNew<vtkExtractVOI> part;
  part->SetInputData(*mri);
  part->SetSampleRate(2, 2, 2);
  part->Update();
  vtkNew<vtkVolumeProperty> property;
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(70.0, 0.0);
  property->GetScalarOpacity()->AddPoint(110.0, 0.5);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  for (int filter : { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE })
  {
    Sheet sheet(part->GetOutput(), property, filter);
    sheet.LookFrom(0.0, -60.0, 0.0, 1.6);
    EXPECT_TRUE(MatchesBaseline(sheet.Window, std::string("CurvatureOfMRI") + GetName(filter)));
  }
}
