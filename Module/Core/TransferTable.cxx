#include "TransferTable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flatblock
{
TransferTable::TransferTable(double lowest, double highest, std::vector<Entry> entries)
  : Lowest(lowest), Highest(highest), Entries(std::move(entries)),
    VisibleBefore(this->Entries.size() + 1, 0), ChangesBefore(this->Entries.size() + 1, 0)
{
  for (std::size_t i = 0; i < this->Entries.size(); ++i)
  {
    const bool isChange = i > 0 && this->Entries[i] != this->Entries[i - 1];
    this->ChangesBefore[i + 1] = this->ChangesBefore[i] + (isChange ? 1 : 0);
    this->VisibleBefore[i + 1] = this->VisibleBefore[i] + (this->Entries[i][3] > 0.0F ? 1 : 0);
  }
}

double TransferTable::GetPosition(double value) const
{
  const double span = this->Highest - this->Lowest;
  const double last = static_cast<double>(this->Entries.size() - 1);
  if (span > 0.0)
  {
    return (value - this->Lowest) / span * last;
  }
  return value < this->Lowest ? -1.0 : (value > this->Lowest ? last + 1.0 : 0.0);
}

// Those that have a part in the classification of a value in [lowest, highest].
TransferTable::Interval TransferTable::FindEntries(double lowest, double highest) const
{
  // An entry of slack, since the shader reaches its position in single precision.
  const double slack = 1e-5 * static_cast<double>(this->Entries.size());
  const double end = static_cast<double>(this->Entries.size() - 1);
  const double first = std::floor(std::clamp(this->GetPosition(lowest), 0.0, end) - slack);
  const double last = std::ceil(std::clamp(this->GetPosition(highest), 0.0, end) + slack);
  return { static_cast<std::size_t>(std::max(first, 0.0)),
    std::min(static_cast<std::size_t>(std::max(last, 0.0)) + 1, this->Entries.size()) };
}

bool TransferTable::IsTransparent(double lowest, double highest) const
{
  return this->GetKind(lowest, highest) == Kind::Transparent;
}

TransferTable::Kind TransferTable::GetKind(double lowest, double highest) const
{
  if (lowest > highest)
  {
    return Kind::Transparent;
  }
  const Interval entries = this->FindEntries(lowest, highest);
  if (this->VisibleBefore[entries.End] == this->VisibleBefore[entries.Begin])
  {
    return Kind::Transparent;
  }
  return this->ChangesBefore[entries.End] == this->ChangesBefore[entries.Begin + 1] ? Kind::Constant
                                                                                    : Kind::Varying;
}

double GetExtinction(double opacity, double distance)
{
  return opacity > 0.0 ? std::min(-std::log1p(-std::min(opacity, 1.0)) / distance, MostExtinction)
                       : 0.0;
}
} // namespace flatblock
