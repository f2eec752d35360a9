/// What vtkNIFTIImageReader does not survive.
#pragma once

#include <string>

/// Reads the header of a NIfTI file of version 1 or 2, plain or gzip (nifti1.h and nifti2.h of
/// https://nifti.nimh.nih.gov).
/// @throws std::runtime_error  that names the file, and the field that says something else than a
///   volume whose samples are there
void CheckNIfTI(const std::string& file);
