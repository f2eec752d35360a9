#include "ReferenceCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

using namespace flatblock::testing;

namespace
{
double GetX(int x, int /*y*/, int /*z*/)
{
  return x;
}

Color Interpolate(const ReferenceTable& table, double value)
{
  const double share = (value - table.Lowest) / (table.Highest - table.Lowest);
  const double last = static_cast<double>(table.Entries.size() - 1);
  const double position = std::clamp(share, 0.0, 1.0) * last;
  const auto left = static_cast<std::size_t>(std::min(std::floor(position), last - 1.0));
  Color color;
  for (int c = 0; c < 4; ++c)
  {
    color[c] = table.Entries[left][c] + (position - static_cast<double>(left)) *
                                          (table.Entries[left + 1][c] - table.Entries[left][c]);
  }
  return color;
}

// By very many steps of one length, each of one colour; a ramp where `field` is left out.
Color Step(
  const ReferenceTable& table, double length, int steps, const std::function<double(double)>& field)
{
  Color sum = {};
  double depth = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const Color color = Interpolate(table, field((i + 0.5) / steps));
    const double seen = std::exp(-depth) * -std::expm1(-color[3] * length / steps);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += seen * color[c];
    }
    depth += color[3] * length / steps;
  }
  sum[3] = -std::expm1(-depth);
  return sum;
}

// A ramp from the table's lowest to its highest value: between two entries colour and extinction
// are linear, and what a step adds is its depth, exactly, times the colour in its middle.
Color IntegrateRamp(const ReferenceTable& table, double length, int stepsPerEntry)
{
  const int cells = static_cast<int>(table.Entries.size()) - 1;
  return Step(table, length, cells * stepsPerEntry,
    [&](double share) { return table.Lowest + share * (table.Highest - table.Lowest); });
}

} // namespace

TEST(ReferenceRayCaster, HomogeneousMedium)
{
  Errors errors("homogeneous");
  const Vector from = { 0.0, 4.0, 1.25 };
  const Vector to = { 6.0, 0.5, 3.0 };
  for (double extinction : { 1e-7, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6 })
  {
    const Color entry = { 0.2, 0.7, 1.0, extinction };
    for (auto filter : { ReferenceFilter::Trilinear, ReferenceFilter::CubicBSpline })
    {
      const ReferenceRayCaster caster(MakeVolume({ 7, 5, 4 }, [](int, int, int) { return 3.0; }),
        { 0.0, 1.0, { entry } }, filter);
      for (const auto& matrix : { Unit, Skewed })
      {
        const Color expected = Shine(entry, GetLength(matrix, from, to));
        const Color actual = caster.Integrate(from, to, matrix);
        errors.Add(actual, expected);
        EXPECT_NEAR(actual[3] / expected[3], 1.0, 1e-10); // it ends where 1e-10 is left
        // The same line with its ends outside.
        errors.Add(caster.Integrate({ -6.0, 7.5, -0.5 }, { 12.0, -3.0, 4.75 }, matrix), expected);
      }
    }
  }
}

// tau = e0 + (e1 - e0) s / L: the depth is the mean of the ends times L.
TEST(ReferenceRayCaster, LinearRamp)
{
  Errors errors("ramp");
  const Vector from = { 0.0, 3.0, 0.25 };
  const Vector to = { 4.0, 0.5, 2.0 };
  const double length = GetLength(Skewed, from, to);
  for (double scale : { 1e-5, 0.01, 0.3, 3.0, 30.0, 300.0 })
  {
    for (bool isFirstClear : { false, true })
    {
      const ReferenceTable table = { 0.0, 4.0,
        { { 1.0, 0.1, 0.5, isFirstClear ? 0.0 : 2.0 * scale }, { 0.0, 0.8, 0.5, scale } } };
      const ReferenceRayCaster caster(
        MakeVolume({ 5, 4, 3 }, GetX), table, ReferenceFilter::Trilinear);
      const Color actual = caster.Integrate(from, to, Skewed);
      errors.Add(actual, IntegrateRamp(table, length, 4000000));
      const double mean = isFirstClear ? 0.5 * scale : 1.5 * scale;
      EXPECT_NEAR(actual[3], -std::expm1(-mean * length), 1e-10);
      EXPECT_NEAR(actual[2], 0.5 * actual[3], 1e-12); // one colour
    }
  }
}

