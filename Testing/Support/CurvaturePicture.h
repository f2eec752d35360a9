/// Pictures of curvature, as numbers.
#pragma once

#include "CurvatureFields.h"
#include "FloatPicture.h"

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkColorTransferFunction;
class vtkImageData;

namespace flatblock::testing
{
/// The field's surface in n^3 samples of the cube [-1, 1]^3, unlit.
void ShowField(Scene& scene, const CurvatureField& field, int n);

/// Translucent waves in blocks of 17 samples.
void ShowCloud(Scene& scene);

/// A translucent ball of radius 20, or another volume of 64^3 samples, in colours of its mean
/// curvature.
void ShowBall(Scene& scene, const std::array<double, 3>& spacing, vtkImageData* shape = nullptr);

/// Of a square picture.
std::array<double, 4> GetCenter(const Picture& picture, int width);

/// Black at one value, white at another.
vtkSmartPointer<vtkColorTransferFunction> MakeGray(double low, double high);

/// What the mapper's functions are called, from 0 on.
extern const char* const CurvatureNames[10];

double GetCurvature(int function, const PrincipalCurvatures& principal);

struct CurvaturePixel
{
  int Pixel = 0;
  std::array<double, 3> Point = {}; ///< in samples, where the ray meets the surface 0
  double Value = 0.0;               ///< of the mapper
};

/// Pixels whose ray meets the surface 0, at least so many samples from all faces, at an angle of 12
/// degrees or more: where it is grazed, rounding decides whether. Samples as far apart along all
/// axes.
std::vector<CurvaturePixel> FindPixels(
  Scene& scene, const SampledField& field, double margin = 2.0);

/// Sets their values, of a function of curvature, to what the mapper draws there; drops those that
/// it does not draw.
/// @param most  beyond which values are cut off
void MeasureCurvature(Scene& scene, int function, double most, std::vector<CurvaturePixel>& pixels);

/// The mapper's filter as the reference has it.
ReferenceFilter GetFilter(Scene& scene);
} // namespace flatblock::testing
