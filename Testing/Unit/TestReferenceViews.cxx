#include "ReferenceCases.h"

#include <algorithm>
#include <limits>

using namespace flatblock::testing;

namespace
{
using Exact = std::array<long double, 3>;

// The extinction is linear in sample coordinates, so its mean along a line is that of the ends.
constexpr std::array<int, 3> Samples = { 9, 6, 7 };

double GetExtinction(long double x, long double y, long double z)
{
  return static_cast<double>(0.02L + 0.03L * x + 0.01L * y - 0.002L * z);
}

ReferenceRayCaster MakeCaster()
{
  return ReferenceRayCaster(MakeVolume(Samples, GetExtinction),
    { 0.0, 1.0, { { 0.9, 0.5, 0.1, 0.0 }, { 0.9, 0.5, 0.1, 1.0 } } }, ReferenceFilter::Trilinear);
}

// Skewed takes sample coordinates to the world's, and its inverse back.
Exact ToSamples(const Exact& v)
{
  Exact result = {};
  long double determinant = 0.0L;
  const auto minor = [](int i, int j)
  {
    const auto at = [&](int a, int b)
    { return static_cast<long double>(Skewed[3 * ((i + a) % 3) + (j + b) % 3]); };
    return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
  };
  for (int i = 0; i < 3; ++i)
  {
    determinant += Skewed[i] * minor(0, i);
    for (int j = 0; j < 3; ++j)
    {
      result[j] += minor(i, j) * v[i];
    }
  }
  return { result[0] / determinant, result[1] / determinant, result[2] / determinant };
}

// Degrees for a perspective; 0 for a parallel view of `HalfHeight`. All in the world.
struct Camera
{
  Vector Eye;
  double Degrees;
  double HalfHeight;
  double Near;
  double Far;
  std::array<Vector, 3> Axes = {}; // right, up, back
};

Vector Combine(const Vector& a, double factor, const Vector& b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Normalize(const Vector& v)
{
  return Combine({}, 1.0 / std::sqrt(Dot(v, v)), v);
}

// Looks along -back at a point of the world, from a distance.
Camera MakeCamera(const Vector& target, double distance, double degrees, double halfHeight)
{
  Camera camera = { {}, degrees, halfHeight, std::max(0.01, distance - 30.0), distance + 30.0 };
  const Vector back = Normalize({ 0.48, 0.6, 0.64 });
  const Vector up = Normalize(Combine({ 0.1, 1.0, 0.2 }, -Dot(back, { 0.1, 1.0, 0.2 }), back));
  const Vector right = { up[1] * back[2] - up[2] * back[1], up[2] * back[0] - up[0] * back[2],
    up[0] * back[1] - up[1] * back[0] };
  camera.Axes = { right, up, back };
  camera.Eye = Combine(target, distance, back);
  return camera;
}

// As OpenGL has it, in double precision.
ReferenceView MakeView(const Camera& camera, int width, int height)
{
  ReferenceView view = { {}, Skewed, width, height };
  const double aspect = static_cast<double>(width) / height;
  const double depth = camera.Far - camera.Near;
  const bool isParallel = camera.Degrees == 0.0;
  const double f =
    isParallel ? 1.0 / camera.HalfHeight : 1.0 / std::tan(camera.Degrees * std::acos(-1.0) / 360.0);
  const double z = isParallel ? -2.0 / depth : -(camera.Far + camera.Near) / depth;
  const double shift =
    isParallel ? -(camera.Far + camera.Near) / depth : -2.0 * camera.Far * camera.Near / depth;
  for (int column = 0; column < 4; ++column)
  {
    std::array<double, 3> eye;
    for (int row = 0; row < 3; ++row)
    {
      const Vector& axis = camera.Axes[row];
      eye[row] = column == 3
                   ? -Dot(axis, camera.Eye)
                   : Dot(axis, { Skewed[column], Skewed[3 + column], Skewed[6 + column] });
    }
    const double one = column == 3 ? 1.0 : 0.0;
    view.SampleToClip[column] = f / aspect * eye[0];
    view.SampleToClip[4 + column] = f * eye[1];
    view.SampleToClip[8 + column] = z * eye[2] + shift * one;
    view.SampleToClip[12 + column] = isParallel ? one : -eye[2];
  }
  return view;
}

// By the camera's axes, without its matrix.
Color Expect(const Camera& camera, int width, int height, int x, int y)
{
  const long double tangent = camera.Degrees == 0.0
                                ? camera.HalfHeight
                                : std::tan(camera.Degrees * std::acos(-1.0L) / 360.0L);
  const long double right = ((2 * x + 1.0L) / width - 1.0L) * tangent * width / height;
  const long double up = ((2 * y + 1.0L) / height - 1.0L) * tangent;
  Exact origin;
  Exact way;
  for (int i = 0; i < 3; ++i)
  {
    const long double across = right * camera.Axes[0][i] + up * camera.Axes[1][i];
    way[i] = -static_cast<long double>(camera.Axes[2][i]) + (camera.Degrees == 0.0 ? 0.0L : across);
    origin[i] = camera.Eye[i] + (camera.Degrees == 0.0 ? across : 0.0L);
  }
  const long double length = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
  origin = ToSamples(origin);
  way = ToSamples(way);
  long double first = camera.Near;
  long double last = std::numeric_limits<long double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const long double a = -origin[i] / way[i];
    const long double b = (Samples[i] - 1 - origin[i]) / way[i];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  const long double middle = 0.5L * (first + last);
  return first < last ? Shine({ 0.9, 0.5, 0.1,
                                GetExtinction(origin[0] + middle * way[0],
                                  origin[1] + middle * way[1], origin[2] + middle * way[2]) },
                          static_cast<double>((last - first) * length))
                      : Color{};
}

// Pixels that show something.
int Compare(const char* name, const Camera& camera)
{
  constexpr int Width = 48;
  constexpr int Height = 34;
  Errors errors(name);
  const auto picture = MakeCaster().Render(MakeView(camera, Width, Height));
  int shown = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    errors.Add(picture[i], Expect(camera, Width, Height, i % Width, i / Width));
    shown += picture[i][3] > 0.0 ? 1 : 0;
  }
  return shown;
}

const Vector Center = Transform(Skewed, { 4.0, 2.5, 3.0 });
} // namespace