// Colour 1 - v / 4 over tau = a v: with k = a L / 8 the integral has erf in it.
TEST(ReferenceRayCaster, LinearRampByErf)
{
  Errors errors("ramp by erf");
  for (double slope : { 0.1, 2.0, 50.0, 1e4 })
  {
    const ReferenceTable table = { 0.0, 4.0,
      { { 1.0, 0.0, 1.0, 0.0 }, { 0.0, 1.0, 1.0, 4.0 * slope } } };
    const ReferenceRayCaster caster(
      MakeVolume({ 5, 2, 2 }, GetX), table, ReferenceFilter::Trilinear);
    // int_0^4 (s / 4) a s exp(-a s^2 / 2) ds, by parts.
    const double end = std::exp(-8.0 * slope);
    const double gauss =
      std::sqrt(std::acos(-1.0) / (2.0 * slope)) * std::erf(std::sqrt(8.0 * slope));
    const double green = 0.25 * (gauss - 4.0 * end);
    const double opacity = -std::expm1(-8.0 * slope);
    errors.Add(caster.Integrate({ 0.0, 0.5, 0.5 }, { 4.0, 0.5, 0.5 }, Unit),
      { opacity - green, green, opacity, opacity });
  }
}

// Two media with a step of one entry between them.
TEST(ReferenceRayCaster, SlabOfTwoMedia)
{
  Errors errors("two media");
  for (double second : { 0.0, 0.7, 20.0, 1e5 })
  {
    const Color front = { 1.0, 0.2, 0.0, 0.15 };
    const Color back = { 1.0, 0.9, 0.4, second };
    ReferenceTable table = { 0.0, 8.0, std::vector<Color>(1025, back) };
    std::fill(table.Entries.begin(), table.Entries.begin() + 400, front);
    const ReferenceRayCaster caster(
      MakeVolume({ 9, 2, 2 }, GetX), table, ReferenceFilter::Trilinear);
    const Color actual = caster.Integrate({ 0.0, 0.0, 0.0 }, { 8.0, 1.0, 1.0 }, Unit);
    const double entry = std::sqrt(66.0) / 1024.0;
    const double depth = entry * (front[3] * 399.5 + back[3] * 624.5);
    EXPECT_NEAR(actual[3], -std::expm1(-depth), 1e-7);
    EXPECT_NEAR(actual[0], actual[3], 1e-7);
    // Before, between by small steps, and behind.
    const Color between = IntegrateRamp({ 0.0, 1.0, { front, back } }, entry, 2000000);
    const Color parts[3] = { Shine(front, 399.0 * entry), between, Shine(back, 624.0 * entry) };
    Color expected = {};
    for (const Color& part : parts)
    {
      const double seen = 1.0 - expected[3];
      for (int c = 0; c < 4; ++c)
      {
        expected[c] += seen * part[c];
      }
    }
    errors.Add(actual, expected);
  }
}

// One entry of 1025 is not clear: a triangle of depth extinction times width, wherever it lies.
TEST(ReferenceRayCaster, ThinShell)
{
  Errors errors("thin shell");
  for (std::size_t size : { 1025U, 65537U })
  {
    for (double extinction : { 1.0, 1e3, 1e6 })
    {
      for (std::size_t spike = 1; spike < size - 1; spike += size / 7)
      {
        ReferenceTable table = { 0.0, 3.0, std::vector<Color>(size, { 0.3, 0.6, 0.9, 0.0 }) };
        table.Entries[spike][3] = extinction;
        const ReferenceRayCaster caster(
          MakeVolume({ 4, 3, 3 }, GetX), table, ReferenceFilter::Trilinear);
        const Vector from = { 0.0, 2.0, 0.0 };
        const Vector to = { 3.0, 0.0, 1.5 };
        const double width = GetLength(Skewed, from, to) / static_cast<double>(size - 1);
        errors.Add(caster.Integrate(from, to, Skewed), Shine({ 0.3, 0.6, 0.9, extinction }, width));
      }
    }
  }
}

