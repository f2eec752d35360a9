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

/// Median of some frames in milliseconds, after one that is not counted.
inline double TimeFrames(testing::Scene& scene, int frames = 5)
{
  std::vector<double> times;
  for (int frame = 0; frame <= frames; ++frame)
  {
    const auto start = std::chrono::steady_clock::now();
    scene.Window->Render();
    scene.Window->WaitForCompletion();
    const std::chrono::duration<double, std::milli> taken =
      std::chrono::steady_clock::now() - start;
    times.push_back(taken.count());
  }
  times.erase(times.begin());
  std::nth_element(times.begin(), times.begin() + frames / 2, times.end());
  return times[frames / 2];
}

struct Errors
{
  double RootMeanSquare = 0.0;
  double PeakSignalToNoise = 0.0;
  double Similarity = 0.0;
  double Color = 0.0; ///< largest difference in CIELUV
};

inline Errors Compare(const testing::Picture& drawn, const testing::Picture& expected, int width)
{
  return { testing::RootMeanSquare(drawn, expected), testing::PeakSignalToNoise(drawn, expected),
    testing::StructuralSimilarity(drawn, expected, width),
    testing::LargestColorDifference(drawn, expected) };
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
