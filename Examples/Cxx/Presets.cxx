#include "Presets.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// A point of a transfer function: where, how opaque, which colour.
struct Node
{
  double Value;
  double Opacity;
  double R, G, B;
};

// Values of a share of the samples, sorted.
std::vector<double> SortedSamples(vtkImageData* image)
{
  constexpr vtkIdType Most = 1000000;
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const vtkIdType count = scalars->GetNumberOfTuples();
  const vtkIdType stride = std::max<vtkIdType>(1, count / Most) | 1; // odd: not along one axis
  std::vector<double> samples;
  for (vtkIdType i = 0; i < count; i += stride)
  {
    const double value = scalars->GetComponent(i, 0);
    if (std::isfinite(value))
    {
      samples.push_back(value);
    }
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

double Quantile(const std::vector<double>& sorted, double share)
{
  return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(share * (sorted.size() - 1))];
}

// Air and the like: what lies in the lowest twentieth of the values' extent is left out.
std::vector<double> WithoutBackground(const std::vector<double>& sorted)
{
  const double lowest = Quantile(sorted, 0.001);
  const double highest = Quantile(sorted, 0.999);
  const auto first =
    std::upper_bound(sorted.begin(), sorted.end(), lowest + 0.05 * (highest - lowest));
  return { first, sorted.end() };
}

std::vector<Node> MakeNodes(const std::string& name, vtkImageData* image)
{
  if (name == "ct-bone")
  {
    return { { 150.0, 0.0, 0.6, 0.3, 0.2 }, { 350.0, 0.25, 0.9, 0.8, 0.6 },
      { 900.0, 0.85, 1.0, 0.97, 0.9 }, { 2500.0, 0.95, 1.0, 1.0, 1.0 } };
  }
  if (name == "ct-skin")
  {
    return { { -500.0, 0.0, 0.6, 0.35, 0.25 }, { -250.0, 0.5, 0.85, 0.6, 0.45 },
      { 100.0, 0.6, 0.9, 0.7, 0.55 }, { 400.0, 0.9, 1.0, 0.95, 0.85 } };
  }
  const std::vector<double> foreground = WithoutBackground(SortedSamples(image));
  const auto at = [&foreground](double share) { return Quantile(foreground, share); };
  if (name == "mri")
  {
    return { { at(0.15), 0.0, 0.25, 0.1, 0.1 }, { at(0.5), 0.25, 0.75, 0.5, 0.4 },
      { at(0.85), 0.6, 0.95, 0.85, 0.75 }, { at(0.995), 0.9, 1.0, 1.0, 0.95 } };
  }
  if (name == "angio")
  {
    return { { at(0.9), 0.0, 0.3, 0.0, 0.0 }, { at(0.97), 0.3, 0.8, 0.1, 0.05 },
      { at(0.999), 0.95, 1.0, 0.85, 0.6 } };
  }
  if (name == "grey")
  {
    return { { at(0.0), 0.0, 0.0, 0.0, 0.0 }, { at(0.995), 0.5, 1.0, 1.0, 1.0 } };
  }
  return { { at(0.1), 0.0, 0.2, 0.25, 0.45 }, { at(0.4), 0.08, 0.55, 0.5, 0.55 },
    { at(0.75), 0.35, 0.9, 0.75, 0.55 }, { at(0.995), 0.9, 1.0, 1.0, 0.95 } };
}
} // namespace

const std::vector<std::string>& GetPresetNames()
{
  static const std::vector<std::string> names = { "mri", "ct-bone", "ct-skin", "angio", "grey" };
  return names;
}

void ApplyPreset(const std::string& name, vtkImageData* image, vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const Node& node : MakeNodes(name, image))
  {
    color->AddRGBPoint(node.Value, node.R, node.G, node.B);
    opacity->AddPoint(node.Value, node.Opacity);
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  const double* spacing = image->GetSpacing();
  property->SetScalarOpacityUnitDistance(2.0 * std::cbrt(spacing[0] * spacing[1] * spacing[2]));
  property->SetInterpolationTypeToLinear();
}
