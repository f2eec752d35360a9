#include "Metrics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace flatblock::testing
{
namespace
{
constexpr int Window = 11;

void Check(const Picture& a, const Picture& b)
{
  if (a.size() != b.size() || a.empty())
  {
    throw std::invalid_argument("Two pictures of one size are compared.");
  }
}

double MeanSquare(const Picture& a, const Picture& b)
{
  Check(a, b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      sum += (a[i][c] - b[i][c]) * (a[i][c] - b[i][c]);
    }
  }
  return sum / (3.0 * static_cast<double>(a.size()));
}

std::vector<double> GetLuma(const Picture& picture)
{
  std::vector<double> luma;
  luma.reserve(picture.size());
  for (const auto& pixel : picture)
  {
    luma.push_back(0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]);
  }
  return luma;
}

// The weights of a window's pixels, of sum 1.
std::vector<double> MakeWindow()
{
  std::vector<double> weights;
  double sum = 0.0;
  for (int y = -Window / 2; y <= Window / 2; ++y)
  {
    for (int x = -Window / 2; x <= Window / 2; ++x)
    {
      weights.push_back(std::exp(-(x * x + y * y) / (2.0 * 1.5 * 1.5)));
      sum += weights.back();
    }
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

// The similarity of the windows whose first pixels are `a` and `b`.
double Compare(const double* a, const double* b, int width, const std::vector<double>& weights)
{
  double meanA = 0.0;
  double meanB = 0.0;
  for (int i = 0; i < Window * Window; ++i)
  {
    const int at = i / Window * width + i % Window;
    meanA += weights[i] * a[at];
    meanB += weights[i] * b[at];
  }
  double squareA = 0.0;
  double squareB = 0.0;
  double product = 0.0;
  for (int i = 0; i < Window * Window; ++i)
  {
    const int at = i / Window * width + i % Window;
    squareA += weights[i] * (a[at] - meanA) * (a[at] - meanA);
    squareB += weights[i] * (b[at] - meanB) * (b[at] - meanB);
    product += weights[i] * (a[at] - meanA) * (b[at] - meanB);
  }
  constexpr double C1 = 0.01 * 0.01;
  constexpr double C2 = 0.03 * 0.03;
  return (2.0 * meanA * meanB + C1) * (2.0 * product + C2) /
         ((meanA * meanA + meanB * meanB + C1) * (squareA + squareB + C2));
}

double ToLinear(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
} // namespace

double RootMeanSquare(const Picture& a, const Picture& b)
{
  return std::sqrt(MeanSquare(a, b));
}

double PeakSignalToNoise(const Picture& a, const Picture& b)
{
  const double square = MeanSquare(a, b);
  return square > 0.0 ? std::min(200.0, -10.0 * std::log10(square)) : 200.0;
}

double StructuralSimilarity(const Picture& a, const Picture& b, int width)
{
  Check(a, b);
  const auto pixels = static_cast<int>(a.size());
  const int height = width > 0 ? pixels / width : 0;
  if (width < Window || height < Window || width * height != pixels)
  {
    throw std::invalid_argument("Structural similarity takes pictures of 11 x 11 pixels or more.");
  }
  const std::vector<double> left = GetLuma(a);
  const std::vector<double> right = GetLuma(b);
  const std::vector<double> weights = MakeWindow();
  const int columns = width - Window + 1;
  const int rows = height - Window + 1;
  double sum = 0.0;
#pragma omp parallel for reduction(+ : sum)
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < columns; ++x)
    {
      const std::size_t at = std::size_t(y) * width + x;
      sum += Compare(&left[at], &right[at], width, weights);
    }
  }
  return sum / (static_cast<double>(columns) * rows);
}

std::array<double, 3> ToLuv(const std::array<double, 4>& color)
{
  const double r = ToLinear(color[0]);
  const double g = ToLinear(color[1]);
  const double b = ToLinear(color[2]);
  // sRGB's primaries with D65 as their sum.
  const std::array<double, 3> red = { 0.4124564, 0.2126729, 0.0193339 };
  const std::array<double, 3> green = { 0.3575761, 0.7151522, 0.1191920 };
  const std::array<double, 3> blue = { 0.1804375, 0.0721750, 0.9503041 };
  std::array<double, 3> xyz;
  std::array<double, 3> white;
  for (int i = 0; i < 3; ++i)
  {
    xyz[i] = r * red[i] + g * green[i] + b * blue[i];
    white[i] = red[i] + green[i] + blue[i];
  }
  const auto sum = [](const std::array<double, 3>& c) { return c[0] + 15.0 * c[1] + 3.0 * c[2]; };
  if (!(sum(xyz) > 0.0))
  {
    return {};
  }
  const double y = xyz[1] / white[1];
  const double lightness =
    y > std::pow(6.0 / 29.0, 3.0) ? 116.0 * std::cbrt(y) - 16.0 : std::pow(29.0 / 3.0, 3.0) * y;
  return { lightness, 13.0 * lightness * (4.0 * xyz[0] / sum(xyz) - 4.0 * white[0] / sum(white)),
    13.0 * lightness * (9.0 * xyz[1] / sum(xyz) - 9.0 * white[1] / sum(white)) };
}

double LargestColorDifference(const Picture& a, const Picture& b)
{
  Check(a, b);
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const auto left = ToLuv(a[i]);
    const auto right = ToLuv(b[i]);
    largest =
      std::max(largest, std::hypot(left[0] - right[0], left[1] - right[1], left[2] - right[2]));
  }
  return largest;
}

double LargestDifference(const Picture& a, const Picture& b)
{
  Check(a, b);
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      largest = std::max(largest, std::abs(a[i][c] - b[i][c]));
    }
  }
  return largest;
}
} // namespace flatblock::testing
