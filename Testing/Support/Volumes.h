/// Volumes that tests make.
#pragma once

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <optional>
#include <string>

namespace flatblock::testing
{
/// An image with spacing 1 and origin 0 whose scalars are field(x, y, z) of the sample's indices,
/// converted to the VTK scalar type.
vtkSmartPointer<vtkImageData> MakeVolume(const std::array<int, 3>& samples, int scalarType,
  const std::function<double(int, int, int)>& field);

/// The test signal of Marschner and Lobb (1994, eq. 3; fM = 6, alpha = 0.25) on [-1, 1]^3, scaled
/// from [0, 1] to [0, 255]: n^3 samples of 8 bit, on a box of side 2.
vtkSmartPointer<vtkImageData> MarschnerLobb(int n);

/// vtkRTAnalyticSource with `n`^3 float samples and spacing (1, 1.5, 2).
vtkSmartPointer<vtkImageData> AnisotropicWavelet(int n);

/// Waves in all directions, from 50 to 950.
double WavesAt(int x, int y, int z);

/// They as 50 x 46 x 54 floats, with spacing (1, 1.2, 0.9).
vtkSmartPointer<vtkImageData> MakeWaves();

/// The MRI template ch2better.nii.gz of Debian's mricron-data, or of the file that the environment
/// variable FLATBLOCK_MRI names. Nothing where it is not installed.
std::optional<vtkSmartPointer<vtkImageData>> ReadMRI();
} // namespace flatblock::testing
