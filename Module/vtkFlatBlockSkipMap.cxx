#include "vtkFlatBlockSkipMap.h"

#include "Interruption.h"
#include "VariationMap.h"
#include "vtkFlatBlockBuilder.h"
#include "vtkFlatBlockTransferFunction.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkFlatBlockSkipMap);

namespace
{
flatblock::Index3 CountCubes(const flatblock::BlockGrid& grid, int cells)
{
  return flatblock::BlockGrid(grid.GetSamples(), cells + 1).GetBlocks();
}

std::vector<flatblock::SkipMap::Kind> Classify(const std::vector<flatblock::CellRange>& ranges,
  const flatblock::CellScale& scale, const flatblock::TransferTable& table)
{
  using Kind = flatblock::SkipMap::Kind;
  constexpr std::size_t WorthThreads = 100000;
  constexpr Kind Kinds[] = { Kind::Varying, Kind::Transparent, Kind::Constant };
  std::vector<Kind> kinds(ranges.size(), Kind::Transparent);
#pragma omp parallel for if (ranges.size() > WorthThreads)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(ranges.size()); ++i)
  {
    const flatblock::CellRange& range = ranges[i];
    if (!range.IsEmpty())
    {
      const auto kind = table.GetKind(scale.GetValue(range.Lowest), scale.GetValue(range.Highest));
      kinds[i] = Kinds[static_cast<int>(kind)];
    }
  }
  return kinds;
}

// Of what is between samples that overshoots the ranges of those around.
std::vector<flatblock::CellRange> Widen(const flatblock::Index3& cubes,
  const flatblock::Coarsening& coarsening, double overshoot,
  std::vector<flatblock::CellRange> ranges)
{
  flatblock::Coarsen(cubes, coarsening, ranges,
    [](const flatblock::CellRange& a, const flatblock::CellRange& b) -> flatblock::CellRange {
      return { std::min(a.Lowest, b.Lowest), std::max(a.Highest, b.Highest) };
    });
  constexpr double Last = 65535.0;
  for (flatblock::CellRange& range : ranges)
  {
    const double beyond =
      range.IsEmpty() ? 0.0 : std::ceil(overshoot * (range.Highest - range.Lowest));
    range.Lowest = static_cast<std::uint16_t>(std::max(range.Lowest - beyond, 0.0));
    range.Highest = static_cast<std::uint16_t>(std::min(range.Highest + beyond, Last));
  }
  return ranges;
}

std::vector<flatblock::CellRange> GetRanges(vtkFlatBlockBuilder* builder,
  const vtkFlatBlockSkipMap::Settings& settings, const flatblock::Index3& cubes,
  const flatblock::Coarsening& coarsening)
{
  const double overshoot = settings.IsSpline ? builder->GetOvershoot() : 0.0;
  return overshoot > 0.0
           ? Widen(cubes, coarsening, overshoot, builder->GetCellRanges(settings.Cells))
           : builder->GetCellRanges(settings.Cells);
}

// What is transparent in one may be seen in another.
void Combine(
  std::vector<flatblock::SkipMap::Kind>&& kinds, std::vector<flatblock::SkipMap::Kind>& all)
{
  if (all.empty())
  {
    all = std::move(kinds);
    return;
  }
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = all[i] == kinds[i] ? all[i] : flatblock::SkipMap::Kind::Varying;
  }
}
} // namespace

vtkTypeInt64 vtkFlatBlockSkipMap::GetBytes(const flatblock::BlockGrid& grid, int cells)
{
  const flatblock::Index3 size = CountCubes(grid, cells);
  return static_cast<vtkTypeInt64>(size[0]) * size[1] * size[2];
}

int vtkFlatBlockSkipMap::ChooseCells(
  const flatblock::BlockGrid& grid, int fewest, vtkTypeInt64 mostBytes, int largestTexture)
{
  for (int cells = fewest; cells <= grid.GetCellsPerBlock(); cells *= 2)
  {
    const flatblock::Index3 size = CountCubes(grid, cells);
    if (GetBytes(grid, cells) <= mostBytes &&
        *std::max_element(size.begin(), size.end()) <= largestTexture)
    {
      return cells;
    }
  }
  return 0;
}

