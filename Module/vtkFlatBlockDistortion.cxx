#include "vtkFlatBlockDistortion.h"

#include "vtkFlatBlockBuilder.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <limits>
#include <utility>

vtkStandardNewMacro(vtkFlatBlockDistortion);

void vtkFlatBlockDistortion::StartAnew(vtkFlatBlockBuilder* builder, int levels, bool summarize)
{
  const std::size_t blocks = builder->GetBlockRanges().size();
  this->Levels = levels;
  this->Summarizes = summarize;
  this->Summaries.clear();
  this->Summaries.resize(summarize ? blocks : 0);
  this->Values.assign(blocks * levels, 0.0F);
  this->Bounds.assign(blocks, 0.0F);
  this->HasValue.assign(blocks, 0);
  this->IsWaiting.assign(blocks, 0);
}

void vtkFlatBlockDistortion::SetTable(vtkFlatBlockBuilder* builder,
  const flatblock::ClassifiedTable& table, vtkMTimeType tableTime, int levels, bool summarize,
  bool usesCuda)
{
  const bool isNew = this->BuilderTime != builder->GetMTime() || this->Levels != levels ||
                     this->Summarizes != summarize || this->UsesCuda != usesCuda;
  if (!isNew && this->TableTime == tableTime)
  {
    return;
  }
  this->BuilderTime = 0; // until all is done
  this->UsesCuda = usesCuda;
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> changed = { -Infinity, Infinity };
  if (isNew)
  {
    this->StartAnew(builder, levels, summarize);
  }
  else
  {
    changed = flatblock::FindDifference(this->Table, table);
  }
  this->Table = table;
  if (changed.first <= changed.second)
  {
    this->FindWaiting(builder, changed);
    this->Modified();
  }
  this->BuilderTime = builder->GetMTime();
  this->TableTime = tableTime;
}

void vtkFlatBlockDistortion::FindWaiting(
  vtkFlatBlockBuilder* builder, const std::pair<double, double>& changed)
{
  constexpr float Typical = 0.25F; // of the bound, where nothing better is known
  const auto& ranges = builder->GetBlockRanges();
  for (std::size_t block = 0; block < ranges.size(); ++block)
  {
    const flatblock::ValueRange& range = ranges[block];
    if (range.Highest < changed.first || range.Lowest > changed.second)
    {
      continue;
    }
    float* values = &this->Values[block * this->Levels];
    const bool isConstant = this->Table.IsConstant(range.Lowest, range.Highest);
    this->Bounds[block] =
      isConstant ? 0.0F : this->Table.GetLargestDifference(range.Lowest, range.Highest);
    this->IsWaiting[block] = isConstant ? 0 : 1;
    if (isConstant)
    {
      std::fill_n(values, this->Levels, 0.0F);
      this->HasValue[block] = 1;
    }
    if (!isConstant && this->Summarizes && this->Summaries[block].IsSet())
    {
      this->Estimate(block);
      this->IsWaiting[block] = 0;
      continue;
    }
    const float guess = Typical * this->Bounds[block];
    for (int level = 0; !isConstant && level < this->Levels; ++level)
    {
      const bool isKnown = this->HasValue[block] && values[level] > 0.0F;
      values[level] = isKnown ? std::min(values[level], this->Bounds[block]) : guess;
    }
  }
  this->Waiting.clear();
  for (std::size_t block = 0; block < ranges.size(); ++block)
  {
    if (this->IsWaiting[block])
    {
      this->Waiting.push_back(static_cast<vtkTypeInt64>(block));
    }
  }
  std::stable_sort(this->Waiting.begin(), this->Waiting.end(),
    [this](vtkTypeInt64 a, vtkTypeInt64 b) { return this->Bounds[a] < this->Bounds[b]; });
}

std::string vtkFlatBlockDistortion::Compute(
  vtkFlatBlockBuilder* builder, vtkTypeInt64 blocks, int threads, bool useCuda)
{
  const auto waiting = static_cast<vtkTypeInt64>(this->Waiting.size());
  const vtkTypeInt64 count = std::min(blocks, waiting);
  if (count <= 0)
  {
    return {};
  }
  std::vector<std::int64_t> slice(this->Waiting.end() - count, this->Waiting.end());
  std::sort(slice.begin(), slice.end()); // as they lie in memory
  std::vector<float> values(slice.size() * this->Levels);
  std::vector<flatblock::BlockSummary> summaries(this->Summarizes ? slice.size() : 0);
  std::string problem = builder->ComputeDistortion(slice, this->Levels, this->Table, threads,
    useCuda, values.data(), this->Summarizes ? summaries.data() : nullptr);
  for (std::size_t i = 0; i < slice.size(); ++i)
  {
    const auto block = static_cast<std::size_t>(slice[i]);
    if (this->Summarizes)
    {
      this->Summaries[block] = std::move(summaries[i]);
      this->Estimate(block); // not the exact value: it would not outlast the next edit
    }
    else
    {
      std::copy_n(&values[i * this->Levels], this->Levels, &this->Values[block * this->Levels]);
    }
    this->HasValue[block] = 1;
    this->IsWaiting[block] = 0;
  }
  this->Waiting.resize(static_cast<std::size_t>(waiting - count));
  this->Modified();
  return problem;
}

void vtkFlatBlockDistortion::Estimate(std::size_t block)
{
  std::vector<float> bounds(this->Levels);
  this->Summaries[block].Estimate(this->Table, &this->Values[block * this->Levels], bounds.data());
}

vtkTypeInt64 vtkFlatBlockDistortion::GetSummaryBytes() const
{
  vtkTypeInt64 bytes = 0;
  for (const flatblock::BlockSummary& summary : this->Summaries)
  {
    bytes += static_cast<vtkTypeInt64>(sizeof(summary) + summary.GetBytes());
  }
  return bytes;
}

float vtkFlatBlockDistortion::GetValue(std::size_t block, int level) const
{
  return level < 1 ? 0.0F : this->Values[block * this->Levels + std::min(level, this->Levels) - 1];
}

void vtkFlatBlockDistortion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Waiting: " << this->Waiting.size() << "\n";
}
