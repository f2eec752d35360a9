// How far pictures are from the reference in double precision, and what that costs: writes a page
// and a figure. Needs a display.
#include "vtk_glew.h"

#include "AccuracyFigure.h"

#include "vtkOpenGLRenderWindow.h"

#include <ctime>
#include <iostream>
#include <map>
#include <thread>

using namespace flatblock::benchmarks;
using namespace flatblock::testing;

namespace
{
using Rows = std::vector<std::vector<std::string>>;

constexpr double Steps[] = { 2.0, 1.0, 0.5, 0.25, 0.125 };

std::string GetProcessor()
{
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line))
  {
    if (line.rfind("model name", 0) == 0)
    {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown processor";
}

std::string GetToday()
{
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::localtime(&now));
  return text;
}

void Introduce(Page& page, const Subjects& subjects, const std::string& command)
{
  vtkOpenGLRenderWindow::SafeDownCast(subjects.front()->Shown.Window)->MakeCurrent();
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  page.Text("# How accurate pictures are");
  page.Text(GetToday() + ", " + GetProcessor() + ", " +
            std::to_string(std::thread::hardware_concurrency()) +
            " cores; OpenGL renderer: " + (renderer ? renderer : "unknown") + ".");
  page.Text("```\n" + command + "\n```");
  page.Text(
    "Pictures of 256 x 256 pixels of 32-bit floats, over black, are compared with those of a ray "
    "caster on the CPU in double precision, which integrates emission and absorption through the "
    "trilinear field to an error below 1e-6 (`Testing/Support/ReferenceRayCaster`). The reference "
    "draws every fourth pixel of every fourth row, 64 x 64 of them, and only these are compared, "
    "by SSIM, too. RMSE is over red, green and blue, in a range from 0 to 1; PSNR is to a peak of "
    "1; the largest difference in CIELUV is that of the worst pixel, where black and white are 100 "
    "apart. A time is the median of five frames of `Render()` and `WaitForCompletion()` of a "
    "window of that size, after one that does not count.");
  page.Text("Rays go on to the end, but where early termination is what is measured. Steps are in "
            "voxels: the smallest spacing. Unless a table says otherwise the classification is "
            "PreIntegrated, the step half a voxel, and all blocks are at their finest level. The "
            "program writes this page whole.");
  std::string list;
  for (const auto& subject : subjects)
  {
    list += (list.empty() ? "- " : "\n- ") + subject->Name + ": " + subject->Description;
  }
  page.Text(list);
}

// RMSE by classification and step.
using Measured = std::map<int, std::map<double, double>>;

Rows MeasureSteps(Subject& subject, Measured& measured)
{
  subject.Reset();
  Rows rows;
  for (const Method& method : Methods)
  {
    subject.Shown.Mapper->SetClassification(method.Classification);
    for (double step : Steps)
    {
      subject.Shown.Mapper->SetSampleDistance(step * subject.Voxel);
      const double milliseconds = TimeFrames(subject.Shown);
      const Errors errors = DrawAndCompare(subject);
      measured[method.Classification][step] = errors.RootMeanSquare;
      rows.push_back({ subject.Name, method.Name, FormatStep(step), FormatTime(milliseconds),
        FormatSmall(errors.RootMeanSquare), FormatDecibels(errors.PeakSignalToNoise),
        Format("%.5f", errors.Similarity), Format("%.2f", errors.Color),
        FormatSmall(errors.OfMost) });
    }
  }
  return rows;
}

std::vector<std::string> Summarize(const std::string& name, Measured& measured)
{
  constexpr int Pre = vtkFlatBlockVolumeMapper::PRE_INTEGRATED;
  constexpr int Post = vtkFlatBlockVolumeMapper::POST_INTERPOLATION;
  std::string asGood = "none of these";
  for (double step : Steps)
  {
    if (measured[Post][step] <= measured[Pre][1.0])
    {
      asGood = FormatStep(step);
      break;
    }
  }
  return { name, FormatRatio(measured[Post][1.0] / measured[Pre][1.0]), asGood,
    FormatRatio(measured[Pre][2.0] / measured[Pre][0.125]),
    FormatRatio(measured[Post][2.0] / measured[Post][0.125]) };
}

