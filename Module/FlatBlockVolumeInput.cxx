#include "FlatBlockVolumeInput.h"

#include "vtkAbstractMapper.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFlatBlockDataMapper.h"
#include "vtkFlatBlockScalars.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>

namespace flatblock
{
namespace
{
template <typename... Parts>
[[noreturn]] void Refuse(const Parts&... parts)
{
  std::ostringstream message;
  (message << ... << parts);
  throw std::runtime_error(message.str());
}

vtkImageData* GetImage(vtkFlatBlockDataMapper& mapper)
{
  if (mapper.GetNumberOfInputConnections(0) == 0)
  {
    Refuse("There is no input. Call SetInputData() or SetInputConnection() with a vtkImageData.");
  }
  vtkDataObject* data = mapper.GetInputDataObject(0, 0);
  auto* image = vtkImageData::SafeDownCast(data);
  if (!image)
  {
    Refuse("The input is ", data ? data->GetClassName() : "nothing",
      ", but a vtkImageData is needed. vtkResampleToImage makes one of any data set.");
  }
  return image;
}

void CheckGeometry(vtkImageData* image)
{
  int n[3];
  image->GetDimensions(n);
  if (n[0] < 1 || n[1] < 1 || n[2] < 1)
  {
    Refuse("The input's extent is empty.");
  }
  if (n[0] < 2 || n[1] < 2 || n[2] < 2)
  {
    Refuse("The input has ", n[0], " x ", n[1], " x ", n[2],
      " samples; a volume has at least two along each axis.");
  }
  const double* spacing = image->GetSpacing();
  const double volume = std::abs(image->GetIndexToPhysicalMatrix()->Determinant());
  if (!(volume > 0.0) || !std::isfinite(volume))
  {
    Refuse("The input's spacing (", spacing[0], ", ", spacing[1], ", ", spacing[2],
      ") and direction span no volume.");
  }
}

std::string ListArrays(vtkDataSetAttributes* arrays)
{
  std::string names;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    const char* name = arrays->GetArrayName(i);
    names += (i == 0 ? "" : ", ") + std::string(name ? name : "(no name)");
  }
  return names.empty() ? "none" : names;
}

void SetScalars(vtkFlatBlockDataMapper& mapper, VolumeInput& input)
{
  int isCellData = 0;
  input.Scalars = vtkAbstractMapper::GetScalars(input.Image, mapper.GetScalarMode(),
    mapper.GetArrayAccessMode(), mapper.GetArrayId(), mapper.GetArrayName(), isCellData);
  if (!input.Scalars)
  {
    const char* name = mapper.GetArrayName();
    Refuse("The input has no ",
      name && *name ? "array named '" + std::string(name) + "'" : std::string("scalars"),
      " where ScalarMode looks for it; its point data has: ",
      ListArrays(input.Image->GetPointData()),
      "; its cell data: ", ListArrays(input.Image->GetCellData()), ".");
  }
  input.IsCellData = isCellData != 0;
  const vtkIdType wanted =
    input.IsCellData ? input.Image->GetNumberOfCells() : input.Image->GetNumberOfPoints();
  if (input.Scalars->GetNumberOfTuples() != wanted)
  {
    const char* name = input.Scalars->GetName() ? input.Scalars->GetName() : "";
    Refuse("The array '", name, "' has ", input.Scalars->GetNumberOfTuples(),
      " values, but the input has ", wanted, input.IsCellData ? " cells." : " points.");
  }
}

Components GetComponents(
  vtkFlatBlockDataMapper& mapper, vtkDataArray* scalars, vtkVolumeProperty* property)
{
  constexpr int MostComponents = 4;
  const std::string name = scalars->GetName() ? scalars->GetName() : "";
  const int count = scalars->GetNumberOfComponents();
  const int mode = mapper.GetVectorMode();
  if (mode == vtkFlatBlockDataMapper::COMPONENT && mapper.GetVectorComponent() >= count)
  {
    Refuse("The array '", name, "' has ", count, " components; VectorComponent is ",
      mapper.GetVectorComponent(), ".");
  }
  if (mode != vtkFlatBlockDataMapper::DISABLED || count == 1)
  {
    const bool isNorm = mode == vtkFlatBlockDataMapper::MAGNITUDE && count > 1;
    const bool isOne = mode == vtkFlatBlockDataMapper::COMPONENT;
    return { { isNorm  ? vtkFlatBlockScalars::Magnitude
               : isOne ? mapper.GetVectorComponent()
                       : 0 },
      false };
  }
  const bool areIndependent = property->GetIndependentComponents() != 0;
  if (count > MostComponents || (!areIndependent && count == 3))
  {
    Refuse("The array '", name, "' has ", count, " components; ",
      areIndependent ? "1 to 4 can be drawn" : "of dependent ones 2 or 4 can be drawn",
      ". SetVectorMode() takes one of them, or their magnitude.");
  }
  Components components = { std::vector<int>(count), areIndependent };
  std::iota(components.Numbers.begin(), components.Numbers.end(), 0);
  return components;
}

void SetSecondScalars(
  vtkFlatBlockDataMapper& mapper, vtkVolumeProperty* property, VolumeInput& input)
{
  const char* name = mapper.GetTransfer2DYAxisArray();
  if (!name || !*name || property->GetTransferFunctionMode() != vtkVolumeProperty::TF_2D ||
      mapper.GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    return;
  }
  vtkDataSetAttributes* arrays =
    input.IsCellData ? static_cast<vtkDataSetAttributes*>(input.Image->GetCellData())
                     : static_cast<vtkDataSetAttributes*>(input.Image->GetPointData());
  input.SecondScalars = arrays->GetArray(name);
  if (!input.SecondScalars || input.SecondScalars->GetNumberOfComponents() != 1 ||
      input.SecondScalars->GetNumberOfTuples() != input.Scalars->GetNumberOfTuples())
  {
    Refuse("Transfer2DYAxisArray, '", name,
      "', is no array of one component beside the one that is "
      "drawn; there are: ",
      ListArrays(arrays), ".");
  }
  if (input.Components.Numbers.size() > 1 || input.Mask)
  {
    Refuse("Transfer2DYAxisArray is drawn with one component and without a mask only.");
  }
}

void SetMask(vtkFlatBlockDataMapper& mapper, vtkVolumeProperty* property, VolumeInput& input)
{
  input.Mask = mapper.GetMaskInput();
  input.HasLabels = mapper.GetMaskType() == vtkFlatBlockDataMapper::LabelMapMaskType;
  if (!input.Mask)
  {
    return;
  }
  vtkDataArray* labels = input.Mask->GetPointData()->GetScalars();
  if (!labels || labels->GetNumberOfComponents() != 1 ||
      labels->GetNumberOfTuples() != input.Scalars->GetNumberOfTuples())
  {
    Refuse("The mask needs point scalars of one component and ", input.Scalars->GetNumberOfTuples(),
      " values, not ", labels ? labels->GetNumberOfTuples() : 0, " of ",
      labels ? labels->GetNumberOfComponents() : 0, ".");
  }
  const bool isComposite = mapper.GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND;
  if (input.Components.Numbers.size() > 1 || (input.HasLabels && !isComposite))
  {
    Refuse("A mask is drawn with one component, and one of labels with composite blending only.");
  }
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    Refuse("A mask is drawn with 1D transfer functions only.");
  }
  for (const int label : property->GetLabelMapLabels())
  {
    if (input.HasLabels && property->GetLabelGradientOpacity(label))
    {
      Refuse("Labels of a mask are drawn with the volume's gradient opacity, and label ", label,
        " has one of its own.");
    }
  }
}

