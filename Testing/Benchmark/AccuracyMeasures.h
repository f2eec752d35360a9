/// What is measured of a picture, and the page that it is written to.
#pragma once

#include "AccuracyScenes.h"

#include <chrono>
#include <cstdio>
#include <fstream>

namespace flatblock::benchmarks
{
struct Method
{
  int Classification;
  const char* Name;
};

constexpr Method Methods[] = { { vtkFlatBlockVolumeMapper::PRE_INTEGRATED, "PreIntegrated" },
  { vtkFlatBlockVolumeMapper::POST_INTERPOLATION, "PostInterpolation" },
  { vtkFlatBlockVolumeMapper::PRE_INTERPOLATION, "PreInterpolation" } };

inline double GetMedian(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

inline double TimeFrame(testing::Scene& scene)
{
  const auto start = std::chrono::steady_clock::now();
  scene.Window->Render();
  scene.Window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  return taken.count();
}

/// Median of five frames in milliseconds, after one that is not counted.
inline double TimeFrames(testing::Scene& scene)
{
  TimeFrame(scene);
  std::vector<double> times;
  for (int frame = 0; frame < 5; ++frame)
  {
    times.push_back(TimeFrame(scene));
  }
  return GetMedian(times);
}

struct Errors
{
  double RootMeanSquare = 0.0;
  double PeakSignalToNoise = 0.0;
  double Similarity = 0.0;
  double Color = 0.0;  ///< largest difference in CIELUV
  double OfMost = 0.0; ///< largest difference of a channel, but for a hundredth of the pixels
};

inline double GetDifferenceOfMost(const testing::Picture& a, const testing::Picture& b)
{
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    differences.push_back(testing::LargestDifference({ a[i] }, { b[i] }));
  }
  const auto most =
    differences.begin() + static_cast<std::ptrdiff_t>(differences.size() * 99 / 100);
  std::nth_element(differences.begin(), most, differences.end());
  return *most;
}

inline Errors Compare(const testing::Picture& drawn, const testing::Picture& expected, int width)
{
  return { testing::RootMeanSquare(drawn, expected), testing::PeakSignalToNoise(drawn, expected),
    testing::StructuralSimilarity(drawn, expected, width),
    testing::LargestColorDifference(drawn, expected), GetDifferenceOfMost(drawn, expected) };
}

/// A picture of floats of all pixels against every Stride-th of the reference.
inline Errors CompareWithReference(Subject& subject, const testing::Picture& drawn)
{
  return Compare(testing::TakeEvery(drawn, subject.GetWidth(), Stride), subject.Reference,
    (subject.GetWidth() + Stride - 1) / Stride);
}

inline Errors DrawAndCompare(Subject& subject)
{
  return CompareWithReference(subject, testing::DrawFloats(subject.Shown));
}

inline std::string Format(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

inline std::string FormatTime(double milliseconds)
{
  return Format("%.1f", milliseconds);
}
inline std::string FormatStep(double voxels)
{
  return Format("%.4g", voxels);
}
inline std::string FormatSmall(double error)
{
  return Format("%.2e", error);
}
inline std::string FormatDecibels(double decibels)
{
  return Format("%.1f", decibels);
}
inline std::string FormatRatio(double ratio)
{
  return Format("%.3g", ratio);
}

/// Markdown, written as it comes.
class Page
{
public:
  explicit Page(const std::string& file) : Stream(file) {}

  bool IsGood() const { return this->Stream.good(); }
  void Section(const std::string& title) { this->Stream << "## " << title << "\n\n"; }
  void Text(const std::string& text) { this->Stream << text << "\n\n"; }

  void Table(
    const std::vector<std::string>& titles, const std::vector<std::vector<std::string>>& rows)
  {
    this->Row(titles);
    this->Row(std::vector<std::string>(titles.size(), "---"));
    for (const auto& row : rows)
    {
      this->Row(row);
    }
    this->Stream << std::endl;
  }

private:
  void Row(const std::vector<std::string>& cells)
  {
    this->Stream << "|";
    for (const std::string& cell : cells)
    {
      this->Stream << " " << cell << " |";
    }
    this->Stream << "\n";
  }

  std::ofstream Stream;
};
} // namespace flatblock::benchmarks