TEST(ReferenceRayCaster, PerspectiveView)
{
  EXPECT_GT(Compare("perspective", MakeCamera(Center, 40.0, 30.0, 0.0)), 100);
  EXPECT_GT(
    Compare("perspective, beside", MakeCamera(Combine(Center, 4.0, { 1, 0, 0 }), 40.0, 20.0, 0.0)),
    100);
}

TEST(ReferenceRayCaster, ParallelView)
{
  EXPECT_GT(Compare("parallel", MakeCamera(Center, 40.0, 0.0, 9.0)), 100);
}

TEST(ReferenceRayCaster, WideAndNarrowViews)
{
  EXPECT_GT(Compare("170 degrees", MakeCamera(Center, 12.0, 170.0, 0.0)), 0);
  EXPECT_EQ(Compare("170 degrees, inside", MakeCamera(Center, 0.0, 170.0, 0.0)), 48 * 34);
  EXPECT_GT(Compare("0.01 degrees", MakeCamera(Center, 1e5, 0.01, 0.0)), 100);
  EXPECT_EQ(Compare("0.01 degrees, close", MakeCamera(Center, 40.0, 0.01, 0.0)), 48 * 34);
}

TEST(ReferenceRayCaster, FarViews)
{
  const double distance = 1e6 * GetLength(Skewed, {}, { 8.0, 5.0, 6.0 });
  const double degrees = 360.0 / std::acos(-1.0) * std::atan(10.0 / distance);
  EXPECT_GT(Compare("1e6 diagonals away", MakeCamera(Center, distance, degrees, 0.0)), 100);
  EXPECT_GT(Compare("1e6 diagonals away, parallel", MakeCamera(Center, distance, 0.0, 9.0)), 100);
}

TEST(ReferenceRayCaster, NearPlaneInTheBox)
{
  for (double nearest : { 0.01, 1.0, 4.0 })
  {
    Camera camera = MakeCamera(Center, 2.0, 60.0, 0.0);
    camera.Near = nearest;
    EXPECT_GT(Compare("perspective, inside", camera), 200);
    camera = MakeCamera(Center, 2.0, 0.0, 9.0);
    camera.Near = nearest;
    EXPECT_GT(Compare("parallel, inside", camera), 100);
  }
}

TEST(ReferenceRayCaster, DoesNotEndAtTheFarPlane)
{
  Camera camera = MakeCamera(Center, 40.0, 30.0, 0.0);
  camera.Far = 38.0;
  EXPECT_GT(Compare("far plane in the box", camera), 100);
  camera.Near = 0.01;
  camera.Far = 0.02;
  EXPECT_GT(Compare("far plane before the box", camera), 100);
}

TEST(ReferenceRayCaster, StridesPickPixels)
{
  const ReferenceRayCaster caster = MakeCaster();
  const ReferenceView view = MakeView(MakeCamera(Center, 40.0, 30.0, 0.0), 14, 11);
  const auto all = caster.Render(view);
  const auto some = caster.Render(view, 4);
  ASSERT_EQ(some.size(), 4U * 3U);
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    EXPECT_EQ(some[i], all[4 * (i / 4) * 14 + 4 * (i % 4)]);
  }
}
