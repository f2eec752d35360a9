#include "vtkFlatBlockBuilder.h"

#include "Coarsening.h"
#include "FlatBlockImageBricks.h"
#include "Interruption.h"
#include "QuantizedBricks.h"

#include "vtkDataArray.h"
#include "vtkFlatBlockScalars.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

vtkStandardNewMacro(vtkFlatBlockBuilder);

namespace
{
// Looks only where the ranges say that there are any.
template <typename T>
vtkTypeInt64 CountNonFinite([[maybe_unused]] const T* samples, [[maybe_unused]] vtkIdType count,
  [[maybe_unused]] const std::vector<flatblock::ValueRange>& ranges)
{
  vtkTypeInt64 found = 0;
  if constexpr (std::is_floating_point_v<T>)
  {
    if (std::any_of(ranges.begin(), ranges.end(),
          [](const flatblock::ValueRange& range) { return range.HasHoles; }))
    {
      constexpr vtkIdType PerTurn = 1 << 20;
      flatblock::ParallelLoop loop;
#pragma omp parallel for reduction(+ : found)
      for (vtkIdType first = 0; first < count; first += PerTurn)
      {
        loop.Do(
          [&]
          {
            found += std::count_if(samples + first, samples + std::min(first + PerTurn, count),
              [](T sample) { return !std::isfinite(sample); });
          });
      }
      loop.Finish();
    }
  }
  return found;
}
} // namespace

bool vtkFlatBlockBuilder::Update(vtkFlatBlockScalars* scalars, int blockSize, const Bricks& bricks)
{
  const bool areNewBlocks = !this->AreBlocksCurrent(scalars, blockSize);
  if (!areNewBlocks && this->BuiltBricks == bricks)
  {
    return false;
  }
  this->Quantized.reset();
  this->Source.reset();
  if (areNewBlocks)
  {
    this->BuildBlocks(scalars, blockSize);
  }
  const bool areNewRanges = areNewBlocks || !this->BuiltBricks.HasRangesOf(bricks);
  this->BuiltBricks = bricks;
  if (areNewRanges)
  {
    this->ShownRanges = this->WidenRanges(bricks.MayBeSpline ? 1 : 0, this->GetOvershoot());
    this->CellsPerRange = 0;
    this->ShownTime.Modified();
  }
  switch (this->Scalars->GetDataType())
  {
    vtkTemplateMacro(
      this->BuildSource(static_cast<const VTK_TT*>(this->Scalars->GetVoidPointer(0))));
  }
  if (bricks.Bits > 0 && this->NonFiniteSamples == 0 && !bricks.AreCoefficients)
  {
    this->Quantize();
  }
  return true;
}

bool vtkFlatBlockBuilder::AreBlocksCurrent(vtkFlatBlockScalars* scalars, int blockSize) const
{
  return this->Source && this->BuiltScalars == scalars && this->BuiltTime == scalars->GetMTime() &&
         this->BuiltBlockSize == blockSize;
}

void vtkFlatBlockBuilder::BuildBlocks(vtkFlatBlockScalars* scalars, int blockSize)
{
  this->Grid = flatblock::BlockGrid(scalars->GetSamples(), blockSize);
  this->CellsPerRange = 0;
  this->Cuda.Release();
  this->Scalars = scalars->GetValues();
  switch (this->Scalars->GetDataType())
  {
    vtkTemplateMacro(
      this->BuildRanges(static_cast<const VTK_TT*>(this->Scalars->GetVoidPointer(0))));
  }
  this->BuiltScalars = scalars;
  this->BuiltTime = scalars->GetMTime();
  this->BuiltBlockSize = blockSize;
  this->Modified();
}

template <typename T>
void vtkFlatBlockBuilder::BuildRanges(const T* samples)
{
  const flatblock::BlockGrid& grid = this->Grid;
  this->BlockRanges.assign(static_cast<std::size_t>(grid.GetNumberOfBlocks()), {});
  flatblock::ComputeBlockRanges(samples, grid.GetSamples(), grid.GetCellsPerBlock(),
    grid.GetBlocks(), this->BlockRanges.data());
  this->Range = {};
  for (const flatblock::ValueRange& range : this->BlockRanges)
  {
    this->Range.Lowest = std::min(this->Range.Lowest, range.Lowest);
    this->Range.Highest = std::max(this->Range.Highest, range.Highest);
  }
  if (this->Range.IsEmpty())
  {
    this->Range = { 0.0, 0.0 };
  }
  this->NonFiniteSamples =
    CountNonFinite(samples, this->Scalars->GetNumberOfValues(), this->BlockRanges);
}

bool vtkFlatBlockBuilder::HasIntegers() const
{
  const int type = this->Scalars->GetDataType();
  return type != VTK_FLOAT && type != VTK_DOUBLE && this->Scalars->GetDataTypeSize() <= 2;
}

double vtkFlatBlockBuilder::GetOvershoot() const
{
  // A cubic spline that interpolates values within [-1, 1] stays within [-1.55, 1.55] along a line,
  // so within the cube of that in space.
  constexpr double Most = 1.55 * 1.55 * 1.55;
  return this->BuiltBricks.MayInterpolate && this->NonFiniteSamples == 0 ? 0.5 * (Most - 1.0) : 0.0;
}

