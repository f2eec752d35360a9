/// The CT of Debian's invesalius-examples.
#pragma once

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace flatblock::benchmarks
{
/// Hounsfield units. Out of the file that the environment variable FLATBLOCK_SKULL names, a
/// matrix.dat, or of the installed package; null where neither is there.
vtkSmartPointer<vtkImageData> ReadCranium();
} // namespace flatblock::benchmarks
