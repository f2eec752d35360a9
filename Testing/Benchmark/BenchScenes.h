/// The volumes that are drawn, by name.
#pragma once

#include "AccuracyScenes.h"
#include "BenchOptions.h"

#include <functional>

namespace flatblock::benchmarks
{
struct BenchScene
{
  std::string Name;
  std::function<std::unique_ptr<Subject>(const BenchOptions&)> Make; ///< null where it can't
  bool IsQuick = false;
};

/// Nothing is generated before Make().
std::vector<BenchScene> ListScenes(const BenchOptions& options);

/// Sets the window's size and draws the reference; null where the scene's file is not installed.
std::unique_ptr<Subject> PrepareScene(const BenchScene& scene, const BenchOptions& options);

/// Branching tubes of values up to 1000 in 0: n^3 samples of 16 bit, the same for a seed.
vtkSmartPointer<vtkImageData> MakeVesselTree(int n, unsigned int seed);
} // namespace flatblock::benchmarks
