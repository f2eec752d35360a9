#include "CurvaturePicture.h"

#include "Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace flatblock::testing
{
const char* const CurvatureNames[10] = { "None", "FirstPrincipal", "SecondPrincipal", "Mean",
  "Gaussian", "Total", "LargestMagnitude", "ShapeIndex", "Curvedness", "LineFeature" };

void ShowField(Scene& scene, const CurvatureField& field, int n)
{
  const double spacing = 2.0 / (n - 1);
  const auto image = MakeVolume({ n, n, n }, VTK_FLOAT,
    [&](int x, int y, int z) {
      return field.Value({ x * spacing - 1.0, y * spacing - 1.0, z * spacing - 1.0 });
    });
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-1.0, -1.0, -1.0);
  scene.SetVolume(image, 0.25 * spacing);
  scene.SetOpacity({ { -1e3, 1.0 }, { 1e3, 1.0 } });
  scene.Mapper->SetBlendMode(vtkVolumeMapper::ISOSURFACE_BLEND);
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.0);
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.4);
}

void ShowCloud(Scene& scene)
{
  scene.SetVolume(MakeWaves(), 0.3);
  scene.SetOpacity({ { 600.0, 0.0 }, { 750.0, 0.3 } });
  scene.SetColor({ { 500.0, 0.8, 0.3, 0.2 }, { 700.0, 0.9, 0.9, 0.7 } });
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.3);
}

void ShowBall(Scene& scene, const std::array<double, 3>& spacing, vtkImageData* shape)
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
vtkSmartPointer<vtkColorTransferFunction> MakeGray(double low, double high)
{
  auto gray = vtkSmartPointer<vtkColorTransferFunction>::New();
  gray->AddRGBPoint(low, 0.0, 0.0, 0.0);
  gray->AddRGBPoint(high, 1.0, 1.0, 1.0);
  return gray;
}

double GetCurvature(int function, const PrincipalCurvatures& principal)
{
  using Mapper = vtkFlatBlockVolumeMapper;
  const auto [k1, k2] = principal;
  switch (function)
  {
  case Mapper::FIRST_PRINCIPAL:
    return k1;
  case Mapper::SECOND_PRINCIPAL:
    return k2;
  case Mapper::MEAN:
    return 0.5 * (k1 + k2);
  case Mapper::GAUSSIAN:
    return k1 * k2;
  case Mapper::TOTAL:
    return std::hypot(k1, k2);
  case Mapper::LARGEST_MAGNITUDE:
    return std::abs(k1) > std::abs(k2) ? k1 : k2;
  case Mapper::SHAPE_INDEX:
    return 2.0 / 3.14159265358979323846 * std::atan2(k1 + k2, k1 - k2);
  case Mapper::CURVEDNESS:
    return std::sqrt(0.5 * (k1 * k1 + k2 * k2));
  case Mapper::LINE_FEATURE:
    return (k1 + k2 < 0.0 ? -1.0 : 1.0) * std::abs(std::abs(k1) - std::abs(k2));
  default:
    return 0.0;
  }
}

ReferenceFilter GetFilter(Scene& scene)
{
  return scene.Mapper->GetReconstructionFilter() == vtkFlatBlockVolumeMapper::LINEAR
           ? ReferenceFilter::Trilinear
           : ReferenceFilter::CubicBSpline;
}

std::vector<CurvaturePixel> FindPixels(Scene& scene, const SampledField& field, double margin)
{
  constexpr double LeastCosine = 0.2;
  const ReferenceView view = GetReferenceView(scene);
  const auto surface = FindSurface(field, view, 0.0);
  std::vector<CurvaturePixel> pixels;
  for (int i = 0; i < static_cast<int>(surface.size()); ++i)
  {
    const std::array<double, 3> point = { surface[i][1], surface[i][2], surface[i][3] };
    bool isInside = surface[i][0] > 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      isInside =
        isInside && point[axis] >= margin && point[axis] <= field.GetSamples()[axis] - 1 - margin;
    }
    const auto sight = MakeReferenceRay(view, i % view.Width, i / view.Width).second;
    const double direction[3] = { static_cast<double>(sight[0]), static_cast<double>(sight[1]),
      static_cast<double>(sight[2]) };
    const auto gradient = field.GetDerivatives(point).Gradient;
    const double lengths = vtkMath::Norm(direction) * vtkMath::Norm(gradient.data());
    if (isInside && std::abs(vtkMath::Dot(direction, gradient.data())) > LeastCosine * lengths)
    {
      pixels.push_back({ i, point });
    }
  }
  return pixels;
}

void MeasureCurvature(Scene& scene, int function, double most, std::vector<CurvaturePixel>& pixels)
{
  scene.Mapper->SetCurvatureFunction(function);
  scene.Mapper->SetCurvatureColor(MakeGray(0.0, 1.0));
  scene.Mapper->SetCurvatureRange(-most, most);
  const Picture drawn = DrawFloats(scene);
  pixels.erase(std::remove_if(pixels.begin(), pixels.end(),
                 [&drawn](const CurvaturePixel& pixel) { return drawn[pixel.Pixel][3] < 0.999; }),
    pixels.end());
  for (CurvaturePixel& pixel : pixels)
  {
    pixel.Value = (2.0 * drawn[pixel.Pixel][0] - 1.0) * most;
  }
}
} // namespace flatblock::testing
