#include "TransferIntegrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

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

template <typename Numbers>
std::array<double, 4> GetChange(const Numbers& from, const Numbers& to)
{
  return { double(to[0]) - from[0], double(to[1]) - from[1], double(to[2]) - from[2],
    double(to[3]) - from[3] };
}

double GetLargestOfColor(const std::array<double, 4>& change)
{
  return std::max({ std::abs(change[0]), std::abs(change[1]), std::abs(change[2]) });
}

void WriteSums(const std::vector<Entry>& entries, Entry* texels)
{
  std::array<double, 4> sum = { 0.0, 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    Entry& rounded = texels[i * TransferTexels + 1];
    Entry& rest = texels[i * TransferTexels + 2];
    for (int c = 0; c < 4; ++c)
    {
      rounded[c] = static_cast<float>(sum[c]);
      rest[c] = static_cast<float>(sum[c] - rounded[c]);
    }
    if (i + 1 < entries.size())
    {
      const std::array<double, 4> integral = Integrate(entries[i], entries[i + 1]);
      std::transform(sum.begin(), sum.end(), integral.begin(), sum.begin(), std::plus<double>());
    }
  }
}

void WriteVariations(const std::vector<Entry>& entries, Entry* texels)
{
  double colorBends = 0.0;
  double extinctionBends = 0.0;
  double colorChanges = 0.0;
  std::array<double, 4> before = { 0.0, 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const std::array<double, 4> slope =
      GetChange(entries[i], entries[std::min(i + 1, entries.size() - 1)]);
    if (i > 0)
    {
      const std::array<double, 4> bend = GetChange(before, slope);
      colorBends += GetLargestOfColor(bend);
      extinctionBends += std::abs(bend[3]);
    }
    const double changesBefore = colorChanges;
    colorChanges += GetLargestOfColor(slope);
    before = slope;
    texels[i * TransferTexels + 3] = { static_cast<float>(colorBends),
      static_cast<float>(extinctionBends), static_cast<float>(colorChanges),
      static_cast<float>(changesBefore) };
  }
}

} // namespace

std::vector<TransferTable::Entry> IntegrateTransferTable(const TransferTable& table)
{
  const auto& entries = table.GetEntries();
  std::vector<Entry> texels(TransferTexels * entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    texels[i * TransferTexels] = entries[i];
  }
  WriteSums(entries, texels.data());
  WriteVariations(entries, texels.data());
  return texels;
}
} // namespace flatblock