void ReportSteps(Page& page, const Subjects& subjects)
{
  Rows rows;
  Rows summary;
  for (const auto& subject : subjects)
  {
    Measured measured;
    const Rows more = MeasureSteps(*subject, measured);
    rows.insert(rows.end(), more.begin(), more.end());
    summary.push_back(Summarize(subject->Name, measured));
  }
  page.Section("Classification and step");
  page.Text(
    "PreIntegrated takes values between two samples of a ray as linear, so its error is that of a "
    "straight line in place of the cubic that a trilinear field is along a ray, and falls with the "
    "step until what is left is that of the table and of single precision. PostInterpolation "
    "misses what lies between two samples, and needs steps that are short beside the features of "
    "the transfer function. Where the function is smooth over what a step runs through, there is "
    "little to miss: then PostInterpolation's errors inside a cell and at its faces cancel along a "
    "ray, and those of PreIntegrated, which count by the slope of the function, cancel less. "
    "PreInterpolation draws another field than the reference, classified before it is "
    "interpolated: its error does not go away with the step.");
  page.Text(
    "In 99 % of the pixels no channel, opacity among them, is farther off than the last "
    "column says. Where it falls with the step and RMSE does not, single rays are to blame: "
    "those that graze a surface where opacity reaches 1. Extinction has no limit there, and "
    "a table gives a straight line between its last two entries.");
  page.Table({ "scene", "classification", "step, voxels", "ms", "RMSE", "PSNR, dB", "SSIM",
               "largest CIELUV", "99 % within" },
    rows);
  page.Text("Ratios of these RMSE: of PostInterpolation to PreIntegrated at a step of one voxel; "
            "the longest of the steps at which PostInterpolation is at least as close as "
            "PreIntegrated at one voxel; and how many times less the error is at 0.125 voxels than "
            "at 2.");
  page.Table({ "scene", "PostInterpolation / PreIntegrated", "step for the same error",
               "PreIntegrated, 2 / 0.125", "PostInterpolation, 2 / 0.125" },
    summary);
}

Rows MeasureTermination(Subject& subject)
{
  subject.Reset();
  const Picture whole = DrawFloats(subject.Shown);
  Rows rows;
  for (double threshold : { 0.9, 0.95, 0.99, 1.0 - 1.0 / 255.0, 0.999, 1.0 })
  {
    subject.Shown.Mapper->SetEarlyTerminationThreshold(threshold);
    const double milliseconds = TimeFrames(subject.Shown);
    const Picture drawn = DrawFloats(subject.Shown);
    rows.push_back({ subject.Name, Format("%.6g", threshold),
      FormatSmall(LargestDifference(drawn, whole)), FormatSmall(1.0 - threshold),
      FormatSmall(RootMeanSquare(drawn, whole)), FormatTime(milliseconds) });
  }
  return rows;
}

void ReportTermination(Page& page, const Subjects& subjects)
{
  Rows rows;
  for (const char* name : { "opaque surface", "dense fog" })
  {
    const Rows more = MeasureTermination(Find(subjects, name));
    rows.insert(rows.end(), more.begin(), more.end());
  }
  page.Section("Early termination");
  page.Text(
    "A ray that has gathered the threshold ends. What is left out is at most what shines through: "
    "1 less the threshold, in any channel, opacity among them. Errors are against the picture "
    "with a threshold of 1, all pixels. The default is " +
    Format("%.6g", 1.0 - 1.0 / 255.0) +
    ". Few rays meet a surface between the threshold and 1, and most end there all the same; in "
    "fog the threshold decides how far a ray goes.");
  page.Table({ "scene", "threshold", "largest difference", "1 - threshold", "RMSE", "ms" }, rows);
}

// Draws with the most memory that leaves at least half of the blocks coarse.
void MakeHalfCoarse(Scene& scene)
{
  constexpr int Parts = 32;
  vtkFlatBlockVolumeMapper* mapper = scene.Mapper;
  mapper->SetBlockSize(17);
  scene.Window->Render();
  const vtkTypeInt64 beside = mapper->GetMemoryInBytes() - mapper->GetAtlasBytes();
  const vtkTypeInt64 bricks = mapper->GetUsedAtlasBytes();
  for (int part = Parts; part > 0 && 2 * mapper->GetNumberOfBricks(0) > CountBricks(mapper); --part)
  {
    mapper->SetMaxMemoryInBytes(beside + bricks * part / Parts);
    scene.Window->Render();
  }
}

std::string ListBricks(vtkFlatBlockVolumeMapper* mapper)
{
  std::string list;
  for (int level = 0; level < 4; ++level)
  {
    list += (level > 0 ? " " : "") + std::to_string(mapper->GetNumberOfBricks(level));
  }
  return list;
}

Rows MeasureAdaptiveSampling(Subject& subject)
{
  subject.Reset();
  Scene& scene = subject.Shown;
  Rows rows;
  const auto measure = [&](const std::string& what)
  {
    const double milliseconds = TimeFrames(scene);
    const Picture drawn = DrawFloats(scene);
    const Errors errors = CompareWithReference(subject, drawn);
    rows.push_back({ subject.Name, ListBricks(scene.Mapper), what, FormatTime(milliseconds),
      FormatSmall(errors.RootMeanSquare), FormatDecibels(errors.PeakSignalToNoise) });
    return drawn;
  };
  scene.Mapper->SetBlockSize(17);
  measure("on, all blocks finest");
  MakeHalfCoarse(scene);
  const Picture adaptive = measure("on");
  scene.Mapper->AdaptiveSamplingOff();
  const Picture even = measure("off");
  rows.push_back({ subject.Name, ListBricks(scene.Mapper), "on against off", "",
    FormatSmall(RootMeanSquare(adaptive, even)),
    FormatDecibels(PeakSignalToNoise(adaptive, even)) });
  return rows;
}

