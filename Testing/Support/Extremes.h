/// Scenes at the edge of what single precision holds, and a record of how they came out.
#pragma once

#include "FloatPicture.h"

#include <functional>
#include <string>

namespace flatblock::testing
{
/// A volume of floats whose values wave from 0 to 1, seen from an oblique angle in a window of
/// 64 x 64 pixels over black, with a translucent ramp of opacity and colour over [0, 1].
void ShowWaves(Scene& scene, const std::array<int, 3>& samples, double step = 0.5);

/// The field of that volume, of indices.
double WaveAt(double x, double y, double z);

struct Outcome
{
  double Error = 0.0;     ///< largest difference of a channel to the reference
  double Brightest = 0.0; ///< largest channel of the reference
  Messages Said;
};

/// Draws a scene and compares it with the reference. The picture must be sound, and there must be
/// no error.
Outcome CompareWithReference(Scene& scene, int stride = 4);

/// The same, with an upper bound of the difference; and puts down a row for the table of extremes.
/// @param group  the table's row, e.g. "step"
/// @param what   what was tried
/// @param came   what came out, beside the error; empty: the right picture
void ExpectRight(Scene& scene, const std::string& group, const std::string& what, double bound,
  const std::string& came = "");

/// A number in as few digits as it has.
std::string ToText(double number);

/// Puts down a row without drawing.
void Record(
  const std::string& group, const std::string& what, const std::string& came, double error);
} // namespace flatblock::testing
