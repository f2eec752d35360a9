/// Reads a volume through VTK's readers.
#pragma once

#include "Options.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"

struct LoadedVolume
{
  vtkSmartPointer<vtkImageData> Image;
  /// From data set coordinates to the patient's: x to the right, y to the front, z up. Only NIfTI
  /// and DICOM files say so.
  vtkSmartPointer<vtkMatrix4x4> Anatomy;
};

/// What an error of VTK's says, without where in its code.
std::string StripError(const std::string& text);

/// @throws std::runtime_error that names the file and what is wrong with it
LoadedVolume ReadVolume(const Options& options);
