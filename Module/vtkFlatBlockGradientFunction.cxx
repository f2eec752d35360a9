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
#include <utility>

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

vtkPiecewiseFunction* GetFunction(vtkVolumeProperty* property, int component)
{
  const bool isSet =
    property->HasGradientOpacity(component) && !property->GetDisableGradientOpacity(component);
  return isSet ? property->GetGradientOpacity(component) : nullptr;
}

// A column a component.
flatblock::FunctionTable MakeOpacity(
  vtkVolumeProperty* property, const std::vector<double>& spans, bool isForEach)
{
  flatblock::FunctionTable table = { static_cast<int>(spans.size()), Magnitudes,
    std::vector<float>(spans.size() * Magnitudes, 1.0F) };
  for (std::size_t i = 0; i < spans.size(); ++i)
  {
    vtkPiecewiseFunction* function = GetFunction(property, isForEach ? static_cast<int>(i) : 0);
    if (function)
    {
      function->GetTable(0.0, std::max(ShareOfRange * spans[i], 1e-30), Magnitudes,
        table.Texels.data() + i, static_cast<int>(spans.size()));
    }
  }
  if (!std::all_of(
        table.Texels.begin(), table.Texels.end(), [](float share) { return std::isfinite(share); }))
  {
    throw std::runtime_error("The gradient opacity function has a value that is not finite.");
  }
  return table;
}

flatblock::FunctionTable MakeColors(vtkImageData* image, double distance)
{
  flatblock::FunctionTable table;
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

bool HasGradientOpacity(vtkVolumeProperty* property, int components)
{
  bool isAny = false;
  for (int i = 0; i < components && !HasTwoDimensions(property); ++i)
  {
    vtkPiecewiseFunction* function = GetFunction(property, i);
    isAny = isAny || (function && !IsOne(function));
  }
  return isAny;
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

namespace
{
vtkMTimeType GetLastEdit(vtkVolumeProperty* property, int components)
{
  vtkMTimeType edited = property->GetMTime();
  if (flatblock::HasTwoDimensions(property))
  {
    vtkImageData* image = property->GetTransferFunction2D();
    return std::max(edited, image ? image->GetMTime() : 0);
  }
  for (int i = 0; i < components; ++i)
  {
    vtkPiecewiseFunction* function = GetFunction(property, i);
    edited = std::max(edited, function ? function->GetMTime() : 0);
  }
  return edited;
}
} // namespace

void vtkFlatBlockGradientFunction::Update(vtkVolumeProperty* property,
  const std::vector<flatblock::ValueRange>& ranges, bool isForEach, double unitOfLength)
{
  const int functions = isForEach ? static_cast<int>(ranges.size()) : 1;
  const vtkMTimeType edited = GetLastEdit(property, functions);
  std::vector<double> spans(ranges.size());
  std::transform(ranges.begin(), ranges.end(), spans.begin(),
    [](const flatblock::ValueRange& range) { return range.Highest - range.Lowest; });
  if (this->BuiltProperty == property && this->BuiltTime == edited &&
      this->BuiltUnit == unitOfLength && this->BuiltSpans == spans &&
      this->BuiltForEach == isForEach)
  {
    return;
  }
  flatblock::FunctionTable table;
  if (flatblock::HasTwoDimensions(property))
  {
    table = MakeColors(
      property->GetTransferFunction2D(), property->GetScalarOpacityUnitDistance() / unitOfLength);
  }
  else if (flatblock::HasGradientOpacity(property, functions))
  {
    table = MakeOpacity(property, spans, isForEach);
  }
  this->Table = std::move(table);
  this->BuiltProperty = property;
  this->BuiltTime = edited;
  this->BuiltUnit = unitOfLength;
  this->BuiltSpans = spans;
  this->BuiltForEach = isForEach;
  this->Modified();
}

void vtkFlatBlockGradientFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Table: " << this->Table.Width << " x " << this->Table.Height << "\n";
}
