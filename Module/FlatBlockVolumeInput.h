/// The volume that a mapper is to draw, checked.
#pragma once

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkFlatBlockDataMapper;
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

/// It holds what it names: observers of a frame may take the mapper's input away.
struct VolumeInput
{
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkDataArray> Scalars;
  bool IsCellData = false; ///< samples are the cells, with one more around on each side
  flatblock::Components Components;
  vtkSmartPointer<vtkDataArray> SecondScalars;   ///< rows of 2D functions
  vtkSmartPointer<vtkImageData> Mask;            ///< as large, with one component of scalars
  bool HasLabels = false;                        ///< in the mask
  vtkSmartPointer<vtkMatrix4x4> SampleToDataSet; ///< indices start at (0, 0, 0)
  double SmallestSpacing = 0.0;
  double Diagonal = 0.0; ///< of the box of samples, in the data set's unit of length
};

/// The mapper's image and the array that its scalar mode selects.
/// @throws std::runtime_error with a message for the user where there is no such volume
VolumeInput GetVolumeInput(vtkFlatBlockDataMapper& mapper, vtkVolumeProperty* property);
} // namespace flatblock
