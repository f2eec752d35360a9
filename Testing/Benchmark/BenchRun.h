/// Measures all points of all scenes that the options leave.
#pragma once

#include "BenchResults.h"
#include "BenchSelection.h"

namespace flatblock::benchmarks
{
Results RunSweeps(const BenchOptions& options, const std::vector<SelectedScene>& scenes);
} // namespace flatblock::benchmarks
