/// Measures of two pictures of one size: premultiplied red, green, blue over black in [0, 1], and a
/// fourth value that only LargestDifference reads.
#pragma once

#include <array>
#include <vector>

namespace flatblock::testing
{
using Picture = std::vector<std::array<double, 4>>;

/// Of all channels of all pixels, in [0, 1].
double RootMeanSquare(const Picture& a, const Picture& b);

/// In dB, with a peak of 1; 200 for equal pictures.
double PeakSignalToNoise(const Picture& a, const Picture& b);

/// Mean of the structural similarity (Wang et al., Image Quality Assessment: From Error Visibility
/// to Structural Similarity, 2004) of Rec. 709 luma, in [-1, 1], 1 for equal pictures: Gaussian
/// windows of 11 x 11 pixels, sigma 1.5, that lie in the picture as a whole; K1 = 0.01, K2 = 0.03.
/// Throws std::invalid_argument for pictures that hold no window.
double StructuralSimilarity(const Picture& a, const Picture& b, int width);

/// CIE 1976 L*, u*, v* of a colour of sRGB (IEC 61966-2-1), with the white D65.
std::array<double, 3> ToLuv(const std::array<double, 4>& color);

/// Largest distance of two pixels in L*, u*, v*; black and white are 100 apart.
double LargestColorDifference(const Picture& a, const Picture& b);

/// Largest absolute difference of a channel, opacity among them.
double LargestDifference(const Picture& a, const Picture& b);
} // namespace flatblock::testing
