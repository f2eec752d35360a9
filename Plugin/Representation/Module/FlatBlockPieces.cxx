#include "FlatBlockPieces.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositeDataSetRange.h"
#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkStructuredData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace flatblock
{
namespace
{
using Extent = std::array<int, 6>;

// Of the cells that are no ghosts.
Extent GetOwnExtent(vtkImageData* image)
{
  Extent extent;
  image->GetExtent(extent.data());
  vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
  if (!ghosts || image->GetNumberOfCells() == 0)
  {
    return extent;
  }
  Extent own = { VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN };
  for (vtkIdType cell = 0; cell < ghosts->GetNumberOfValues(); ++cell)
  {
    if ((ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) == 0)
    {
      int first[3];
      vtkStructuredData::ComputeCellStructuredCoordsForExtent(cell, extent.data(), first);
      for (int axis = 0; axis < 3; ++axis)
      {
        own[2 * axis] = std::min(own[2 * axis], first[axis]);
        own[2 * axis + 1] = std::max(own[2 * axis + 1], first[axis] + 1);
      }
    }
  }
  return own[0] > own[1] ? extent : own;
}

void ForgetBits(vtkDataSetAttributes* data, unsigned char bits)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(data->GetArray(name));
  if (!ghosts)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> others; // the array may be shared
  others->DeepCopy(ghosts);
  bool hasAny = false;
  for (vtkIdType i = 0; i < others->GetNumberOfValues(); ++i)
  {
    others->SetValue(i, others->GetValue(i) & static_cast<unsigned char>(~bits));
    hasAny = hasAny || others->GetValue(i) != 0;
  }
  data->RemoveArray(name);
  if (hasAny)
  {
    data->AddArray(others);
  }
}

// As an append filter takes over what all have.
void HaveGhosts(vtkDataSetAttributes* data, vtkIdType count)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  if (!data->HasArray(name))
  {
    vtkNew<vtkUnsignedCharArray> none;
    none->SetName(name);
    none->SetNumberOfTuples(count);
    none->FillValue(0);
    data->AddArray(none);
  }
}

vtkSmartPointer<vtkImageData> CopyOwn(vtkImageData* image)
{
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->ShallowCopy(image);
  if (image->HasAnyGhostCells())
  {
    copy->Crop(GetOwnExtent(image).data());
    ForgetDuplicates(copy);
  }
  return copy;
}

// The extent of an image, counted in samples of another from that one's index 0.
std::optional<Extent> GetExtentIn(vtkImageData* grid, vtkImageData* image)
{
  constexpr double Tolerance = 1e-3; // of a spacing
  const double* spacing = grid->GetSpacing();
  const double* other = image->GetSpacing();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(other[axis] / spacing[axis] - 1.0) > 1e-6)
    {
      return {};
    }
  }
  const double* direction = grid->GetDirectionMatrix()->GetData();
  if (!std::equal(direction, direction + 9, image->GetDirectionMatrix()->GetData()))
  {
    return {};
  }
  double index[3];
  grid->TransformPhysicalPointToContinuousIndex(image->GetOrigin(), index);
  Extent extent;
  image->GetExtent(extent.data());
  for (int axis = 0; axis < 3; ++axis)
  {
    const double shift = std::round(index[axis]);
    if (!(std::abs(index[axis] - shift) < Tolerance) || std::abs(shift) > 1e9)
    {
      return {};
    }
    extent[2 * axis] += static_cast<int>(shift);
    extent[2 * axis + 1] += static_cast<int>(shift);
  }
  return extent;
}

double CountCells(const Extent& extent)
{
  double cells = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    cells *= static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis];
  }
  return cells;
}
} // namespace

void ForgetDuplicates(vtkImageData* image)
{
  ForgetBits(image->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
  ForgetBits(image->GetPointData(), vtkDataSetAttributes::DUPLICATEPOINT);
}

std::vector<vtkSmartPointer<vtkImageData>> GetImages(vtkDataObject* data)
{
  std::vector<vtkSmartPointer<vtkImageData>> images;
  const auto add = [&images](vtkDataObject* object)
  {
    auto* image = vtkImageData::SafeDownCast(object);
    if (image && image->GetNumberOfPoints() > 0)
    {
      images.push_back(CopyOwn(image));
    }
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    using Options = vtk::CompositeDataSetOptions;
    for (vtkDataObject* leaf : vtk::Range(composite, Options::SkipEmptyNodes))
    {
      add(leaf);
    }
    return images;
  }
  add(data);
  return images;
}

vtkSmartPointer<vtkImageData> MergeImages(const std::vector<vtkSmartPointer<vtkImageData>>& images)
{
  if (images.size() < 2)
  {
    return images.empty() ? nullptr : images.front();
  }
  Extent whole = { VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN };
  double cells = 0.0;
  vtkNew<vtkImageAppend> append;
  append->PreserveExtentsOn();
  const bool hasCellGhosts = std::any_of(images.begin(), images.end(),
    [](vtkImageData* image) { return image->GetCellGhostArray() != nullptr; });
  const bool hasPointGhosts = std::any_of(images.begin(), images.end(),
    [](vtkImageData* image) { return image->GetPointGhostArray() != nullptr; });
  for (vtkImageData* image : images)
  {
    const std::optional<Extent> extent = GetExtentIn(images.front(), image);
    if (!extent)
    {
      return nullptr;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      whole[2 * axis] = std::min(whole[2 * axis], (*extent)[2 * axis]);
      whole[2 * axis + 1] = std::max(whole[2 * axis + 1], (*extent)[2 * axis + 1]);
    }
    cells += CountCells(*extent);
    vtkNew<vtkImageData> moved;
    moved->ShallowCopy(image);
    moved->SetOrigin(images.front()->GetOrigin());
    moved->SetExtent(const_cast<int*>(extent->data()));
    if (hasCellGhosts)
    {
      HaveGhosts(moved->GetCellData(), moved->GetNumberOfCells());
    }
    if (hasPointGhosts)
    {
      HaveGhosts(moved->GetPointData(), moved->GetNumberOfPoints());
    }
    append->AddInputData(moved);
  }
  if (cells != CountCells(whole))
  {
    return nullptr;
  }
  append->Update();
  return append->GetOutput();
}
} // namespace flatblock
