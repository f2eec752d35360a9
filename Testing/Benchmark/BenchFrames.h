/// An interactive session, frame by frame.
#pragma once

#include "BenchSelection.h"

namespace flatblock::benchmarks
{
/// A turn of interactive frames and a still of each scene, as CSV.
/// @throws std::runtime_error where the file cannot be written
void PlayFrames(const BenchOptions& options, const std::vector<SelectedScene>& scenes);
} // namespace flatblock::benchmarks
