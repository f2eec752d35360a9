/// Vectors and matrices of the references.
#pragma once

#include <array>
#include <cmath>

namespace flatblock::testing
{
using Vector = std::array<double, 3>;
using Matrix = std::array<double, 9>; ///< row after row

inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline Vector Normalize(const Vector& v)
{
  const double length = std::sqrt(Dot(v, v));
  return { v[0] / length, v[1] / length, v[2] / length };
}

inline Vector Multiply(const Matrix& m, const Vector& v)
{
  return { m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
    m[6] * v[0] + m[7] * v[1] + m[8] * v[2] };
}

/// Columns are the cross products of the rows, over their volume.
inline Matrix Invert(const Matrix& m)
{
  const Vector a = { m[0], m[1], m[2] };
  const Vector b = { m[3], m[4], m[5] };
  const Vector c = { m[6], m[7], m[8] };
  const Vector columns[3] = { Cross(b, c), Cross(c, a), Cross(a, b) };
  const double volume = Dot(a, columns[0]);
  Matrix inverse;
  for (int i = 0; i < 9; ++i)
  {
    inverse[i] = columns[i % 3][i / 3] / volume;
  }
  return inverse;
}
} // namespace flatblock::testing
