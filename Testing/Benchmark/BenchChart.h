/// Points and lines over two logarithmic axes.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace flatblock::benchmarks
{
struct Series
{
  std::string Name;
  std::array<unsigned char, 3> Color;
  int Marker; ///< of vtkPlotPoints
  bool IsLine;
  std::vector<std::pair<double, double>> Points; ///< positive
};

struct Chart
{
  std::string Title;
  std::string HorizontalAxis;
  std::string VerticalAxis;
  std::vector<Series> AllSeries; ///< those without points are left out
};

/// @throws std::runtime_error where the file cannot be written
void DrawChart(const Chart& chart, const std::string& file);
} // namespace flatblock::benchmarks
