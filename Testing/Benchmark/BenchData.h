/// Records as data that other programs read.
#pragma once

#include "BenchResults.h"

namespace flatblock::benchmarks
{
/// results.json and results.csv.
/// @throws std::runtime_error that names the file which cannot be written
void WriteData(const Results& results, const std::string& folder);
} // namespace flatblock::benchmarks
