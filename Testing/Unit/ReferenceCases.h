/// Media with closed forms, and how far a result is from one.
#pragma once

#include "ReferenceRayCaster.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <iostream>

namespace flatblock::testing
{
using Vector = std::array<double, 3>;
using Color = std::array<double, 4>;

/// What ReferenceRayCaster promises.
constexpr double Bound = 1e-6;
constexpr std::array<double, 9> Unit = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
constexpr std::array<double, 9> Skewed = { 0.3, 0.1, 0.0, -0.2, 1.7, 0.4, 0.0, 0.5, 2.9 };

inline ReferenceVolume MakeVolume(
  const std::array<int, 3>& samples, const std::function<double(int, int, int)>& field)
{
  ReferenceVolume volume = { samples, {} };
  for (int z = 0; z < samples[2]; ++z)
  {
    for (int y = 0; y < samples[1]; ++y)
    {
      for (int x = 0; x < samples[0]; ++x)
      {
        volume.Values.push_back(field(x, y, z));
      }
    }
  }
  return volume;
}

inline Vector Transform(const std::array<double, 9>& m, const Vector& v)
{
  return { m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
    m[6] * v[0] + m[7] * v[1] + m[8] * v[2] };
}

inline double GetLength(const std::array<double, 9>& m, const Vector& from, const Vector& to)
{
  const Vector v = Transform(m, { to[0] - from[0], to[1] - from[1], to[2] - from[2] });
  return std::hypot(v[0], v[1], v[2]);
}

/// Of `length` of one medium.
inline Color Shine(const Color& entry, double length)
{
  const double opacity = -std::expm1(-entry[3] * length);
  return { entry[0] * opacity, entry[1] * opacity, entry[2] * opacity, opacity };
}
/// Prints and checks the largest error of what it is told.
class Errors
{
public:
  explicit Errors(const char* name) : Name(name) {}
  ~Errors()
  {
    std::cout << this->Name << ": largest error " << this->Largest << "\n";
    EXPECT_LE(this->Largest, Bound);
    EXPECT_GT(this->Count, 0);
  }
  void Add(const Color& actual, const Color& expected)
  {
    ++this->Count;
    for (int c = 0; c < 4; ++c)
    {
      const double error = std::abs(actual[c] - expected[c]);
      this->Largest = error <= this->Largest ? this->Largest : error; // NaN stays
    }
  }

private:
  const char* Name;
  double Largest = 0.0;
  int Count = 0;
};
} // namespace flatblock::testing
