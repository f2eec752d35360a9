/// Three classifications at the same time a frame, and how far each is from the reference.
#pragma once

#include "AccuracyMeasures.h"

#include "vtkPNGWriter.h"

#include <filesystem>

namespace flatblock::benchmarks
{
constexpr double Amplified = 8.0;

struct Panel
{
  double Step = 1.0; // voxels
  double Milliseconds = 0.0;
  testing::Picture Drawn;
  testing::Picture Difference; // amplified
};

/// The step in voxels at which a frame takes so long, from 1/64 to 8.
inline double FindStep(Subject& subject, double milliseconds)
{
  constexpr double CloseEnough = 0.03;
  double low = -6.0;
  double high = 3.0;
  double step = 1.0;
  for (int round = 0; round < 12; ++round)
  {
    step = std::exp2(0.5 * (low + high));
    subject.Shown.Mapper->SetSampleDistance(step * subject.Voxel);
    const double taken = TimeFrames(subject.Shown);
    if (std::abs(taken / milliseconds - 1.0) < CloseEnough)
    {
      break;
    }
    (taken > milliseconds ? low : high) = std::log2(step);
  }
  return step;
}

inline Panel DrawPanel(Subject& subject, double step, const testing::Picture& expected)
{
  subject.Shown.Mapper->SetSampleDistance(step * subject.Voxel);
  Panel panel{ step, TimeFrames(subject.Shown, 9), testing::DrawFloats(subject.Shown), {} };
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
  subject.Shown.Mapper->SetSampleDistance(subject.Voxel);
  const testing::Picture expected = testing::DrawReference(subject.Shown);
  const double milliseconds = TimeFrames(subject.Shown, 9);
  std::vector<double> steps;
  for (const Method& method : Methods)
  {
    subject.Shown.Mapper->SetClassification(method.Classification);
    steps.push_back(steps.empty() ? 1.0 : FindStep(subject, milliseconds));
  }
  std::vector<Panel> panels;
  std::vector<std::vector<std::string>> rows;
  for (const Method& method : Methods)
  {
    subject.Shown.Mapper->SetClassification(method.Classification);
    panels.push_back(DrawPanel(subject, steps[panels.size()], expected));
    const Panel& panel = panels.back();
    const Errors errors = Compare(panel.Drawn, expected, subject.GetWidth());
    rows.push_back({ method.Name, FormatStep(panel.Step), FormatTime(panel.Milliseconds),
      FormatRatio(panel.Milliseconds / panels.front().Milliseconds),
      FormatSmall(errors.RootMeanSquare), FormatDecibels(errors.PeakSignalToNoise),
      Format("%.2f", errors.Color) });
  }
  page.Section("The same time a frame");
  page.Text("The thin shell, with PreIntegrated at a step of one voxel, and the others at the step "
            "that takes as long. Above the pictures, over black; below each how far it is from the "
            "reference, times " +
            FormatRatio(Amplified) +
            ". All pixels are compared. From left to right the pictures are the rows of the table: "
            "what a classification costs a sample, it gives back or not in the step that it "
            "needs.");
  page.Text("![The thin shell by three classifications at the same time a frame](" +
            std::filesystem::path(file).filename().string() + ")");
  page.Table(
    { "classification", "step, voxels", "ms", "ms / first", "RMSE", "PSNR, dB", "largest CIELUV" },
    rows);
  return WriteFigure(file, panels, subject.GetWidth());
}
} // namespace flatblock::benchmarks
