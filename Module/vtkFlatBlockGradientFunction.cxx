#include "vtkFlatBlockGradientFunction.h"

#include "TransferTable.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkFlatBlockGradientFunction);

namespace
{
constexpr int Magnitudes = 1024;
constexpr double ShareOfRange = 0.25; // that the largest magnitude is

bool IsOne(vtkPiecewiseFunction* function)
{
  bool isOne = true;
  for (int node = 0; node < function->GetSize(); ++node)
  {
    double values[4];
    function->GetNodeValue(node, values);
    isOne = isOne && values[1] == 1.0;
  }
  return isOne;
}

flatblock::GradientTable MakeOpacity(vtkPiecewiseFunction* function, double span)
{
  flatblock::GradientTable table = { 1, Magnitudes, std::vector<float>(Magnitudes) };
  function->GetTable(0.0, std::max(ShareOfRange * span, 1e-30), Magnitudes, table.Texels.data());
  if (!std::all_of(
        table.Texels.begin(), table.Texels.end(), [](float share) { return std::isfinite(share); }))
  {
    throw std::runtime_error("The gradient opacity function has a value that is not finite.");
  }
  return table;
}

flatblock::GradientTable MakeColors(vtkImageData* image, double distance)
{
  flatblock::GradientTable table;
  const auto colors = flatblock::GetTwoDimensionalColors(image);
  table.Width = image->GetDimensions()[0];
  table.Height = image->GetDimensions()[1];
  table.Texels.resize(4 * colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    std::copy_n(colors[i].begin(), 3, &table.Texels[4 * i]);
    table.Texels[4 * i + 3] = static_cast<float>(flatblock::GetExtinction(colors[i][3], distance));
  }
  return table;
}
} // namespace

namespace flatblock
{
bool HasTwoDimensions(vtkVolumeProperty* property)
{
  return property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D;
}

bool HasGradientOpacity(vtkVolumeProperty* property)
{
  return !HasTwoDimensions(property) && property->HasGradientOpacity() &&
         !property->GetDisableGradientOpacity() && !IsOne(property->GetGradientOpacity());
}

std::vector<std::array<float, 4>> GetTwoDimensionalColors(vtkImageData* image)
{
  constexpr int MostTexels = 8192; // the side that every driver with OpenGL 3.2 takes
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  const int* size = image ? image->GetDimensions() : nullptr;
  if (!scalars || scalars->GetNumberOfComponents() != 4 || size[0] < 2 || size[0] > MostTexels ||
      size[1] < 1 || size[1] > MostTexels || size[2] != 1)
  {
    throw std::runtime_error(
      "A 2D transfer function is an image of 2 x 1 to 8192 x 8192 x 1 points with scalars of 4 "
      "components, in vtkVolumeProperty::SetTransferFunction2D().");
  }
  const double scale = scalars->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
  std::vector<std::array<float, 4>> colors(scalars->GetNumberOfTuples());
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    double tuple[4];
    scalars->GetTuple(static_cast<vtkIdType>(i), tuple);
    for (int c = 0; c < 4; ++c)
    {
      colors[i][c] = tuple[c] > 0.0 ? static_cast<float>(std::min(scale * tuple[c], 1.0)) : 0.0F;
    }
  }
  return colors;
}
} // namespace flatblock

void vtkFlatBlockGradientFunction::Update(
  vtkVolumeProperty* property, const flatblock::ValueRange& range, double unitOfLength)
{
  const bool hasColors = flatblock::HasTwoDimensions(property);
  const bool isUsed = hasColors || flatblock::HasGradientOpacity(property);
  vtkMTimeType edited = property->GetMTime();
  if (isUsed)
  {
    vtkObject* function = hasColors ? static_cast<vtkObject*>(property->GetTransferFunction2D())
                                    : static_cast<vtkObject*>(property->GetGradientOpacity());
    edited = std::max(edited, function ? function->GetMTime() : 0);
  }
  const double span = range.Highest - range.Lowest;
  if (this->BuiltProperty == property && this->BuiltTime == edited &&
      this->BuiltUnit == unitOfLength && this->BuiltSpan == span)
  {
    return;
  }
  this->Table = {};
  if (hasColors)
  {
    this->Table = MakeColors(
      property->GetTransferFunction2D(), property->GetScalarOpacityUnitDistance() / unitOfLength);
  }
  else if (isUsed)
  {
    this->Table = MakeOpacity(property->GetGradientOpacity(), span);
  }
  this->BuiltProperty = property;
  this->BuiltTime = edited;
  this->BuiltUnit = unitOfLength;
  this->BuiltSpan = span;
  this->Modified();
}

void vtkFlatBlockGradientFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Table: " << this->Table.Width << " x " << this->Table.Height << "\n";
}
