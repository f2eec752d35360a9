#include "Metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace flatblock::testing;

namespace
{
Picture MakeNoise(std::size_t pixels, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  Picture picture(pixels);
  for (auto& pixel : picture)
  {
    pixel = { anywhere(random), anywhere(random), anywhere(random), anywhere(random) };
  }
  return picture;
}

Picture MakeConstant(std::size_t pixels, double red, double green, double blue, double opacity)
{
  return Picture(pixels, { red, green, blue, opacity });
}
} // namespace

TEST(Metrics, OfEqualPictures)
{
  const Picture picture = MakeNoise(20 * 15, 1);
  EXPECT_EQ(RootMeanSquare(picture, picture), 0.0);
  EXPECT_EQ(PeakSignalToNoise(picture, picture), 200.0);
  EXPECT_NEAR(StructuralSimilarity(picture, picture, 20), 1.0, 1e-14);
  EXPECT_EQ(LargestColorDifference(picture, picture), 0.0);
  EXPECT_EQ(LargestDifference(picture, picture), 0.0);
}

TEST(Metrics, OfAConstantOffset)
{
  const Picture a = MakeConstant(12 * 12, 0.3, 0.3, 0.3, 0.5);
  const Picture b = MakeConstant(12 * 12, 0.4, 0.4, 0.4, 0.9);
  EXPECT_NEAR(RootMeanSquare(a, b), 0.1, 1e-14);
  EXPECT_NEAR(PeakSignalToNoise(a, b), 20.0, 1e-12);
  EXPECT_NEAR(LargestDifference(a, b), 0.4, 1e-15);
  // Without structure the means are all: (2 * 0.12 + 1e-4) / (0.09 + 0.16 + 1e-4).
  EXPECT_NEAR(StructuralSimilarity(a, b, 12), 0.2401 / 0.2501, 1e-14);
}

TEST(Metrics, OfOneChannelOfOnePixel)
{
  const Picture a = MakeConstant(100, 0.0, 0.0, 0.0, 1.0);
  Picture b = a;
  b[37][1] = 0.6;
  EXPECT_NEAR(RootMeanSquare(a, b), std::sqrt(0.36 / 300.0), 1e-15);
  EXPECT_EQ(LargestDifference(a, b), 0.6);
}

TEST(Metrics, IgnoreOpacityWhereTheyCompareColors)
{
  const Picture a = MakeNoise(400, 2);
  Picture b = a;
  for (auto& pixel : b)
  {
    pixel[3] = 0.0;
  }
  EXPECT_EQ(PeakSignalToNoise(a, b), 200.0);
  EXPECT_NEAR(StructuralSimilarity(a, b, 20), 1.0, 1e-14);
  EXPECT_EQ(LargestColorDifference(a, b), 0.0);
}

// One window, with one pixel of it lit: its moments follow from that pixel's weight.
TEST(Metrics, StructuralSimilarityOfOneWindow)
{
  const Picture a = MakeConstant(121, 0.0, 0.0, 0.0, 0.0);
  Picture b = a;
  b[60] = { 1.0, 1.0, 1.0, 1.0 };
  double line = 0.0;
  for (int x = -5; x <= 5; ++x)
  {
    line += std::exp(-x * x / 4.5);
  }
  const double weight = 1.0 / (line * line); // the middle's
  const double variance = weight * (1.0 - weight);
  const double expected = 1e-4 * 9e-4 / ((weight * weight + 1e-4) * (variance + 9e-4));
  EXPECT_NEAR(StructuralSimilarity(a, b, 11), expected, 1e-14);
}

// A picture and its negative: the covariance is minus the variance.
TEST(Metrics, StructuralSimilarityOfANegative)
{
  const Picture a = MakeNoise(64 * 64, 3);
  Picture b = a;
  for (auto& pixel : b)
  {
    pixel = { 1.0 - pixel[0], 1.0 - pixel[1], 1.0 - pixel[2], 1.0 };
  }
  EXPECT_LT(StructuralSimilarity(a, b, 64), -0.8);
  EXPECT_LT(std::abs(StructuralSimilarity(a, MakeNoise(64 * 64, 4), 64)), 0.1);
}

TEST(Metrics, StructuralSimilarityCountsWholeWindows)
{
  // The pixel is in the second of two windows.
  const Picture a = MakeConstant(11 * 12, 0.0, 0.0, 0.0, 0.0);
  Picture b = a;
  b[11 * 11] = { 1.0, 1.0, 1.0, 1.0 };
  Picture window(b.begin() + 11, b.end());
  const double one = StructuralSimilarity(Picture(121, std::array<double, 4>{}), window, 11);
  EXPECT_NEAR(StructuralSimilarity(a, b, 11), 0.5 * (1.0 + one), 1e-14);
  EXPECT_THROW(StructuralSimilarity(a, b, 13), std::invalid_argument);
  EXPECT_THROW(StructuralSimilarity(a, b, 33), std::invalid_argument);
}

// Bruce Lindbloom's values of the primaries of sRGB.
TEST(Metrics, LuvOfPrimaries)
{
  const auto expectNear = [](const std::array<double, 3>& luv, double l, double u, double v)
  {
    EXPECT_NEAR(luv[0], l, 1e-3);
    EXPECT_NEAR(luv[1], u, 1e-3);
    EXPECT_NEAR(luv[2], v, 1e-3);
  };
  expectNear(ToLuv({ 1.0, 0.0, 0.0, 1.0 }), 53.2408, 175.0151, 37.7564);
  expectNear(ToLuv({ 0.0, 1.0, 0.0, 1.0 }), 87.7347, -83.0776, 107.3985);
  expectNear(ToLuv({ 0.0, 0.0, 1.0, 1.0 }), 32.2970, -9.4054, -130.3423);
  expectNear(ToLuv({ 1.0, 1.0, 1.0, 1.0 }), 100.0, 0.0, 0.0);
  expectNear(ToLuv({ 0.0, 0.0, 0.0, 1.0 }), 0.0, 0.0, 0.0);
}

TEST(Metrics, LargestColorDifferenceOfRedAndBlue)
{
  const Picture a = MakeConstant(9, 1.0, 0.0, 0.0, 1.0);
  Picture b = a;
  b[4] = { 0.0, 0.0, 1.0, 1.0 };
  EXPECT_NEAR(LargestColorDifference(a, b), std::hypot(20.9438, 184.4205, 168.0987), 2e-3);
  const Picture black = MakeConstant(9, 0.0, 0.0, 0.0, 1.0);
  EXPECT_NEAR(LargestColorDifference(black, MakeConstant(9, 1.0, 1.0, 1.0, 1.0)), 100.0, 1e-5);
  // Near black, L* is 903.3 Y.
  EXPECT_NEAR(LargestColorDifference(black, MakeConstant(9, 0.01, 0.01, 0.01, 1.0)),
    24389.0 / 27.0 * 0.01 / 12.92, 1e-6);
}
