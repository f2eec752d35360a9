// Sweeps the mapper's knobs and those of VTK's own mappers, and reports time, memory and error.
// Needs a display.
#include "BenchData.h"
#include "BenchFrames.h"
#include "BenchReport.h"
#include "BenchRun.h"
#include "BenchTables.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

using namespace flatblock::benchmarks;

namespace
{
// Before anything is measured.
void PrepareFolder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::string file = folder + "/results.json";
  if (error || !std::ofstream(file).good())
  {
    throw std::runtime_error("--output: cannot write to '" + folder + "'.");
  }
}

void PrintPoints(const std::vector<SelectedScene>& scenes)
{
  for (const SelectedScene& scene : scenes)
  {
    for (const Point& point : scene.Points)
    {
      std::cout << scene.Scene.Name << "/" << point.GetName() << "\n";
    }
  }
}

void Sweep(const BenchOptions& options, const std::vector<SelectedScene>& scenes)
{
  PrepareFolder(options.Output);
  const Results results =
    RunSweeps(options, scenes, [&](const Results& some) { WriteData(some, options.Output); });
  WriteData(results, options.Output);
  WriteReport(results, options.Output);
  if (!results.Equal.empty())
  {
    std::cout << PrintEqualErrors(results.Equal) << "\n";
  }
  std::cout << options.Output << "/report.html\n";
}

void Run(const BenchOptions& options)
{
  if (options.IsHelp)
  {
    std::cout << BenchUsage;
    return;
  }
  const auto scenes = SelectScenes(options);
  if (options.IsList)
  {
    PrintPoints(scenes);
  }
  else if (!options.Frames.empty())
  {
    PlayFrames(options, scenes);
  }
  else
  {
    Sweep(options, scenes);
  }
}
} // namespace

int main(int argc, char** argv)
{
  try
  {
    Run(ParseBenchOptions(argc, argv));
  }
  catch (const std::exception& error)
  {
    std::cerr << "flatblock-bench: " << error.what() << "\n";
    return 1;
  }
}
