#include "RaySight.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

using flatblock::ComputeRaySight;
using flatblock::IsBoxInexactOnScreen;

namespace
{
using Matrix = std::array<double, 16>;
constexpr std::array<int, 3> Samples = { 33, 17, 9 };

// A camera at (x, y, z) in samples that looks along -z, with a pole of perspective or without one,
// and its inverse.
struct Camera
{
  Camera(const std::array<double, 3>& eye, double zoom, bool parallel)
  {
    const double n = 1.0;
    const double f = 3.0;
    const double a = parallel ? -2.0 / (f - n) : -(f + n) / (f - n);
    const double b = parallel ? -(f + n) / (f - n) : -2.0 * f * n / (f - n);
    const double c = parallel ? 0.0 : -1.0;
    const double d = parallel ? 1.0 : 0.0;
    this->ToClip = { zoom, 0, 0, -zoom * eye[0], 0, zoom, 0, -zoom * eye[1], 0, 0, a,
      b - a * eye[2], 0, 0, c, d - c * eye[2] };
    // Of [a b; c d], the part for z and w.
    const double det = a * d - b * c;
    this->ToSample = { 1 / zoom, 0, -eye[0] * c / -det, eye[0] * a / det, 0, 1 / zoom,
      -eye[1] * c / -det, eye[1] * a / det, 0, 0, d / det, -b / det, 0, 0, -c / det, a / det };
    for (int i : { 2, 3 })
    {
      const double w = this->ToSample[12 + i];
      this->ToSample[i] = eye[0] * w;
      this->ToSample[4 + i] = eye[1] * w;
      this->ToSample[8 + i] += eye[2] * w;
    }
  }
  Matrix ToClip;
  Matrix ToSample;
};

std::array<double, 3> Combine(const std::array<double, 9>& columns, double x, double y)
{
  return { x * columns[0] + y * columns[3] + columns[6],
    x * columns[1] + y * columns[4] + columns[7], x * columns[2] + y * columns[5] + columns[8] };
}
} // namespace

// Every point of a ray is seen at its pixel, those farther along it farther away.
TEST(RaySight, RaysAreSeenAtTheirPixels)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> onScreen(-1.0, 1.0);
  for (bool parallel : { false, true })
  {
    for (double away : { 5.0, 40.0, 1e4, 1e8 })
    {
      const Camera camera({ 12.0, 7.0, 4.0 + away }, parallel ? 0.1 : 0.1 * away, parallel);
      const auto sight =
        ComputeRaySight(camera.ToClip.data(), camera.ToSample.data(), Samples, parallel);
      EXPECT_EQ(sight.Eye[3], parallel ? 0.0 : 1.0);
      for (int i = 0; i < 100; ++i)
      {
        const double x = onScreen(random);
        const double y = onScreen(random);
        const auto origin = Combine(sight.Origin, x, y);
        const auto direction = Combine(sight.Direction, x, y);
        EXPECT_LT(direction[2], 0.0);
        for (double t : { 0.5, 3.0 })
        {
          std::array<double, 4> clip;
          for (int row = 0; row < 4; ++row)
          {
            clip[row] = camera.ToClip[4 * row + 3];
            for (int k = 0; k < 3; ++k)
            {
              clip[row] += camera.ToClip[4 * row + k] * (origin[k] + t * direction[k]);
            }
          }
          EXPECT_GT(clip[3], 0.0);
          EXPECT_NEAR(clip[0] / clip[3], x, 1e-6) << away;
          EXPECT_NEAR(clip[1] / clip[3], y, 1e-6) << away;
        }
      }
    }
  }
}

// So that distances along the ray are small beside the box wherever the camera is.
TEST(RaySight, RaysBeginNearTheBox)
{
  const Camera far({ 12.0, 7.0, 1e8 }, 1e7, false);
  const auto sight = ComputeRaySight(far.ToClip.data(), far.ToSample.data(), Samples, false);
  EXPECT_NEAR(sight.Origin[8], 4.0, 1.0);
  const Camera near({ 12.0, 7.0, 5.0 }, 1.0, false);
  const auto inside = ComputeRaySight(near.ToClip.data(), near.ToSample.data(), Samples, false);
  EXPECT_NEAR(inside.Origin[8], 5.0, 1e-9) << "the eye itself";
}

TEST(RaySight, KnowsBoxesThatAreInexactOnScreen)
{
  const auto isInexact = [](double z, double zoom, bool parallel) {
    return IsBoxInexactOnScreen(Camera({ 12.0, 7.0, z }, zoom, parallel).ToClip.data(), Samples);
  };
  EXPECT_FALSE(isInexact(50.0, 1.0, false));
  EXPECT_TRUE(isInexact(5.0, 1.0, false)) << "the eye is inside";
  EXPECT_TRUE(isInexact(8.005, 1.0, false)) << "a face is close to the eye";
  EXPECT_FALSE(isInexact(50.0, 0.1, true));
  EXPECT_TRUE(isInexact(50.0, 1e-4, true)) << "hardly a pixel";
}
