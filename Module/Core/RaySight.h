/// Where the rays of a picture run.
#pragma once

#include <array>

namespace flatblock
{
/// Rays of pixels, of which (x, y) are the normalized device coordinates in [-1, 1], in sample
/// coordinates. Each matrix has three columns, one behind the other: what belongs to x, to y, and
/// to the middle of the screen.
struct RaySight
{
  std::array<double, 9> Origin;    ///< a point of the ray: the eye, or near the middle of the box
  std::array<double, 9> Direction; ///< away from the eye, of no particular length
  std::array<double, 4> Eye;       ///< and 1 in perspective; 0, 0, 0, 0 in parallel projection
};

/// In double precision, so that nothing is lost where the camera is far away or looks at a small
/// part: the results can be used in single precision.
///
/// @param sampleToClip  row by row, from sample coordinates to clip coordinates; any projection
/// @param clipToSample  its inverse
/// @param samples       of the box [0, samples - 1]
RaySight ComputeRaySight(const double* sampleToClip, const double* clipToSample,
  const std::array<int, 3>& samples, bool parallel);

/// Whether a graphics card would draw the box inexactly: where it reaches close to the eye, or past
/// it, so that its corners are not exact in single precision; or where it is hardly larger than the
/// 1/256 of a pixel to which edges are told.
bool IsBoxInexactOnScreen(const double* sampleToClip, const std::array<int, 3>& samples);
} // namespace flatblock
