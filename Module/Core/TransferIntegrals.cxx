#include "TransferIntegrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace flatblock
{
namespace
{
using Entry = TransferTable::Entry;

// Over one interval of the table.
std::array<double, 4> Integrate(const Entry& begin, const Entry& end)
{
  const double from = begin[3];
  const double to = end[3];
  std::array<double, 4> integral;
  for (int c = 0; c < 3; ++c)
  {
    integral[c] = (begin[c] * (2.0 * from + to) + end[c] * (from + 2.0 * to)) / 6.0;
  }
  integral[3] = 0.5 * (from + to);
  return integral;
}

std::array<double, 3> GetSlope(const Entry& begin, const Entry& end)
{
  return { double(end[0]) - begin[0], double(end[1]) - begin[1], double(end[2]) - begin[2] };
}

double GetLargest(const std::array<double, 3>& change)
{
  return std::max({ std::abs(change[0]), std::abs(change[1]), std::abs(change[2]) });
}

void WriteSums(const std::vector<Entry>& entries, Entry* sums, Entry* rests)
{
  std::array<double, 4> sum = { 0.0, 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      sums[i][c] = static_cast<float>(sum[c]);
      rests[i][c] = static_cast<float>(sum[c] - sums[i][c]);
    }
    if (i + 1 < entries.size())
    {
      const std::array<double, 4> integral = Integrate(entries[i], entries[i + 1]);
      std::transform(sum.begin(), sum.end(), integral.begin(), sum.begin(),
        [](double a, double b) { return a + b; });
    }
  }
}

void WriteVariations(const std::vector<Entry>& entries, Entry* variations)
{
  std::array<double, 3> sum = { 0.0, 0.0, 0.0 };
  std::array<double, 3> slopeBefore = { 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const Entry& next = entries[std::min(i + 1, entries.size() - 1)];
    const std::array<double, 3> slope = GetSlope(entries[i], next);
    sum[0] += GetLargest(slope);
    sum[1] += i == 0 ? 0.0
                     : GetLargest({ slope[0] - slopeBefore[0], slope[1] - slopeBefore[1],
                         slope[2] - slopeBefore[2] });
    sum[2] += std::abs(double(next[3]) - entries[i][3]);
    slopeBefore = slope;
    variations[i] = { static_cast<float>(sum[0]), static_cast<float>(sum[1]),
      static_cast<float>(sum[2]), 0.0F };
  }
}
} // namespace

std::vector<TransferTable::Entry> IntegrateTransferTable(const TransferTable& table)
{
  const auto& entries = table.GetEntries();
  const std::size_t count = entries.size();
  std::vector<Entry> rows(TransferRows * count);
  std::copy(entries.begin(), entries.end(), rows.begin());
  WriteSums(entries, &rows[count], &rows[2 * count]);
  WriteVariations(entries, &rows[3 * count]);
  return rows;
}
} // namespace flatblock
