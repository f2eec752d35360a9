/// Three classifications at the same time a frame, and how far each is from the reference.
#pragma once

#include "AccuracyMeasures.h"

#include "vtkPNGWriter.h"

#include <filesystem>

namespace flatblock::benchmarks
{
constexpr double Amplified = 8.0;

struct Sampling
{
  int Classification;
  double Step; // voxels
};

struct Panel
{
  testing::Picture Drawn;
  testing::Picture Difference; // amplified
};

inline void Apply(Subject& subject, const Sampling& sampling)
{
  subject.Shown.Mapper->SetClassification(sampling.Classification);
  subject.Shown.Mapper->SetSampleDistance(sampling.Step * subject.Voxel);
}

/// Medians in milliseconds of frames that take turns, so that all are slowed alike by whatever else
/// the machine does; after one of each that is not counted.
inline std::vector<double> TimeInTurns(
  Subject& subject, const std::vector<Sampling>& samplings, int frames)
{
  std::vector<std::vector<double>> times(samplings.size());
  for (int frame = 0; frame <= frames; ++frame)
  {
    for (std::size_t i = 0; i < samplings.size(); ++i)
    {
      Apply(subject, samplings[i]);
      const double taken = TimeFrame(subject.Shown);
      if (frame > 0)
      {
        times[i].push_back(taken);
      }
    }
  }
  std::vector<double> medians;
  for (const auto& some : times)
  {
    medians.push_back(GetMedian(some));
  }
  return medians;
}

/// The sampling of a classification that takes as long as another one, with a step of 1/64 to 8.
inline Sampling FindStep(Subject& subject, int classification, const Sampling& other)
{
  constexpr double CloseEnough = 0.03;
  double low = -6.0;
  double high = 3.0;
  Sampling sampling{ classification, 1.0 };
  for (int round = 0; round < 12; ++round)
  {
    sampling.Step = std::exp2(0.5 * (low + high));
    const auto taken = TimeInTurns(subject, { other, sampling }, 5);
    const double ratio = taken[1] / taken[0];
    if (std::abs(ratio - 1.0) < CloseEnough)
    {
      break;
    }
    (ratio > 1.0 ? low : high) = std::log2(sampling.Step);
  }
  return sampling;
}

inline Panel DrawPanel(Subject& subject, const Sampling& sampling, const testing::Picture& expected)
{
  Apply(subject, sampling);
  Panel panel{ testing::DrawFloats(subject.Shown), {} };
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    std::array<double, 4> difference = {};
    for (int c = 0; c < 3; ++c)
    {
      difference[c] = Amplified * std::abs(panel.Drawn[i][c] - expected[i][c]);
    }
    panel.Difference.push_back(difference);
  }
  return panel;
}

/// Copies a picture to where its lower left corner is to be.
inline void Paste(vtkImageData* sheet, const testing::Picture& picture, int width, int x, int y)
{
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    const auto column = static_cast<int>(i % width);
    const auto row = static_cast<int>(i / width);
    auto* pixel = static_cast<unsigned char*>(sheet->GetScalarPointer(x + column, y + row, 0));
    for (int c = 0; c < 3; ++c)
    {
      pixel[c] =
        static_cast<unsigned char>(std::lround(255.0 * std::clamp(picture[i][c], 0.0, 1.0)));
    }
  }
}

/// The panels from left to right, above their differences.
inline bool WriteFigure(const std::string& file, const std::vector<Panel>& panels, int width)
{
  constexpr int Gap = 4;
  const auto height = static_cast<int>(panels.front().Drawn.size()) / width;
  const auto columns = static_cast<int>(panels.size());
  vtkNew<vtkImageData> sheet;
  sheet->SetDimensions(columns * (width + Gap) - Gap, 2 * height + Gap, 1);
  sheet->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(
    static_cast<unsigned char*>(sheet->GetScalarPointer()), 3 * sheet->GetNumberOfPoints(), 255);
  for (int column = 0; column < columns; ++column)
  {
    Paste(sheet, panels[column].Drawn, width, column * (width + Gap), height + Gap);
    Paste(sheet, panels[column].Difference, width, column * (width + Gap), 0);
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(sheet);
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

/// False where the figure could not be written.
inline bool ReportEqualTimes(Page& page, Subject& subject, const std::string& file)
{
  subject.Reset();
  const testing::Picture expected = testing::DrawReference(subject.Shown);
  std::vector<Sampling> samplings;
  for (const Method& method : Methods)
  {
    samplings.push_back(samplings.empty()
                          ? Sampling{ method.Classification, 1.0 }
                          : FindStep(subject, method.Classification, samplings.front()));
  }
  const std::vector<double> times = TimeInTurns(subject, samplings, 15);
  std::vector<Panel> panels;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < samplings.size(); ++i)
  {
    panels.push_back(DrawPanel(subject, samplings[i], expected));
    const Errors errors = Compare(panels[i].Drawn, expected, subject.GetWidth());
    rows.push_back({ Methods[i].Name, FormatStep(samplings[i].Step), FormatTime(times[i]),
      FormatRatio(times[i] / times[0]), FormatSmall(errors.RootMeanSquare),
      FormatDecibels(errors.PeakSignalToNoise), Format("%.2f", errors.Color) });
  }
  page.Section("The same time a frame");
  page.Text("The thin shell, with PreIntegrated at a step of one voxel, and the others at the step "
            "that takes as long here, by measurement: a classification that costs less a sample "
            "has more of them. Frames take turns, so these times are not those of the table above. "
            "From left to right the pictures, over black, are the rows of the table; below each "
            "is how far it is from the reference, times " +
            FormatRatio(Amplified) + ". All pixels are compared.");
  page.Text("![The thin shell by three classifications at the same time a frame](" +
            std::filesystem::path(file).filename().string() + ")");
  page.Table(
    { "classification", "step, voxels", "ms", "ms / first", "RMSE", "PSNR, dB", "largest CIELUV" },
    rows);
  return WriteFigure(file, panels, subject.GetWidth());
}
} // namespace flatblock::benchmarks