TEST(ReferenceRayCaster, TableOfNoise)
{
  Errors errors("table of noise");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  for (double scale : { 0.1, 1.0, 10.0 })
  {
    ReferenceTable table = { 0.0, 4.0, {} };
    for (int i = 0; i < 1025; ++i)
    {
      table.Entries.push_back(
        { anywhere(random), anywhere(random), anywhere(random), scale * anywhere(random) });
    }
    const ReferenceRayCaster caster(
      MakeVolume({ 5, 2, 2 }, GetX), table, ReferenceFilter::Trilinear);
    errors.Add(caster.Integrate({ 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, Unit),
      IntegrateRamp(table, 4.0, 1000));
  }
}

TEST(ReferenceRayCaster, OpaqueMatter)
{
  Errors errors("opaque");
  const ReferenceTable table = { 0.0, 8.0, { { 1.0, 0.0, 0.5, 1e4 }, { 0.0, 1.0, 0.5, 1e6 } } };
  const ReferenceRayCaster caster(MakeVolume({ 9, 2, 2 }, GetX), table, ReferenceFilter::Trilinear);
  // It is the front's colour: the mean depth that is seen is 1 / 1e4, where v is no more.
  const double green = IntegrateRamp(
    { 0.0, 0.01, { { 0.0, 0.0, 0.0, 1e4 }, { 0.0, 0.00125, 0.0, 11237.5 } } }, 0.01, 4000000)[1];
  errors.Add(
    caster.Integrate({ 0.0, 0.5, 0.5 }, { 8.0, 0.5, 0.5 }, Unit), { 1.0 - green, green, 0.5, 1.0 });
}

// Random samples against small steps, with the filters as they are defined.
TEST(ReferenceRayCaster, FieldOfNoise)
{
  Errors errors("field of noise");
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  const std::array<int, 3> n = { 5, 4, 6 };
  const ReferenceVolume volume = MakeVolume(n, [&](int, int, int) { return anywhere(random); });
  const ReferenceTable table = { 0.1, 0.9,
    { { 1.0, 0.0, 0.3, 0.0 }, { 0.0, 1.0, 0.2, 0.9 }, { 0.5, 0.0, 1.0, 0.1 } } };
  for (auto filter : { ReferenceFilter::Trilinear, ReferenceFilter::CubicBSpline })
  {
    const ReferenceRayCaster caster(volume, table, filter);
    const auto basis = [&](double d)
    {
      d = std::abs(d);
      const double b = d < 1.0 ? 2.0 / 3.0 - d * d + 0.5 * d * d * d : std::pow(2.0 - d, 3.0) / 6.0;
      return filter == ReferenceFilter::Trilinear ? std::max(0.0, 1.0 - d) : (d < 2.0 ? b : 0.0);
    };
    for (int ray = 0; ray < 4; ++ray)
    {
      const Vector from = { 4.0 * anywhere(random), 3.0 * anywhere(random), 0.0 };
      const Vector to = { 4.0 * anywhere(random), 3.0 * anywhere(random), 5.0 };
      const auto field = [&](double share)
      {
        double sum = 0.0;
        for (int i = 0; i < 64; ++i)
        {
          const int offsets[3] = { i % 4 - 1, i / 4 % 4 - 1, i / 16 - 1 };
          double weight = 1.0;
          int index[3];
          for (int a = 0; a < 3; ++a)
          {
            const double at = from[a] + share * (to[a] - from[a]);
            const int sample = static_cast<int>(at) + offsets[a];
            weight *= basis(at - sample);
            index[a] = std::clamp(sample, 0, n[a] - 1);
          }
          sum += weight * volume.Values[(index[2] * n[1] + index[1]) * n[0] + index[0]];
        }
        return sum;
      };
      errors.Add(
        caster.Integrate(from, to, Unit), Step(table, GetLength(Unit, from, to), 20000, field));
    }
  }
}

namespace
{
// Opacity along x of a field that varies with x alone, of extinction 0.1 v.
Color LookAlongX(const std::function<double(int)>& field, double from, double to)
{
  const ReferenceTable table = { 0.0, 100.0, { { 1.0, 1.0, 1.0, 0.0 }, { 1.0, 1.0, 1.0, 10.0 } } };
  const ReferenceRayCaster caster(
    MakeVolume({ 10, 3, 3 }, [&](int x, int, int) { return field(x); }), table,
    ReferenceFilter::CubicBSpline);
  return caster.Integrate({ from, 0.7, 1.2 }, { to, 0.7, 1.2 }, Unit);
}
} // namespace

TEST(ReferenceRayCaster, CubicBSplineOfPolynomials)
{
  Errors errors("B-spline");
  for (const auto& [from, to] : { std::array{ 1.0, 8.0 }, { 1.3, 7.2 }, { 4.1, 4.6 } })
  {
    const double squares = (to * to - from * from) / 2.0;
    const double cubes = (to * to * to - from * from * from) / 3.0;
    errors.Add(LookAlongX([](int x) { return x; }, from, to), Shine({ 1, 1, 1, 0.1 }, squares));
    errors.Add(LookAlongX([](int x) { return x * x; }, from, to),
      Shine({ 1, 1, 1, 0.1 }, cubes + (to - from) / 3.0));
  }
  // Clamped: over the first cell the samples 0, 0, 1, 2 give x + (1 - x)^3 / 6.
  errors.Add(
    LookAlongX([](int x) { return x; }, 0.0, 1.0), Shine({ 1, 1, 1, 0.1 }, 0.5 + 1.0 / 24.0));
}

TEST(ReferenceRayCaster, HolesLoseTheirCellsAndNoMore)
{
  Errors errors("holes");
  const Color entry = { 0.5, 0.25, 1.0, 0.2 };
  for (double value : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    const ReferenceVolume volume = MakeVolume({ 9, 9, 9 },
      [value](int x, int y, int z) { return x == 4 && y == 4 && z == 4 ? value : 1.0; });
    const ReferenceRayCaster linear(volume, { 0, 1, { entry } }, ReferenceFilter::Trilinear);
    const ReferenceRayCaster cubic(volume, { 0, 1, { entry } }, ReferenceFilter::CubicBSpline);
    // At y = z: of 8 cells the linear filter loses 2, the cubic one 4.
    for (const auto& [at, lost, lostByCubic] :
      { std::array{ 3.5, 2.0, 4.0 }, { 4.9, 2.0, 4.0 }, { 2.5, 0.0, 4.0 }, { 2.99, 0.0, 4.0 },
        { 5.01, 0.0, 4.0 }, { 1.99, 0.0, 0.0 }, { 6.01, 0.0, 0.0 } })
    {
      const Vector from = { 0.0, at, at };
      const Vector to = { 8.0, at, at };
      errors.Add(linear.Integrate(from, to, Unit), Shine(entry, 8.0 - lost));
      errors.Add(cubic.Integrate(from, to, Unit), Shine(entry, 8.0 - lostByCubic));
    }
    errors.Add(
      linear.Integrate({ 0, 0, 0 }, { 8, 8, 8 }, Unit), Shine(entry, 6.0 * std::sqrt(3.0)));
  }
}

TEST(ReferenceRayCaster, RefusesWhatIsIncomplete)
{
  const auto make = [](const ReferenceVolume& volume, const ReferenceTable& table)
  { ReferenceRayCaster(volume, table, ReferenceFilter::Trilinear); };
  const ReferenceVolume volume = MakeVolume({ 2, 2, 2 }, GetX);
  const ReferenceTable table = { 0.0, 1.0, { Color{}, Color{} } };
  EXPECT_NO_THROW(make(volume, table));
  EXPECT_THROW(make(volume, {}), std::invalid_argument);
  EXPECT_THROW(make(volume, { 1.0, 1.0, table.Entries }), std::invalid_argument);
  EXPECT_THROW(make({ { 1, 2, 4 }, volume.Values }, table), std::invalid_argument);
  EXPECT_THROW(make({ { 2, 2, 3 }, volume.Values }, table), std::invalid_argument);
}
