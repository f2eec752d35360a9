/// A function of one or two numbers, from 0 to 1 each, that rays look up.
#pragma once

#include <cstddef>
#include <vector>

namespace flatblock
{
/// Of gradients, rows are their magnitudes, measured as VTK does: times the mean of the spacings,
/// over a quarter of the range of values; what is beyond 1 counts as 1. Of curvature there is one
/// row, with colours and a share of opacity.
struct FunctionTable
{
  int Width = 0;             ///< 1, or values from the lowest to the highest
  int Height = 0;            ///< 0: there is no function
  std::vector<float> Texels; ///< x fastest: a share of opacity; or red, green, blue, extinction

  bool IsEmpty() const { return this->Height == 0; }
  bool HasColors() const
  {
    return this->Texels.size() > static_cast<std::size_t>(this->Width) * this->Height;
  }
};
} // namespace flatblock
