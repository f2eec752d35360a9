/// The volume that a mapper is to draw, checked.
#pragma once

#include "vtkSmartPointer.h"

#include <vector>

class vtkFlatBlockDataMapper;
class vtkDataArray;
class vtkImageData;
class vtkMatrix4x4;
class vtkVolumeProperty;

namespace flatblock
{
/// Which components of an array make a volume.
struct Components
{
  std::vector<int> Numbers; ///< as vtkFlatBlockScalars takes them; one of them at least
  bool AreIndependent = false;

  bool operator==(const Components& other) const
  {
    return this->Numbers == other.Numbers && this->AreIndependent == other.AreIndependent;
  }
};

struct VolumeInput
{
  vtkImageData* Image = nullptr;
  vtkDataArray* Scalars = nullptr;
  bool IsCellData = false; ///< samples are the cells, with one more around on each side
  flatblock::Components Components;
  vtkDataArray* SecondScalars = nullptr;         ///< rows of 2D functions
  vtkImageData* Mask = nullptr;                  ///< as large, with one component of scalars
  bool HasLabels = false;                        ///< in the mask
  vtkSmartPointer<vtkMatrix4x4> SampleToDataSet; ///< indices start at (0, 0, 0)
  double SmallestSpacing = 0.0;
  double Diagonal = 0.0; ///< of the box of samples, in the data set's unit of length
};

/// The mapper's image and the array that its scalar mode selects.
/// @throws std::runtime_error with a message for the user where there is no such volume
VolumeInput GetVolumeInput(vtkFlatBlockDataMapper& mapper, vtkVolumeProperty* property);
} // namespace flatblock
