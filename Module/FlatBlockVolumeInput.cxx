#include "FlatBlockVolumeInput.h"

#include "vtkAbstractMapper.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
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

vtkImageData* GetImage(vtkAbstractVolumeMapper& mapper)
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

std::string ListArrays(vtkImageData* image)
{
  std::string names;
  vtkPointData* arrays = image->GetPointData();
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    const char* name = arrays->GetArrayName(i);
    names += (i == 0 ? "" : ", ") + std::string(name ? name : "(no name)");
  }
  return names.empty() ? "none" : names;
}

vtkDataArray* GetScalars(vtkAbstractVolumeMapper& mapper, vtkImageData* image)
{
  int isCellData = 0;
  vtkDataArray* scalars = vtkAbstractMapper::GetScalars(image, mapper.GetScalarMode(),
    mapper.GetArrayAccessMode(), mapper.GetArrayId(), mapper.GetArrayName(), isCellData);
  if (!scalars)
  {
    const char* name = mapper.GetArrayName();
    Refuse("The input's point data has no ",
      name && *name ? "array named '" + std::string(name) + "'" : std::string("scalars"),
      "; its arrays: ", ListArrays(image), ".");
  }
  if (isCellData != 0)
  {
    Refuse("Cell data is selected, but point data is needed. vtkCellDataToPointData makes it.");
  }
  const char* name = scalars->GetName() ? scalars->GetName() : "";
  if (scalars->GetNumberOfComponents() != 1)
  {
    Refuse("The array '", name, "' has ", scalars->GetNumberOfComponents(),
      " components, but one is needed. vtkImageExtractComponents takes one out.");
  }
  if (scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    Refuse("The array '", name, "' has ", scalars->GetNumberOfTuples(),
      " values, but the input has ", image->GetNumberOfPoints(), " points.");
  }
  return scalars;
}

void SetGeometry(VolumeInput& input)
{
  const int* extent = input.Image->GetExtent();
  const double* spacing = input.Image->GetSpacing();
  input.SampleToDataSet = vtkSmartPointer<vtkMatrix4x4>::New();
  input.SampleToDataSet->DeepCopy(input.Image->GetIndexToPhysicalMatrix());
  const double first[4] = { static_cast<double>(extent[0]), static_cast<double>(extent[2]),
    static_cast<double>(extent[4]), 1.0 };
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

VolumeInput GetVolumeInput(vtkAbstractVolumeMapper& mapper)
{
  VolumeInput input;
  input.Image = GetImage(mapper);
  CheckGeometry(input.Image);
  input.Scalars = GetScalars(mapper, input.Image);
  SetGeometry(input);
  return input;
}
} // namespace flatblock
