/// The volume that a mapper is to draw, checked.
#pragma once

#include "vtkSmartPointer.h"

class vtkFlatBlockDataMapper;
class vtkDataArray;
class vtkImageData;
class vtkMatrix4x4;

namespace flatblock
{
struct VolumeInput
{
  vtkImageData* Image = nullptr;
  vtkDataArray* Scalars = nullptr;
  bool IsCellData = false; ///< samples are the cells, with one more around on each side
  int Component = 0;       ///< of the array, as vtkFlatBlockScalars takes it
  vtkSmartPointer<vtkMatrix4x4> SampleToDataSet; ///< indices start at (0, 0, 0)
  double SmallestSpacing = 0.0;
  double Diagonal = 0.0; ///< of the box of samples, in the data set's unit of length
};

/// The mapper's image and the array that its scalar mode selects.
/// @throws std::runtime_error with a message for the user where there is no such volume
VolumeInput GetVolumeInput(vtkFlatBlockDataMapper& mapper);
} // namespace flatblock
