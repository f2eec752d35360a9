// How exact curvature is, and what it costs: writes a page, a plot and a figure. Needs a display.
#include "AccuracyFigure.h"
#include "BenchChart.h"
#include "BenchMachine.h"
#include "BenchScenes.h"
#include "CurvaturePicture.h"

#include <iostream>

using namespace flatblock::benchmarks;
using namespace flatblock::testing;

namespace
{
using Mapper = vtkFlatBlockVolumeMapper;
using Rows = std::vector<std::vector<std::string>>;

constexpr int Sizes[] = { 17, 33, 65, 129 };
constexpr int Filters[] = { Mapper::LINEAR, Mapper::CUBIC_B_SPLINE };
constexpr const char* FilterNames[] = { "linear", "B-spline" };

struct Accuracy
{
  double Mean = 0.0;
  double Largest = 0.0;
};

// Of first principal, second principal, mean and Gaussian curvature.
constexpr int Measured[] = { Mapper::FIRST_PRINCIPAL, Mapper::SECOND_PRINCIPAL, Mapper::MEAN,
  Mapper::GAUSSIAN };

Accuracy MeasureAgainstFormula(Scene& scene, const CurvatureField& field, int n, int function,
  std::vector<CurvaturePixel>& pixels)
{
  MeasureCurvature(scene, function, function == Mapper::GAUSSIAN ? 1000.0 : 30.0, pixels);
  Accuracy accuracy;
  for (const CurvaturePixel& pixel : pixels)
  {
    std::array<double, 3> point;
    std::transform(pixel.Point.begin(), pixel.Point.end(), point.begin(),
      [n](double sample) { return 2.0 * sample / (n - 1) - 1.0; });
    const double error = std::abs(
      pixel.Value - GetCurvature(function, GetPrincipalCurvatures(field.Derivatives(point))));
    accuracy.Mean += error / static_cast<double>(pixels.size());
    accuracy.Largest = std::max(accuracy.Largest, error);
  }
  return accuracy;
}

// The first curvature's errors by filter and size, as one line of the plot each.
Rows MeasureField(const CurvatureField& field, std::vector<Series>& lines)
{
  constexpr std::array<unsigned char, 3> Colors[] = { { 31, 119, 180 }, { 214, 39, 40 } };
  Rows rows;
  for (int filter : Filters)
  {
    Series line = { field.Name + ", " + FilterNames[filter], Colors[filter],
      static_cast<int>(lines.size() / 2 % 5) + 1, true, {} };
    for (int n : Sizes)
    {
      Scene scene;
      scene.Window->SetSize(160, 160);
      ShowField(scene, field, n);
      scene.Mapper->SetReconstructionFilter(filter);
      auto pixels = FindPixels(scene, SampledField(ReadReferenceVolume(scene), GetFilter(scene)));
      std::vector<std::string> row = { field.Name, FilterNames[filter], std::to_string(n) };
      for (int function : Measured)
      {
        const Accuracy accuracy = MeasureAgainstFormula(scene, field, n, function, pixels);
        row.push_back(FormatSmall(accuracy.Mean) + ", " + FormatSmall(accuracy.Largest));
        if (function == Mapper::FIRST_PRINCIPAL)
        {
          line.Points.emplace_back(n - 1, accuracy.Mean);
        }
      }
      rows.push_back(row);
    }
    lines.push_back(line);
  }
  return rows;
}

void ReportAccuracy(Page& page, const std::string& plot)
{
  page.Section("How exact it is");
  page.Text(
    "Fields in the cube [-1, 1]^3, in n samples a side of 32-bit floats, shown by their isosurface "
    "0 in 160 x 160 pixels. In each pixel at least two samples away from the faces of the cube the "
    "mapper's curvature is compared with that of the formula, at the point where the ray meets the "
    "surface of the sampled field in double precision. Mean and largest error, of curvature in "
    "1/length and of Gaussian curvature in 1/length^2. Where a ray passes through the surface "
    "twice within a step one of both may miss it: that single pixel is the largest error of the "
    "gyroid in 65 samples. `Testing/Cxx/TestCurvature.cxx` holds that "
    "errors fall with the square of the spacing. Where samples are many, what is left is the "
    "rounding of 32-bit samples, which the square of the spacing divides: the smooth sphere gets "
    "there first. The gyroid's waves a spline only scales, "
    "which curvature does not see.");
  Rows rows;
  std::vector<Series> lines;
  for (const CurvatureField& field : GetCurvatureFields())
  {
    const Rows more = MeasureField(field, lines);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  Series square = { "second order", { 120, 120, 120 }, 0, true, {} };
  for (int n : Sizes)
  {
    square.Points.emplace_back(n - 1, 60.0 / ((n - 1.0) * (n - 1.0)));
  }
  lines.push_back(square);
  DrawChart(
    { "Mean error of the first principal curvature", "cells a side", "error, 1/length", lines },
    plot);
  page.Text("![errors](" + plot.substr(plot.rfind('/') + 1) + ")");
  page.Table({ "field", "filter", "n", "first", "second", "mean", "Gaussian" }, rows);
}

struct Volume
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  std::vector<std::pair<double, double>> Opacity;
  std::array<double, 3> View; // azimuth, elevation, zoom
};

// Means of 2^3 samples, in floats: without the rounding and the noise of single samples.
vtkSmartPointer<vtkImageData> Smooth(vtkImageData* image)
{
  vtkNew<vtkImageCast> floats;
  floats->SetInputData(image);
  floats->SetOutputScalarTypeToFloat();
  vtkNew<vtkImageShrink3D> means;
  means->SetInputConnection(floats->GetOutputPort());
  means->SetShrinkFactors(2, 2, 2);
  means->MeanOn();
  means->Update();
  return means->GetOutput();
}

vtkSmartPointer<vtkImageData> MakeBone()
{
  constexpr int Side = 384;
  const std::vector<std::uint16_t> samples = MakeCtLike({ Side, Side, Side });
  return Smooth(MakeVolume({ Side, Side, Side }, VTK_UNSIGNED_SHORT,
    [&samples](int x, int y, int z) { return samples[(z * Side + y) * Side + x]; }));
}

std::vector<Volume> MakeVolumes()
{
  std::vector<Volume> volumes;
  if (const auto mri = ReadMRI())
  {
    volumes.push_back(
      { "MRI", Smooth(*mri), { { 70.0, 0.0 }, { 110.0, 0.5 } }, { 0.0, -60.0, 1.5 } });
  }
  volumes.push_back(
    { "bone", MakeBone(), { { 1300.0, 0.0 }, { 1600.0, 0.5 } }, { 30.0, -70.0, 1.4 } });
  volumes.push_back({ "tree", Smooth(MakeVesselTree(512, 7)), { { 300.0, 0.0 }, { 600.0, 0.5 } },
    { 30.0, 20.0, 1.2 } });
  return volumes;
}

struct Variant
{
  const char* Name;
  int Filter;
  bool IsOnDemand;
};

constexpr Variant Variants[] = { { "linear, on demand", Mapper::LINEAR, true },
  { "B-spline, on demand", Mapper::CUBIC_B_SPLINE, true },
  { "B-spline, everywhere", Mapper::CUBIC_B_SPLINE, false } };

struct Counts
{
  double Samples = 0.0;
  double Fetches = 0.0;
};

Counts CountOnce(Scene& scene)
{
  scene.Mapper->CountSamplesOn();
  scene.Window->Render();
  scene.Mapper->CountSamplesOff();
  return { scene.Mapper->GetSamplesPerRay(), scene.Mapper->GetFetchesPerRay() };
}

double TimeThree(Scene& scene)
{
  TimeFrame(scene);
  return GetMedian({ TimeFrame(scene), TimeFrame(scene), TimeFrame(scene) });
}

// Frames of the three take turns.
void MeasureVariants(const Volume& volume, Rows& rows, std::vector<Picture>& pictures)
{
  Scene scene;
  scene.SetVolume(volume.Image, 0.25 * volume.Image->GetSpacing()[0]);
  scene.SetOpacity(volume.Opacity);
  scene.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(1) << 30);
  scene.Property->ShadeOn();
  scene.LookFrom(volume.View[0], volume.View[1], volume.View[2]);
  Picture onDemand;
  for (const Variant& variant : Variants)
  {
    scene.Mapper->SetReconstructionFilter(variant.Filter);
    scene.Mapper->SetDerivativesOnDemand(variant.IsOnDemand);
    scene.Property->ShadeOff();
    scene.Mapper->SetCurvatureFunctionToNone();
    const Counts plain = CountOnce(scene);
    scene.Property->ShadeOn();
    scene.Mapper->SetCurvatureFunctionToMean();
    const Counts curved = CountOnce(scene);
    scene.Mapper->SetDerivativesOnDemand(false);
    const Counts everywhere = CountOnce(scene);
    scene.Mapper->SetDerivativesOnDemand(variant.IsOnDemand);
    const double milliseconds = TimeThree(scene);
    const Picture picture = DrawFloats(scene);
    std::string difference;
    if (!variant.IsOnDemand)
    {
      difference = Format("%.2f", 255.0 * LargestDifference(picture, onDemand));
    }
    onDemand = picture;
    pictures.push_back(picture);
    rows.push_back({ volume.Name, variant.Name, FormatTime(milliseconds),
      Format("%.0f", curved.Samples), Format("%.0f", curved.Fetches),
      Format("%.1f", (everywhere.Fetches - plain.Fetches) / everywhere.Samples),
      Format(
        "%.0f %%", 100.0 * (curved.Fetches - plain.Fetches) / (everywhere.Fetches - plain.Fetches)),
      difference });
  }
}

