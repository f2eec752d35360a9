#include "Blending.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flatblock
{
namespace
{
using Entries = std::vector<TransferTable::Entry>;

void Show(Entries& entries, double first, double last)
{
  const auto end = static_cast<double>(entries.size()) - 1.0;
  if (first > end || last < 0.0 || !(first <= last))
  {
    return;
  }
  for (auto i = static_cast<std::size_t>(std::max(first, 0.0));
       i <= static_cast<std::size_t>(std::min(last, end)); ++i)
  {
    entries[i][3] = 1.0F;
  }
}

// From the first one on that is not transparent.
template <typename Iterator>
void ShowBeyond(Iterator begin, Iterator end)
{
  const auto first =
    std::find_if(begin, end, [](const TransferTable::Entry& entry) { return entry[3] > 0.0F; });
  std::for_each(first, end, [](TransferTable::Entry& entry) { entry[3] = 1.0F; });
}
} // namespace

TransferTable GetDecisiveValues(const TransferTable& table, const Blending& blending)
{
  Entries entries = table.GetEntries();
  switch (blending.Mode)
  {
  case BlendMode::Maximum:
    ShowBeyond(entries.begin(), entries.end());
    break;
  case BlendMode::Minimum:
    ShowBeyond(entries.rbegin(), entries.rend());
    break;
  case BlendMode::Average:
  case BlendMode::Isosurface:
    for (TransferTable::Entry& entry : entries)
    {
      entry[3] = 0.0F;
    }
    Show(entries, std::floor(table.GetPosition(blending.AverageRange[0])),
      blending.Mode == BlendMode::Average ? std::ceil(table.GetPosition(blending.AverageRange[1]))
                                          : -1.0);
    for (const double value : blending.IsoValues)
    {
      const double position = table.GetPosition(value);
      Show(entries, std::ceil(position) - 1.0, std::floor(position) + 1.0);
    }
    break;
  default:
    break;
  }
  return TransferTable(table.GetLowest(), table.GetHighest(), std::move(entries));
}
} // namespace flatblock
