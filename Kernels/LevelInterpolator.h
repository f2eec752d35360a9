/// The trilinear interpolant of a block's samples at a stride.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace flatblock
{
/// A level of one block: its samples, interpolated plane by plane and row by row. Values are scaled
/// by the stride for each axis along which they are interpolated, so that integers stay exact.
template <typename Number>
class LevelInterpolator
{
public:
  LevelInterpolator(int level, int cells)
    : Level(level), Stride(1 << level), Side((cells >> level) + 1),
      Lattice(std::size_t(Side) * Side * Side), Plane(std::size_t(Side) * Side), Row(Side)
  {
  }

  int GetStride() const { return this->Stride; }
  int GetSide() const { return this->Side; }
  Number* GetLattice() { return this->Lattice.data(); }
  int GetShift() const { return 3 * this->Level; }

  void SetPlane(int z)
  {
    const int plane = this->Side * this->Side;
    const int k = std::min(z >> this->Level, this->Side - 2);
    const Number* below = this->Lattice.data() + std::ptrdiff_t(k) * plane;
    const auto far = static_cast<Number>(z - (k << this->Level));
    Mix(below, below + plane, far, plane, this->Plane.data());
  }

  void SetRow(int y)
  {
    const int j = std::min(y >> this->Level, this->Side - 2);
    const Number* below = this->Plane.data() + std::ptrdiff_t(j) * this->Side;
    const auto far = static_cast<Number>(y - (j << this->Level));
    Mix(below, below + this->Side, far, this->Side, this->Row.data());
  }

  // Values at the samples of the row, scaled by the stride's cube.
  void GetRow(int samples, Number* values) const
  {
    for (int i = 0; i < this->Side - 1; ++i)
    {
      const Number step = this->Row[i + 1] - this->Row[i];
      const Number first = this->Row[i] * static_cast<Number>(this->Stride);
      const int begin = i * this->Stride;
      const int count = std::min(this->Stride, samples - begin);
      for (int k = 0; k < count; ++k)
      {
        values[begin + k] = first + static_cast<Number>(k) * step;
      }
    }
    const int last = (this->Side - 1) * this->Stride;
    if (last < samples)
    {
      values[last] = this->Row[this->Side - 1] * static_cast<Number>(this->Stride);
    }
  }

private:
  void Mix(const Number* a, const Number* b, Number far, int count, Number* out) const
  {
    const Number near = static_cast<Number>(this->Stride) - far;
    for (int i = 0; i < count; ++i)
    {
      out[i] = a[i] * near + b[i] * far;
    }
  }

  int Level;
  int Stride;
  int Side;
  std::vector<Number> Lattice;
  std::vector<Number> Plane;
  std::vector<Number> Row;
};
} // namespace flatblock