bool WriteSheet(const std::string& file, const std::vector<Picture>& pictures, int columns)
{
  constexpr int Side = 256;
  constexpr int Gap = 4;
  const int rows = static_cast<int>(pictures.size()) / columns;
  vtkNew<vtkImageData> sheet;
  sheet->SetDimensions(columns * (Side + Gap) - Gap, rows * (Side + Gap) - Gap, 1);
  sheet->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(
    static_cast<unsigned char*>(sheet->GetScalarPointer()), 3 * sheet->GetNumberOfPoints(), 255);
  for (int i = 0; i < static_cast<int>(pictures.size()); ++i)
  {
    Paste(sheet, pictures[i], Side, i % columns * (Side + Gap),
      (rows - 1 - i / columns) * (Side + Gap));
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(sheet);
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

bool ReportVariants(Page& page, const std::string& figure)
{
  page.Section("What it costs");
  page.Text(
    "Mean curvature of volumes whose samples are means of 8, in floats, shaded, in 256 x 256 "
    "pixels, at a step of a quarter of the smallest spacing. "
    "Milliseconds are medians of three frames. Fetches for a shaded sample are those of its "
    "derivatives, curvature and light alone. Gradient and Hessian come from one gather of single "
    "texels, the middle one of which is read twice: 65 for the B-spline, where 84 interpolated "
    "fetches were published, and 57 for linear differences, where 18 interpolated fetches read 144 "
    "texels; and one fetch is for the colour. A value takes one interpolated fetch in linear, and "
    "8 in the B-spline. Empty space is leapt over in all. The share of samples with derivatives is "
    "of those that are not leapt over; the last column is how far the picture is from that on "
    "demand, at most, in 1/255.");
  Rows rows;
  std::vector<Picture> pictures;
  const std::vector<Volume> volumes = MakeVolumes();
  for (const Volume& volume : volumes)
  {
    MeasureVariants(volume, rows, pictures);
  }
  page.Table({ "volume", "variant", "ms", "samples a ray", "fetches a ray",
               "fetches a shaded sample", "with derivatives", "difference" },
    rows);
  page.Text("The same from left to right, and from top to bottom:");
  page.Text("![pictures](" + figure.substr(figure.rfind('/') + 1) + ")");
  return WriteSheet(figure, pictures, 3);
}
} // namespace

int main(int argc, char** argv)
{
  if (argc != 4)
  {
    std::cerr << "usage: FlatBlockCurvatureBenchmark OUTPUT.md PLOT.png FIGURE.png\n";
    return 1;
  }
  Page page(argv[1]);
  page.Text("# Curvature");
  {
    Scene scene;
    scene.Window->Render();
    page.Text(GetToday() + ", " + GetProcessor() + "; " + GetOpenGL(scene.Window) + ".");
  }
  page.Text(
    "```\n" + std::string(argv[0]) + " " + argv[1] + " " + argv[2] + " " + argv[3] + "\n```");
  const bool isWritten = ReportVariants(page, argv[3]);
  ReportAccuracy(page, argv[2]);
  if (!page.IsGood() || !isWritten)
  {
    std::cerr << "Cannot write " << (isWritten ? argv[1] : argv[3]) << ".\n";
    return 1;
  }
}
