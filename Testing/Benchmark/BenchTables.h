/// Tables of a report.
#pragma once

#include "BenchDocument.h"
#include "BenchFront.h"

namespace flatblock::benchmarks
{
Block TabulateRecords(const Selected& records);
Block TabulateEqualErrors(const std::vector<EqualError>& equal);
/// The same for a terminal, in columns.
std::string PrintEqualErrors(const std::vector<EqualError>& equal);
/// Frames a second by scene and mapper, a column for each number of samples.
Block TabulateRates(const std::vector<Record>& records);
/// Time with early termination, as it is by default, and without.
Block TabulateTermination(const std::vector<Record>& records);
/// What a ray costs beside the time it takes, of mappers that count.
Block TabulateSamples(const std::vector<Record>& records);
} // namespace flatblock::benchmarks
