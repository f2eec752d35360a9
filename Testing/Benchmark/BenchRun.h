/// Measures all points of all scenes that the options leave.
#pragma once

#include "BenchResults.h"
#include "BenchSelection.h"

namespace flatblock::benchmarks
{
/// Calls `keep` after each scene, so that a run that is cut off leaves something.
Results RunSweeps(const BenchOptions& options, const std::vector<SelectedScene>& scenes,
  const std::function<void(const Results&)>& keep);
} // namespace flatblock::benchmarks
