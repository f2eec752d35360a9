/// VTK's and the project's readers of volumes, by the names of files.
#pragma once

#include "Options.h"

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

/// @throws std::runtime_error  where no reader is for the file, or its header says what the reader
///   would not survive
vtkSmartPointer<vtkAlgorithm> MakeReader(const Options& options);