void SetGeometry(VolumeInput& input)
{
  const int* extent = input.Image->GetExtent();
  const double* spacing = input.Image->GetSpacing();
  input.SampleToDataSet = vtkSmartPointer<vtkMatrix4x4>::New();
  input.SampleToDataSet->DeepCopy(input.Image->GetIndexToPhysicalMatrix());
  const double shift = input.IsCellData ? -0.5 : 0.0;
  const double first[4] = { extent[0] + shift, extent[2] + shift, extent[4] + shift, 1.0 };
  double origin[4];
  input.SampleToDataSet->MultiplyPoint(first, origin);
  double sides[3];
  for (int i = 0; i < 3; ++i)
  {
    input.SampleToDataSet->SetElement(i, 3, origin[i]);
    sides[i] = spacing[i] * (extent[2 * i + 1] - extent[2 * i]);
  }
  input.SmallestSpacing =
    std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  input.Diagonal = std::hypot(sides[0], sides[1], sides[2]);
}
} // namespace

VolumeInput GetVolumeInput(vtkFlatBlockDataMapper& mapper, vtkVolumeProperty* property)
{
  VolumeInput input;
  input.Image = GetImage(mapper);
  CheckGeometry(input.Image);
  SetScalars(mapper, input);
  input.Components = GetComponents(mapper, input.Scalars, property);
  SetMask(mapper, property, input);
  SetSecondScalars(mapper, property, input);
  SetGeometry(input);
  return input;
}
} // namespace flatblock
