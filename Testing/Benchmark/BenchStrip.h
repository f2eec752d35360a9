/// The pictures of some records side by side, with their names and numbers.
#pragma once

#include "BenchFront.h"

namespace flatblock::benchmarks
{
/// @throws std::runtime_error where the file cannot be written
void DrawStrip(const Selected& records, const std::string& file);
} // namespace flatblock::benchmarks
