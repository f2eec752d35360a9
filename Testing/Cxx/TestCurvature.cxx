// Curvature against the reference on the CPU, and against closed forms.
#include "CurvaturePicture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace flatblock::testing;

namespace
{
struct Errors
{
  double Mean = 0.0;
  double Largest = 0.0;
  int Pixels = 0;
};

template <typename Expected>
Errors Compare(const std::vector<CurvaturePixel>& pixels, const Expected& expected)
{
  Errors errors;
  for (const CurvaturePixel& pixel : pixels)
  {
    const double error = std::abs(pixel.Value - expected(pixel));
    errors.Mean += error;
    errors.Largest = std::max(errors.Largest, error);
    ++errors.Pixels;
  }
  errors.Mean /= std::max(errors.Pixels, 1);
  return errors;
}
} // namespace

TEST(Curvature, Probe)
{
  for (const CurvatureField& field : GetCurvatureFields())
  {
    for (int filter : { 0, 1 })
    {
      for (int n : { 32, 64 })
      {
        Scene scene;
        scene.Window->SetSize(128, 128);
        ShowField(scene, field, n);
        scene.Mapper->SetReconstructionFilter(filter);
        const SampledField sampled(ReadReferenceVolume(scene), GetFilter(scene));
        const auto view = GetReferenceView(scene);
        auto pixels = FindPixels(scene, sampled);
        for (int function : { 1, 2, 3, 4, 7 })
        {
          MeasureCurvature(scene, function, function == 7 ? 1.0 : 20.0, pixels);
          const Errors shader = Compare(pixels,
            [&](const CurvaturePixel& pixel)
            {
              return GetCurvature(function,
                GetPrincipalCurvatures(
                  ToLengths(sampled.GetDerivatives(pixel.Point), view.SampleToLength)));
            });
          const Errors closed = Compare(pixels,
            [&](const CurvaturePixel& pixel)
            {
              std::array<double, 3> p;
              for (int i = 0; i < 3; ++i)
              {
                p[i] = -1.0 + pixel.Point[i] * 2.0 / (n - 1);
              }
              return GetCurvature(function, GetPrincipalCurvatures(field.Derivatives(p)));
            });
          std::cout << field.Name << " " << filter << " " << n << " " << CurvatureNames[function]
                    << " pixels " << pixels.size() << " ref " << shader.Mean << " "
                    << shader.Largest << " closed " << closed.Mean << " " << closed.Largest << "\n";
        }
      }
    }
  }
}
