#include "BenchTables.h"

#include "BenchText.h"

namespace flatblock::benchmarks
{
namespace
{
using Row = std::vector<std::string>;

std::string Counted(double value, int digits)
{
  return value < 0.0 ? "–" : Fixed(value, digits);
}

std::string GetName(const Record& record)
{
  return record.Knob + " = " + record.Value;
}

bool IsRate(const Record& record)
{
  return record.Knob.rfind("SamplesPerRay", 0) == 0;
}

bool IsSameRow(const Record& a, const Record& b)
{
  return a.Scene == b.Scene && a.Mapper == b.Mapper && a.Knob == b.Knob;
}

const Record* Find(const std::vector<Record>& records, const Record& like, const std::string& value)
{
  const auto found = std::find_if(records.begin(), records.end(),
    [&](const Record& record) { return IsSameRow(record, like) && record.Value == value; });
  return found == records.end() ? nullptr : &*found;
}

Row ToRow(const EqualError& equal)
{
  if (equal.Ours.empty())
  {
    return { equal.Scene, equal.Peer, "none is as close", Fixed(equal.PeerPSNR, 1), "–", "–", "–",
      "–" };
  }
  return { equal.Scene, equal.Peer, equal.Ours, Fixed(equal.PeerPSNR, 1), Fixed(equal.OurPSNR, 1),
    Fixed(equal.Times.First, 1), Fixed(equal.Times.Second, 1), Fixed(equal.GetRatio(), 2) };
}
} // namespace

Block TabulateRecords(const Selected& records)
{
  Block table{ Block::Table, "",
    { { "mapper", "knob = value", "ms", "MiB", "samples a ray", "fetches a ray", "RMSE", "PSNR, dB",
      "SSIM", "largest CIELUV" } } };
  for (const Record* record : records)
  {
    table.Rows.push_back({ record->Mapper, GetName(*record), Fixed(record->Milliseconds, 1),
      Counted(record->Bytes / (1 << 20), 2), Counted(record->SamplesPerRay, 1),
      Counted(record->FetchesPerRay, 1), Significant(record->Error.RootMeanSquare, 3),
      Fixed(record->Error.PeakSignalToNoise, 1), Fixed(record->Error.Similarity, 5),
      Fixed(record->Error.Color, 2) });
  }
  return table;
}

Block TabulateEqualErrors(const std::vector<EqualError>& equal)
{
  Block table{
    Block::Table, "",
    { { "scene", "peer", "ours", "peer, dB", "ours, dB", "peer, ms", "ours, ms", "peer / ours" } }
  };
  for (const EqualError& one : equal)
  {
    table.Rows.push_back(ToRow(one));
  }
  return table;
}

std::string PrintEqualErrors(const std::vector<EqualError>& equal)
{
  const Block table = TabulateEqualErrors(equal);
  std::vector<std::size_t> widths(table.Rows.front().size());
  for (const Row& row : table.Rows)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string text;
  for (const Row& row : table.Rows)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const bool isLast = i + 1 == row.size();
      text += row[i] + (isLast ? "\n" : std::string(widths[i] - row[i].size() + 2, ' '));
    }
  }
  return text;
}

Block TabulateRates(const std::vector<Record>& records)
{
  const Row counts = { "40", "60", "80", "120" };
  Block table{ Block::Table, "", { { "scene", "mapper", "knob" } } };
  table.Rows.front().insert(table.Rows.front().end(), counts.begin(), counts.end());
  const Record* last = nullptr;
  for (const Record& record : records)
  {
    if (!IsRate(record) || (last && IsSameRow(*last, record)))
    {
      continue;
    }
    last = &record;
    Row row = { record.Scene, record.Mapper, record.Knob };
    for (const std::string& count : counts)
    {
      const Record* found = Find(records, record, count);
      row.push_back(found ? Fixed(1000.0 / found->Milliseconds, 1) : "–");
    }
    table.Rows.push_back(row);
  }
  return table;
}

Block TabulateTermination(const std::vector<Record>& records)
{
  Block table{ Block::Table, "", { { "scene", "with, ms", "without, ms", "without / with" } } };
  for (const Record& with : records)
  {
    const bool isDefault = with.Knob == "EarlyTermination" && with.Value == "default";
    const Record* without = isDefault ? Find(records, with, "1") : nullptr;
    if (without)
    {
      table.Rows.push_back({ with.Scene, Fixed(with.Milliseconds, 1),
        Fixed(without->Milliseconds, 1), Fixed(without->Milliseconds / with.Milliseconds, 2) });
    }
  }
  return table;
}

Block TabulateSamples(const std::vector<Record>& records)
{
  Block table{ Block::Table, "",
    { { "scene", "mapper", "knob = value", "samples a ray", "fetches a ray", "ms",
      "ns a sample of a ray a pixel" } } };
  for (const Record& record : records)
  {
    if (record.SamplesPerRay > 0.0)
    {
      const double samples = record.SamplesPerRay * record.Width * record.Width;
      table.Rows.push_back({ record.Scene, record.Mapper, GetName(record),
        Fixed(record.SamplesPerRay, 1), Counted(record.FetchesPerRay, 1),
        Fixed(record.Milliseconds, 1), Fixed(1e6 * record.Milliseconds / samples, 2) });
    }
  }
  return table;
}
} // namespace flatblock::benchmarks
