/// Makes bricks of different levels meet without a crack.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace flatblock
{
/// How many levels coarser than the brick its border has to be, for each direction (x, y, z), each
/// -1, 0 or 1, at x + 1 + 3 * (y + 1) + 9 * (z + 1): faces have one direction that is not 0, edges
/// two. An edge takes the coarsest of the blocks that share it, so it is at least as coarse as its
/// faces.
using BorderCoarsening = std::array<std::int8_t, 27>;

inline int GetCoarsening(const BorderCoarsening& border, const std::array<int, 3>& direction)
{
  return border[direction[0] + 1 + 3 * (direction[1] + 1) + 9 * (direction[2] + 1)];
}

/// Overwrites faces and edges with the interpolant that the coarser level has there: since levels
/// nest, it goes through samples that the brick has.
template <typename Texel>
class BrickBorder
{
public:
  /// @param brick  (side + 2 * apron)^3 texels, x fastest, side = 2^n + 1
  BrickBorder(Texel* brick, int side, int apron = 0)
    : Last(side - 1), Strides{ 1, side + 2 * apron, 0 }
  {
    this->Strides[2] = this->Strides[1] * this->Strides[1];
    this->Brick = brick + apron * (this->Strides[0] + this->Strides[1] + this->Strides[2]);
  }

  /// The sample (i, j, k), in whose coordinates 0 is the block's first.
  Texel& At(int i, int j, int k) const
  {
    return this->Brick[i + j * this->Strides[1] + k * this->Strides[2]];
  }

  /// Takes the samples that a coarser level has from it, on those faces, edges and corners that are
  /// to be coarser by so many levels. Coarsen() then interpolates between them.
  ///
  /// @param coarse  the same block at that level, without an apron
  void CopyCoarser(const BorderCoarsening& border, int coarser, const Texel* coarse)
  {
    const int step = 1 << coarser;
    const int last = this->Last / step;
    const auto directionOf = [last](int i) { return i == 0 ? -1 : (i == last ? 1 : 0); };
    for (int k = 0; k <= last; ++k)
    {
      for (int j = 0; j <= last; ++j)
      {
        for (int i = 0; i <= last; ++i, ++coarse)
        {
          const std::array<int, 3> direction = { directionOf(i), directionOf(j), directionOf(k) };
          if (GetCoarsening(border, direction) == coarser)
          {
            this->At(i * step, j * step, k * step) = *coarse;
          }
        }
      }
    }
  }

  /// Edges first: they are what faces are interpolated from.
  void Coarsen(const BorderCoarsening& border)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      for (int corner = 0; corner < 4; ++corner)
      {
        std::array<int, 3> direction = { 0, 0, 0 };
        direction[u] = corner % 2 == 0 ? -1 : 1;
        direction[v] = corner / 2 == 0 ? -1 : 1;
        this->CoarsenEdge(this->GetFirst(direction), axis, 1 << GetCoarsening(border, direction));
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side : { -1, 1 })
      {
        std::array<int, 3> direction = { 0, 0, 0 };
        direction[axis] = side;
        this->CoarsenFace(this->GetFirst(direction), axis, 1 << GetCoarsening(border, direction));
      }
    }
  }

private:
  // The first texel of the face or edge in this direction.
  Texel* GetFirst(const std::array<int, 3>& direction) const
  {
    Texel* texel = this->Brick;
    for (int axis = 0; axis < 3; ++axis)
    {
      texel += direction[axis] > 0 ? this->Last * this->Strides[axis] : 0;
    }
    return texel;
  }

  static Texel ToTexel(double value)
  {
    if constexpr (std::is_integral_v<Texel>)
    {
      return static_cast<Texel>(std::lround(value));
    }
    else
    {
      return static_cast<Texel>(value);
    }
  }

  void CoarsenEdge(Texel* first, int axis, int step)
  {
    const std::ptrdiff_t stride = this->Strides[axis];
    for (int i = 0; step > 1 && i < this->Last; ++i)
    {
      const int left = i / step * step;
      const double share = static_cast<double>(i - left) / step;
      if (i != left)
      {
        const double a = first[left * stride];
        const double b = first[(left + step) * stride];
        first[i * stride] = ToTexel(a + share * (b - a));
      }
    }
  }

  void CoarsenFace(Texel* first, int axis, int step)
  {
    const std::ptrdiff_t u = this->Strides[(axis + 1) % 3];
    const std::ptrdiff_t v = this->Strides[(axis + 2) % 3];
    for (int j = 1; step > 1 && j < this->Last; ++j)
    {
      for (int i = 1; i < this->Last; ++i)
      {
        const int left = i / step * step;
        const int low = j / step * step;
        if (i == left && j == low)
        {
          continue;
        }
        // The cell's far samples; where the point lies on its near side they have no share.
        const int right = i == left ? left : left + step;
        const int high = j == low ? low : low + step;
        const double x = static_cast<double>(i - left) / step;
        const double y = static_cast<double>(j - low) / step;
        const double bottom =
          first[left * u + low * v] * (1.0 - x) + first[right * u + low * v] * x;
        const double top = first[left * u + high * v] * (1.0 - x) + first[right * u + high * v] * x;
        first[i * u + j * v] = ToTexel(bottom + y * (top - bottom));
      }
    }
  }

  Texel* Brick = nullptr;
  int Last;
  std::array<std::ptrdiff_t, 3> Strides;
};
} // namespace flatblock
