/// What depends on the magnitude of the gradient.
#pragma once

#include <cstddef>
#include <vector>

namespace flatblock
{
/// Gradients are measured as VTK does: times the mean of the spacings, over a quarter of the range
/// of values; what is beyond 1 counts as 1. Rows are magnitudes from 0 to 1.
struct GradientTable
{
  int Width = 0;             ///< 1, or values from the lowest to the highest
  int Height = 0;            ///< 0: nothing depends on gradients
  std::vector<float> Texels; ///< x fastest: a share of opacity; or red, green, blue, extinction

  bool IsEmpty() const { return this->Height == 0; }
  bool HasColors() const
  {
    return this->Texels.size() > static_cast<std::size_t>(this->Width) * this->Height;
  }
};
} // namespace flatblock
