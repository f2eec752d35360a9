/// The scenes and their points that the options leave.
#pragma once

#include "BenchPoint.h"
#include "BenchScenes.h"

namespace flatblock::benchmarks
{
struct SelectedScene
{
  BenchScene Scene;
  std::vector<Point> Points;
};

/// @throws std::runtime_error where the filter matches nothing
std::vector<SelectedScene> SelectScenes(const BenchOptions& options);
} // namespace flatblock::benchmarks
