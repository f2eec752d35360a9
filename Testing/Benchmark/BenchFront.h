/// Choices among records: by scene, by who drew, by what no other beats.
#pragma once

#include "BenchResults.h"

namespace flatblock::benchmarks
{
using Selected = std::vector<const Record*>;

Selected SelectScene(const std::vector<Record>& records, const std::string& scene);
Selected SelectSide(const Selected& records, bool areOurs);

/// Those that no other of them beats in both time and error, fastest first.
Selected GetFront(Selected records);

/// The fastest of ours whose PSNR is at most half a decibel below; null where there is none.
const Record* FindAsClose(const Selected& records, double psnr);
} // namespace flatblock::benchmarks
