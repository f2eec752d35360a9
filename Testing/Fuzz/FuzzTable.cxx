// Tables of any entries, asked about any interval: what is called transparent is so wherever one
// looks.
#include "FuzzBytes.h"
#include "TransferTable.h"

#include <algorithm>
#include <cmath>

using namespace flatblock;

namespace
{
double GetExtinctionAt(const TransferTable& table, double value)
{
  const auto last = static_cast<double>(table.GetEntries().size() - 1);
  const double position = std::clamp(table.GetPosition(value), 0.0, last);
  const auto first = static_cast<std::size_t>(std::fmin(std::floor(position), last - 1.0));
  const double share = position - static_cast<double>(first);
  return (1.0 - share) * table.GetEntries()[first][3] + share * table.GetEntries()[first + 1][3];
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
  FuzzBytes numbers(bytes, count);
  const double lowest = numbers.Take<float>();
  const double highest = numbers.Take<float>();
  const double low = numbers.Take<float>();
  const double high = numbers.Take<float>();
  if (!std::isfinite(lowest) || !std::isfinite(highest) || lowest > highest || std::isnan(low) ||
      std::isnan(high))
  {
    return 0;
  }
  std::vector<TransferTable::Entry> entries(2 + static_cast<std::size_t>(numbers.TakeUpTo(30)));
  for (auto& entry : entries)
  {
    const float shade = numbers.Take<std::uint8_t>() / 255.0F;
    entry = { shade, shade, shade, static_cast<float>(numbers.TakeUpTo(2)) };
  }
  const TransferTable table(lowest, highest, entries);
  const auto kind = table.GetKind(low, high);
  const bool isTransparent = table.IsTransparent(low, high);
  Require(isTransparent == (kind == TransferTable::Kind::Transparent));
  for (int i = 0; i <= 16 && low <= high && std::isfinite(low) && std::isfinite(high); ++i)
  {
    const double value = std::min(low + (high - low) * i / 16.0, high);
    Require(!isTransparent || GetExtinctionAt(table, value) == 0.0);
  }
  Require(GetExtinction(numbers.Take<std::uint8_t>() / 255.0, 1.0) <= MostExtinction);
  return 0;
}
