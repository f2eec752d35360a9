#include "vtkFlatBlockCurvatureMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <array>

vtkFlatBlockCurvatureMapper::vtkFlatBlockCurvatureMapper() = default;
vtkFlatBlockCurvatureMapper::~vtkFlatBlockCurvatureMapper() = default;

namespace
{
// Whether they were others; they become what they are now, from 0 to 1.
bool Replace(double values[3], const std::array<double, 3>& others)
{
  std::array<double, 3> clamped;
  std::transform(others.begin(), others.end(), clamped.begin(),
    [](double value) { return std::clamp(value, 0.0, 1.0); });
  const bool isNew = !std::equal(clamped.begin(), clamped.end(), values);
  std::copy(clamped.begin(), clamped.end(), values);
  return isNew;
}
} // namespace

vtkMTimeType vtkFlatBlockCurvatureMapper::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = this->CurvatureColor ? std::max(time, this->CurvatureColor->GetMTime()) : time;
  return this->CurvatureOpacity ? std::max(time, this->CurvatureOpacity->GetMTime()) : time;
}

void vtkFlatBlockCurvatureMapper::SetCurvatureColor(vtkColorTransferFunction* color)
{
  if (this->CurvatureColor != color)
  {
    this->CurvatureColor = color;
    this->Modified();
  }
}

vtkColorTransferFunction* vtkFlatBlockCurvatureMapper::GetCurvatureColor()
{
  return this->CurvatureColor;
}

void vtkFlatBlockCurvatureMapper::SetCurvatureOpacity(vtkPiecewiseFunction* opacity)
{
  if (this->CurvatureOpacity != opacity)
  {
    this->CurvatureOpacity = opacity;
    this->Modified();
  }
}

vtkPiecewiseFunction* vtkFlatBlockCurvatureMapper::GetCurvatureOpacity()
{
  return this->CurvatureOpacity;
}

void vtkFlatBlockCurvatureMapper::GetUsedCurvatureRange(double range[2]) const
{
  std::copy_n(this->UsedCurvatureRange, 2, range);
}

void vtkFlatBlockCurvatureMapper::SetSilhouetteColor(double red, double green, double blue)
{
  if (Replace(this->SilhouetteColor, { red, green, blue }))
  {
    this->Modified();
  }
}

void vtkFlatBlockCurvatureMapper::SetGradientModulation(
  double ambient, double diffuse, double specular)
{
  if (Replace(this->GradientModulation, { ambient, diffuse, specular }))
  {
    this->Modified();
  }
}

void vtkFlatBlockCurvatureMapper::ShallowCopy(vtkAbstractMapper* other)
{
  if (auto* mapper = vtkFlatBlockCurvatureMapper::SafeDownCast(other))
  {
    this->SetReconstructionFilter(mapper->ReconstructionFilter);
    this->SetInterpolatingBSpline(mapper->InterpolatingBSpline);
    this->SetStillReconstructionFilter(mapper->StillReconstructionFilter);
    this->SetCurvatureFunction(mapper->CurvatureFunction);
    this->SetCurvatureColor(mapper->CurvatureColor);
    this->SetCurvatureOpacity(mapper->CurvatureOpacity);
    this->SetCurvatureRange(mapper->CurvatureRange);
    this->SetSilhouetteWidth(mapper->SilhouetteWidth);
    this->SetDerivativesOnDemand(mapper->DerivativesOnDemand);
    const double* color = mapper->SilhouetteColor;
    this->SetSilhouetteColor(color[0], color[1], color[2]);
    const double* modulation = mapper->GradientModulation;
    this->SetGradientModulation(modulation[0], modulation[1], modulation[2]);
  }
  this->Superclass::ShallowCopy(other);
}

void vtkFlatBlockCurvatureMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const filters[] = { "Same", "Linear", "CubicBSpline" };
  const char* const functions[] = { "None", "FirstPrincipal", "SecondPrincipal", "Mean", "Gaussian",
    "Total", "LargestMagnitude", "ShapeIndex", "Curvedness", "LineFeature" };
  const auto print = [&](const char* name, const double* values, int count)
  {
    os << indent << name << ":";
    std::for_each(values, values + count, [&os](double value) { os << " " << value; });
    os << "\n";
  };
  os << indent << "ReconstructionFilter: " << filters[this->ReconstructionFilter - SAME_FILTER]
     << "\n";
  os << indent << "InterpolatingBSpline: " << this->InterpolatingBSpline << "\n";
  os << indent
     << "StillReconstructionFilter: " << filters[this->StillReconstructionFilter - SAME_FILTER]
     << "\n";
  os << indent << "CurvatureFunction: " << functions[this->CurvatureFunction] << "\n";
  os << indent << "CurvatureColor: " << this->CurvatureColor << "\n";
  os << indent << "CurvatureOpacity: " << this->CurvatureOpacity << "\n";
  print("CurvatureRange", this->CurvatureRange, 2);
  print("UsedCurvatureRange", this->UsedCurvatureRange, 2);
  print("SilhouetteWidth", &this->SilhouetteWidth, 1);
  print("SilhouetteColor", this->SilhouetteColor, 3);
  print("GradientModulation", this->GradientModulation, 3);
  os << indent << "DerivativesOnDemand: " << this->DerivativesOnDemand << "\n";
}
