/// Smallest and largest sample of small cubes of cells.
#pragma once

#include <array>
#include <cstdint>

namespace flatblock
{
/// Interval of sample values, rounded outwards to steps of a scale that starts at 0; empty
/// (Lowest > Highest) where there is no finite sample.
struct CellRange
{
  std::uint16_t Lowest = 65535;
  std::uint16_t Highest = 0;

  bool IsEmpty() const { return this->Lowest > this->Highest; }
};

/// A value is lowest + step * (a number from 0 to 65535).
struct CellScale
{
  double Lowest = 0.0;
  double Step = 1.0; ///< above 0

  double GetValue(std::uint16_t number) const { return this->Lowest + this->Step * number; }
};

/// Writes count[0] * count[1] * count[2] ranges, x fastest. Cube (i,j,k) covers the samples
/// i*cells .. (i+1)*cells along x (likewise y, z), cut at the volume's far faces: neighbours share
/// their border samples. A cube of which a sample is NaN or infinite has all of the scale, but for
/// one without a finite sample, which is empty. OpenMP over rows of cubes; the result does not
/// depend on the number of threads.
///
/// @param samples  dims[0] * dims[1] * dims[2] values, x fastest, the finite ones on the scale
/// @param cells    cells a cube's side, >= 1
/// @param around   samples around a cube that count as well, where there are any
/// @param count    cubes an axis
/// Instantiated for every C++ arithmetic type that a VTK array can hold.
template <typename T>
void ComputeCellRanges(const T* samples, const std::array<int, 3>& dims, int cells, int around,
  const std::array<int, 3>& count, const CellScale& scale, CellRange* ranges);
} // namespace flatblock
