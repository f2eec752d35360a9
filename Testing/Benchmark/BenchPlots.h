/// What is plotted of a scene's records.
#pragma once

#include "BenchFront.h"

namespace flatblock::benchmarks
{
/// Names of files in the folder.
struct ScenePlots
{
  std::string ErrorByTime;
  std::string ErrorByMemory; ///< empty where no mapper says its memory
  std::string Strip;
};

/// @throws std::runtime_error where a file cannot be written
ScenePlots DrawPlots(const std::string& scene, const Selected& records, const std::string& folder);
} // namespace flatblock::benchmarks