void vtkFlatBlockSkipMap::Update(const std::vector<Part>& parts,
  const std::vector<std::uint8_t>& visible, vtkMTimeType visibleTime, const Settings& settings)
{
  vtkMTimeType edited = visibleTime;
  for (const Part& part : parts)
  {
    edited = std::max({ edited, part.Builder->GetMTime(), part.Builder->GetShownTime(),
      part.Function->GetMTime() });
  }
  if (edited < this->GetMTime() && this->UsedParts == parts && this->Used == settings)
  {
    return;
  }
  vtkFlatBlockBuilder* builder = parts.front().Builder;
  const int cells = settings.Cells;
  // At the finest level ranges hold what a spline reaches for, but not what it overshoots.
  const bool isCoarse = settings.Coarsest > 0;
  const bool reaches = settings.IsSpline && (isCoarse || builder->GetOvershoot() > 0.0);
  const flatblock::Coarsening coarsening = { std::max(1, (1 << settings.Coarsest) / cells),
    (settings.IsFiltered && isCoarse ? 1 : 0) + (reaches ? 1 : 0) };
  const flatblock::BlockGrid& blocks = builder->GetSource().GetGrid();
  const flatblock::CubeGrid grid = { CountCubes(blocks, cells), blocks.GetBlocks(),
    blocks.GetCellsPerBlock() / cells };
  std::vector<flatblock::SkipMap::Kind> kinds;
  for (const Part& part : parts)
  {
    flatblock::CheckInterruption();
    const auto ranges = GetRanges(part.Builder, settings, grid.Cubes, coarsening);
    Combine(
      Classify(ranges, part.Builder->GetCellScale(), part.Function->GetDecisiveValues()), kinds);
  }
  if (!settings.LeapsMatter)
  {
    std::replace(kinds.begin(), kinds.end(), flatblock::SkipMap::Kind::Constant,
      flatblock::SkipMap::Kind::Varying);
  }
  flatblock::CheckInterruption();
  flatblock::CoarsenKinds(grid.Cubes, coarsening, kinds);
  flatblock::CheckInterruption();
  this->UpdateReach(builder, settings, grid, coarsening);
  flatblock::CheckInterruption();
  this->Map = flatblock::BuildSkipMap(grid, kinds, visible, this->Reach);
  this->Used = settings;
  this->UsedParts = parts;
  this->Modified();
}

// It does not depend on the transfer function.
void vtkFlatBlockSkipMap::UpdateReach(vtkFlatBlockBuilder* builder, const Settings& settings,
  const flatblock::CubeGrid& grid, const flatblock::Coarsening& coarsening)
{
  if (settings.Tolerance <= 0.0)
  {
    this->Reach.clear();
    return;
  }
  const vtkMTimeType edited = std::max(builder->GetMTime(), builder->GetShownTime());
  if (!this->Reach.empty() && edited < this->ReachTime && this->ReachUsed == settings)
  {
    return;
  }
  const std::vector<flatblock::CellRange> cells =
    GetRanges(builder, settings, grid.Cubes, coarsening);
  std::vector<flatblock::CubeRange> ranges(cells.size());
  std::transform(cells.begin(), cells.end(), ranges.begin(),
    [](const flatblock::CellRange& range) -> flatblock::CubeRange {
      return { range.Lowest, range.Highest };
    });
  flatblock::CoarsenRanges(grid.Cubes, coarsening, ranges);
  const double steps = settings.Tolerance / builder->GetCellScale().Step;
  this->Reach = flatblock::MeasureVariation(
    grid, ranges, static_cast<int>(std::min(std::floor(steps), 65535.0)));
  this->ReachUsed = settings;
  this->ReachTime.Modified();
}

void vtkFlatBlockSkipMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cells: " << this->Used.Cells << "\n";
  os << indent << "Tolerance: " << this->Used.Tolerance << "\n";
}