// Of blocks with others around, and of what overshoots their samples.
std::vector<flatblock::ValueRange> vtkFlatBlockBuilder::WidenRanges(
  int blocksAround, double overshoot) const
{
  std::vector<flatblock::ValueRange> ranges = this->BlockRanges;
  flatblock::Coarsen(this->Grid.GetBlocks(), { 1, blocksAround }, ranges,
    [](const flatblock::ValueRange& a, const flatblock::ValueRange& b) -> flatblock::ValueRange
    {
      return { std::min(a.Lowest, b.Lowest), std::max(a.Highest, b.Highest),
        a.HasHoles || b.HasHoles };
    });
  for (flatblock::ValueRange& range : ranges)
  {
    const double beyond = range.IsEmpty() ? 0.0 : overshoot * (range.Highest - range.Lowest);
    range.Lowest -= beyond;
    range.Highest += beyond;
  }
  return ranges;
}

template <typename T>
void vtkFlatBlockBuilder::BuildSource(const T* samples)
{
  const flatblock::BlockGrid grid(
    this->Grid.GetSamples(), this->Grid.GetSamplesPerBlock(), this->BuiltBricks.Apron);
  if (this->BuiltBricks.AreCoefficients && this->NonFiniteSamples == 0)
  {
    this->Source = std::make_unique<flatblock::CoefficientBricks<T>>(grid, samples, this->Range);
    return;
  }
  this->Source = std::make_unique<flatblock::ImageBricks<T>>(
    grid, samples, flatblock::MakeEncoding<T>(this->Range), this->BuiltBricks.Filter);
}

// An apron takes samples from a block away, and means those around from another.
std::vector<flatblock::TexelRange> vtkFlatBlockBuilder::GetTexelRanges() const
{
  const flatblock::TexelEncoding& encoding = this->Source->GetEncoding();
  const int around = (this->BuiltBricks.Filter == flatblock::LevelFilter::Tent ? 1 : 0) +
                     (this->BuiltBricks.Apron > 0 ? 1 : 0);
  const std::vector<flatblock::ValueRange> values =
    this->WidenRanges(around, this->BuiltBricks.AreCoefficients ? this->GetOvershoot() : 0.0);
  std::vector<flatblock::TexelRange> ranges(values.size());
  std::transform(values.begin(), values.end(), ranges.begin(),
    [&encoding](const flatblock::ValueRange& range) -> flatblock::TexelRange
    {
      return { static_cast<float>((range.Lowest - encoding.Offset) / encoding.Scale),
        static_cast<float>((range.Highest - range.Lowest) / encoding.Scale) };
    });
  return ranges;
}

void vtkFlatBlockBuilder::Quantize()
{
  this->Quantized = std::make_unique<flatblock::QuantizedBricks>(
    *this->Source, this->GetTexelRanges(), this->BuiltBricks.Bits);
}

const std::vector<flatblock::CellRange>& vtkFlatBlockBuilder::GetCellRanges(int cells)
{
  if (this->CellsPerRange != cells)
  {
    constexpr double Steps = 65535.0;
    const double span = this->Range.Highest - this->Range.Lowest;
    const bool areIntegers = this->Scalars->GetDataType() != VTK_FLOAT &&
                             this->Scalars->GetDataType() != VTK_DOUBLE && span <= Steps;
    this->CellScale = { this->Range.Lowest, areIntegers || span <= 0.0 ? 1.0 : span / Steps };
    this->CellsPerRange = 0; // until all is done
    const flatblock::Index3 count =
      flatblock::BlockGrid(this->Grid.GetSamples(), cells + 1).GetBlocks();
    switch (this->Scalars->GetDataType())
    {
      vtkTemplateMacro(this->BuildCellRanges(
        static_cast<const VTK_TT*>(this->Scalars->GetVoidPointer(0)), cells, count));
    }
    this->CellsPerRange = cells;
  }
  return this->CellRanges;
}

template <typename T>
void vtkFlatBlockBuilder::BuildCellRanges(
  const T* samples, int cells, const flatblock::Index3& count)
{
  this->CellRanges.resize(static_cast<std::size_t>(count[0]) * count[1] * count[2]);
  flatblock::ComputeCellRanges(samples, this->Grid.GetSamples(), cells,
    this->BuiltBricks.MayBeSpline ? 1 : 0, count, this->CellScale, this->CellRanges.data());
}

std::string vtkFlatBlockBuilder::ComputeDistortion(const std::vector<std::int64_t>& blocks,
  int levels, const flatblock::ClassifiedTable& table, int threads, bool useCuda, float* distortion,
  flatblock::BlockSummary* summaries)
{
  std::string problem;
  switch (this->Scalars->GetDataType())
  {
    vtkTemplateMacro(problem = this->ComputeDistortionOf(
                       static_cast<const VTK_TT*>(this->Scalars->GetVoidPointer(0)), blocks, levels,
                       table, threads, useCuda && !summaries, distortion, summaries));
  }
  return problem;
}

template <typename T>
std::string vtkFlatBlockBuilder::ComputeDistortionOf(const T* samples,
  const std::vector<std::int64_t>& blocks, int levels, const flatblock::ClassifiedTable& table,
  int threads, bool useCuda, float* distortion, flatblock::BlockSummary* summaries)
{
  const flatblock::BlockGrid& grid = this->Grid;
  const flatblock::BlockedVolume volume = { grid.GetSamples(), grid.GetBlocks(),
    grid.GetCellsPerBlock() };
  std::string problem;
  if (useCuda)
  {
    problem = this->Cuda.Compute(samples, volume, blocks, levels, table, distortion);
  }
  if (!useCuda || !problem.empty())
  {
    flatblock::ComputeDistortion(
      samples, volume, blocks, levels, table, threads, distortion, summaries);
  }
  return problem;
}

void vtkFlatBlockBuilder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BlockSize: " << this->BuiltBlockSize << "\n";
  os << indent << "NumberOfBlocks: " << this->BlockRanges.size() << "\n";
  os << indent << "Range: " << this->Range.Lowest << " " << this->Range.Highest << "\n";
}