void ReportAdaptiveSampling(Page& page, const Subjects& subjects)
{
  Rows rows;
  for (const char* name : { "thin shell", "dense fog", "noise" })
  {
    const Rows more = MeasureAdaptiveSampling(Find(subjects, name));
    rows.insert(rows.end(), more.begin(), more.end());
  }
  page.Section("Adaptive sampling");
  page.Text(
    "Blocks of 17, with as much memory as leaves half of them coarse. With adaptive sampling "
    "the step doubles with each level. Errors are against the reference of the full volume, so "
    "that those of the levels are part of them; the last row of a scene compares its pictures with "
    "and without adaptive sampling, all pixels, and shows what the longer steps alone do.");
  page.Table({ "scene", "bricks by level", "adaptive sampling", "ms", "RMSE", "PSNR, dB" }, rows);
}

void ReportJittering(Page& page, const Subjects& subjects)
{
  Rows rows;
  for (const auto& subject : subjects)
  {
    subject->Reset();
    subject->Shown.Mapper->SetClassificationToPostInterpolation();
    subject->Shown.Mapper->SetSampleDistance(2.0 * subject->Voxel);
    const Errors off = DrawAndCompare(*subject);
    subject->Shown.Mapper->UseJitteringOn();
    const Errors on = DrawAndCompare(*subject);
    rows.push_back({ subject->Name, FormatSmall(off.RootMeanSquare), FormatSmall(on.RootMeanSquare),
      FormatRatio(on.RootMeanSquare / off.RootMeanSquare), Format("%.4f", off.Similarity),
      Format("%.4f", on.Similarity) });
  }
  page.Section("Jittering");
  page.Text("PostInterpolation at a step of 2 voxels, with rays that begin together or each at "
            "another share of a step. Jittering adds no samples: it turns rings into noise. The "
            "ratio tells whether single pixels come closer to the reference by it.");
  page.Table({ "scene", "RMSE, off", "RMSE, on", "on / off", "SSIM, off", "SSIM, on" }, rows);
}

double RoundedMarschnerLobbAt(int i, int j, int k)
{
  return std::round(MarschnerLobbAt(i, j, k));
}

void ReportFiltering(Page& page)
{
  Rows rows;
  std::vector<Picture> pictures;
  for (int type : { VTK_UNSIGNED_SHORT, VTK_UNSIGNED_CHAR })
  {
    const auto subject = MakeShell(type, RoundedMarschnerLobbAt);
    subject->Reset();
    subject->Shown.Window->Render();
    subject->Reference = DrawReference(subject->Shown, Stride);
    pictures.push_back(DrawFloats(subject->Shown));
    const Errors errors = CompareWithReference(*subject, pictures.back());
    rows.push_back({ type == VTK_UNSIGNED_CHAR ? "8 bit" : "16 bit", "the reference",
      FormatSmall(errors.RootMeanSquare), FormatDecibels(errors.PeakSignalToNoise),
      Format("%.2f", errors.Color) });
  }
  rows.push_back({ "8 bit", "16 bit", FormatSmall(RootMeanSquare(pictures[1], pictures[0])),
    FormatDecibels(PeakSignalToNoise(pictures[1], pictures[0])),
    Format("%.2f", LargestColorDifference(pictures[1], pictures[0])) });
  page.Section("Filtering of textures");
  page.Text(
    "The thin shell's values, rounded to integers from 0 to 255, as a volume of 16 bit and as one "
    "of 8 bit. The numbers that are interpolated are the same, and so is the reference; what "
    "differs is how exactly the driver's texture units interpolate: a fact about the driver and "
    "not about the ray caster.");
  page.Table({ "volume", "against", "RMSE", "PSNR, dB", "largest CIELUV" }, rows);
}
} // namespace

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::cerr << "usage: FlatBlockAccuracyBenchmark OUTPUT.md FIGURE.png\n";
    return 1;
  }
  Page page(argv[1]);
  if (!page.IsGood())
  {
    std::cerr << "Cannot write " << argv[1] << ".\n";
    return 1;
  }
  const std::string command = std::string(argv[0]) + " " + argv[1] + " " + argv[2];
  const Subjects subjects = MakeSubjects();
  Introduce(page, subjects, command);
  ReportSteps(page, subjects);
  const bool isWritten = ReportEqualTimes(page, Find(subjects, "thin shell"), argv[2]);
  ReportTermination(page, subjects);
  ReportAdaptiveSampling(page, subjects);
  ReportJittering(page, subjects);
  ReportFiltering(page);
  if (!page.IsGood() || !isWritten)
  {
    std::cerr << "Cannot write " << (isWritten ? argv[1] : argv[2]) << ".\n";
    return 1;
  }
}
