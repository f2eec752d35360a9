/// Smallest and largest sample of every flat block of a volume.
#pragma once

#include <array>
#include <limits>

namespace flatblock
{
/// Interval of the finite sample values; empty (Lowest > Highest) where there is none.
struct ValueRange
{
  double Lowest = std::numeric_limits<double>::infinity();
  double Highest = -std::numeric_limits<double>::infinity();
  bool HasHoles = false; ///< a sample is NaN or infinite

  bool IsEmpty() const { return this->Lowest > this->Highest; }
};

/// Writes blocks[0] * blocks[1] * blocks[2] ranges, x fastest. Block (i,j,k) covers the samples
/// i*cells .. (i+1)*cells along x (likewise y, z), cut at the volume's far faces: neighbours share
/// their border samples. OpenMP over rows of blocks; the
/// result does not depend on the number of threads.
///
/// @param samples  dims[0] * dims[1] * dims[2] values, x fastest
/// @param dims     samples an axis, each >= 1
/// @param cells    cells a block's side, >= 1
/// @param blocks   blocks an axis
/// Instantiated for every C++ arithmetic type that a VTK array can hold.
template <typename T>
void ComputeBlockRanges(const T* samples, const std::array<int, 3>& dims, int cells,
  const std::array<int, 3>& blocks, ValueRange* ranges);
} // namespace flatblock
