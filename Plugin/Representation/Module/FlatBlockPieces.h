/// Images of composite data sets.
#pragma once

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkImageData;

namespace flatblock
{
/// Says that no cell and no point is there twice; those that are hidden stay hidden.
void ForgetDuplicates(vtkImageData* image);

/// The images in a data object, without ghost cells; itself where it is one.
std::vector<vtkSmartPointer<vtkImageData>> GetImages(vtkDataObject* data);

/// One image of all, with their arrays of points and cells, where they have one spacing and
/// direction, fill a box without gaps, and their samples lie on one grid; nullptr elsewhere.
vtkSmartPointer<vtkImageData> MergeImages(const std::vector<vtkSmartPointer<vtkImageData>>& images);
} // namespace flatblock
