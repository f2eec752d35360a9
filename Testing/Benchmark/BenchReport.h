/// The report of a run.
#pragma once

#include "BenchResults.h"

namespace flatblock::benchmarks
{
/// Plots, report.md and report.html.
/// @throws std::runtime_error that names the file which cannot be written
void WriteReport(const Results& results, const std::string& folder);
} // namespace flatblock::benchmarks
