/// What the distortion of one sample is: for CPUs and for CUDA.
#pragma once

#include <cstdint>
#include <cstring>

#ifdef __CUDACC__
#define FLATBLOCK_HOST_DEVICE __host__ __device__
#else
#define FLATBLOCK_HOST_DEVICE
#endif

namespace flatblock
{
/// One entry of the classified table: L*, u*, v* of the colour, and opacity in L*'s range.
struct alignas(16) ClassifiedColor
{
  float Components[4];

  FLATBLOCK_HOST_DEVICE float operator[](int i) const { return this->Components[i]; }
  FLATBLOCK_HOST_DEVICE float& operator[](int i) { return this->Components[i]; }
};

#if defined(__GNUC__) && !defined(__CUDACC__)
/// All four at once: compilers do not find that by themselves.
using FourFloats = float __attribute__((vector_size(16)));

inline FourFloats Load(const ClassifiedColor& color)
{
  FourFloats floats;
  std::memcpy(&floats, &color, sizeof(floats));
  return floats;
}
inline ClassifiedColor Store(FourFloats floats)
{
  ClassifiedColor color;
  std::memcpy(&color, &floats, sizeof(color));
  return color;
}
inline ClassifiedColor operator+(const ClassifiedColor& a, const ClassifiedColor& b)
{
  return Store(Load(a) + Load(b));
}
inline ClassifiedColor operator-(const ClassifiedColor& a, const ClassifiedColor& b)
{
  return Store(Load(a) - Load(b));
}
inline ClassifiedColor operator*(const ClassifiedColor& a, const ClassifiedColor& b)
{
  return Store(Load(a) * Load(b));
}
inline ClassifiedColor operator*(float a, const ClassifiedColor& b)
{
  return Store(a * Load(b));
}
#else
FLATBLOCK_HOST_DEVICE inline ClassifiedColor operator+(
  const ClassifiedColor& a, const ClassifiedColor& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3] } };
}
FLATBLOCK_HOST_DEVICE inline ClassifiedColor operator-(
  const ClassifiedColor& a, const ClassifiedColor& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3] } };
}
FLATBLOCK_HOST_DEVICE inline ClassifiedColor operator*(
  const ClassifiedColor& a, const ClassifiedColor& b)
{
  return { { a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3] } };
}
FLATBLOCK_HOST_DEVICE inline ClassifiedColor operator*(float a, const ClassifiedColor& b)
{
  return { { a * b[0], a * b[1], a * b[2], a * b[3] } };
}
#endif

/// A position between two entries of the table. Counted from the nearest one, so that colours that
/// are nearly equal are subtracted without cancellation.
struct TablePosition
{
  std::int32_t Nearest;
  std::int32_t Next; ///< the entry on the other side of the position
  float Share;       ///< of Next, in [0, 1/2]
};

/// The position numerator / 2^shift, exactly. The table has an entry after the last position.
FLATBLOCK_HOST_DEVICE inline TablePosition ToTablePosition(std::int32_t numerator, int shift)
{
  const std::int32_t half = shift > 0 ? std::int32_t(1) << (shift - 1) : 0;
  const std::int32_t nearest = (numerator + half) >> shift;
  const std::int32_t apart = numerator - (nearest << shift);
  const std::int32_t away = apart < 0 ? -apart : apart;
  const float unit = 1.0F / static_cast<float>(std::int32_t(1) << shift);
  return { nearest, nearest + (apart < 0 ? -1 : 1), static_cast<float>(away) * unit };
}

/// A real position, at least 0.
FLATBLOCK_HOST_DEVICE inline TablePosition ToTablePosition(double position)
{
  const auto below = static_cast<std::int32_t>(position);
  const std::int32_t nearest = below + (position - below >= 0.5 ? 1 : 0);
  const double apart = position - nearest;
  return { nearest, nearest + (apart < 0.0 ? -1 : 1),
    static_cast<float>(apart < 0.0 ? -apart : apart) };
}

/// The square of the difference of an entry and an interpolated colour, component by component.
FLATBLOCK_HOST_DEVICE inline ClassifiedColor GetSquaredDifference(const ClassifiedColor& color,
  const ClassifiedColor& nearest, const ClassifiedColor& next, float share)
{
  const ClassifiedColor apart = (color - nearest) - share * (next - nearest);
  return apart * apart;
}

/// The same of two real positions, each at least 0. Where they lie between the same two entries
/// only the way between them counts, which is subtracted before it is rounded.
FLATBLOCK_HOST_DEVICE inline ClassifiedColor GetSquaredDifference(
  const ClassifiedColor* table, double fine, double coarse)
{
  const auto entry = static_cast<std::int32_t>(fine);
  if (entry == static_cast<std::int32_t>(coarse))
  {
    const ClassifiedColor apart =
      static_cast<float>(fine - coarse) * (table[entry + 1] - table[entry]);
    return apart * apart;
  }
  const TablePosition f = ToTablePosition(fine);
  const TablePosition c = ToTablePosition(coarse);
  const ClassifiedColor& a = table[f.Nearest];
  const ClassifiedColor& b = table[c.Nearest];
  const ClassifiedColor apart =
    (a - b) + (f.Share * (table[f.Next] - a) - c.Share * (table[c.Next] - b));
  return apart * apart;
}
} // namespace flatblock
