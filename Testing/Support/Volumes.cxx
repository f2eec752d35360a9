#include "Volumes.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRTAnalyticSource.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace flatblock::testing
{
vtkSmartPointer<vtkImageData> MakeVolume(const std::array<int, 3>& samples, int scalarType,
  const std::function<double(int, int, int)>& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(samples.data());
  image->AllocateScalars(scalarType, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->SetName("values");
  vtkIdType point = 0;
  for (int z = 0; z < samples[2]; ++z)
  {
    for (int y = 0; y < samples[1]; ++y)
    {
      for (int x = 0; x < samples[0]; ++x)
      {
        scalars->SetComponent(point++, 0, field(x, y, z));
      }
    }
  }
  return image;
}

vtkSmartPointer<vtkImageData> MarschnerLobb(int n)
{
  constexpr double Frequency = 6.0;
  constexpr double Alpha = 0.25;
  const double spacing = 2.0 / (n - 1);
  auto image = MakeVolume({ n, n, n }, VTK_UNSIGNED_CHAR,
    [spacing](int i, int j, int k)
    {
      const double x = -1.0 + i * spacing;
      const double y = -1.0 + j * spacing;
      const double z = -1.0 + k * spacing;
      const double pi = vtkMath::Pi();
      const double wave = std::cos(2.0 * pi * Frequency * std::cos(0.5 * pi * std::hypot(x, y)));
      const double value =
        (1.0 - std::sin(0.5 * pi * z) + Alpha * (1.0 + wave)) / (2.0 * (1.0 + Alpha));
      return std::round(255.0 * value);
    });
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-1.0, -1.0, -1.0);
  return image;
}

vtkSmartPointer<vtkImageData> AnisotropicWavelet(int n)
{
  vtkNew<vtkRTAnalyticSource> source;
  const int half = n / 2;
  source->SetWholeExtent(-half, n - 1 - half, -half, n - 1 - half, -half, n - 1 - half);
  source->Update();
  vtkSmartPointer<vtkImageData> image = source->GetOutput();
  image->SetSpacing(1.0, 1.5, 2.0);
  return image;
}

double WavesAt(int x, int y, int z)
{
  return 500.0 + 150.0 * (std::sin(0.21 * x) + std::cos(0.17 * y - 0.12 * x) + std::sin(0.19 * z));
}

vtkSmartPointer<vtkImageData> MakeWaves()
{
  const auto image = MakeVolume({ 50, 46, 54 }, VTK_FLOAT, WavesAt);
  image->SetSpacing(1.0, 1.2, 0.9);
  return image;
}

std::optional<vtkSmartPointer<vtkImageData>> ReadMRI()
{
  const char* named = std::getenv("FLATBLOCK_MRI");
  const std::string file = named ? named : "/usr/share/mricron/templates/ch2better.nii.gz";
  if (!std::filesystem::exists(file))
  {
    return {};
  }
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}
} // namespace flatblock::testing
