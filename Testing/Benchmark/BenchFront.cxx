#include "BenchFront.h"

#include <limits>

namespace flatblock::benchmarks
{
Selected SelectScene(const std::vector<Record>& records, const std::string& scene)
{
  Selected some;
  for (const Record& record : records)
  {
    if (record.Scene == scene)
    {
      some.push_back(&record);
    }
  }
  return some;
}

Selected SelectSide(const Selected& records, bool areOurs)
{
  Selected some;
  std::copy_if(records.begin(), records.end(), std::back_inserter(some),
    [areOurs](const Record* record) { return record->IsOurs() == areOurs; });
  return some;
}

Selected GetFront(Selected records)
{
  std::sort(records.begin(), records.end(),
    [](const Record* a, const Record* b) { return a->Milliseconds < b->Milliseconds; });
  Selected front;
  double least = std::numeric_limits<double>::infinity();
  for (const Record* record : records)
  {
    if (record->Error.RootMeanSquare < least)
    {
      least = record->Error.RootMeanSquare;
      front.push_back(record);
    }
  }
  return front;
}

const Record* FindAsClose(const Selected& records, double psnr)
{
  constexpr double Tolerance = 0.5;
  const Record* best = nullptr;
  for (const Record* record : records)
  {
    if (record->IsOurs() && record->Error.PeakSignalToNoise >= psnr - Tolerance &&
        (!best || record->Milliseconds < best->Milliseconds))
    {
      best = record;
    }
  }
  return best;
}
} // namespace flatblock::benchmarks
