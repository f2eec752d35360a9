#include "vtkFlatBlockBuilder.h"

#include "QuantizedBricks.h"

#include "BrickBorder.h"
#include "BrickCopy.h"
#include "BrickFilter.h"

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
// What a sample becomes in the atlas: exact where the type fits a texture, float elsewhere.
template <typename T>
using TexelOf = std::conditional_t<!std::is_integral_v<T> || (sizeof(T) > 2), float,
  std::conditional_t<sizeof(T) == 1, std::uint8_t, std::uint16_t>>;

template <typename T>
flatblock::TexelEncoding MakeEncoding(const flatblock::ValueRange& range)
{
  using Texel = TexelOf<T>;
  if constexpr (std::is_same_v<Texel, float>)
  {
    const double span = range.Highest - range.Lowest;
    return { flatblock::TexelFormat::Float32, range.Lowest, span > 0.0 ? span : 1.0 };
  }
  else
  {
    const auto format =
      sizeof(T) == 1 ? flatblock::TexelFormat::Unsigned8 : flatblock::TexelFormat::Unsigned16;
    return { format, range.Lowest, static_cast<double>(std::numeric_limits<Texel>::max()) };
  }
}

template <typename T>
class ImageBrickSource : public flatblock::BrickSource
{
public:
  ImageBrickSource(const flatblock::BlockGrid& grid, const T* samples,
    const flatblock::TexelEncoding& encoding, flatblock::LevelFilter filter)
    : Grid(grid), Samples(samples), Encoding(encoding), Filter(filter)
  {
  }

  const flatblock::BlockGrid& GetGrid() const override { return this->Grid; }
  const flatblock::TexelEncoding& GetEncoding() const override { return this->Encoding; }
  flatblock::Continuity GetContinuity() const override
  {
    return this->Filter == flatblock::LevelFilter::Subsample ? flatblock::Continuity::Nested
                                                             : flatblock::Continuity::Filtered;
  }

  void ReadBrick(std::int64_t block, int level, const flatblock::BlockBorder& border,
    void* texels) const override
  {
    auto* brick = static_cast<Texel*>(texels);
    flatblock::BrickBorder<Texel> brickBorder(
      brick, this->Grid.GetBrickSide(level), this->Grid.GetApron());
    if (this->Filter == flatblock::LevelFilter::Subsample)
    {
      flatblock::CopyBrick(this->Samples, this->Grid.GetSamples(), this->GetFirst(block, level),
        this->Grid.GetTexelSide(level), 1 << level, this->GetEncoder(), brick);
    }
    else
    {
      flatblock::BrickFilter<T, Texel> filter(
        this->Samples, this->Grid.GetSamples(), this->GetEncoder());
      filter.Read(this->GetFirst(block, level), this->Grid.GetTexelSide(level), 1 << level, brick);
      this->CopyCoarserBorder(block, level, border, filter, brickBorder);
    }
    brickBorder.Coarsen(border);
  }

private:
  using Texel = TexelOf<T>;

  flatblock::TexelEncoder<T, Texel> GetEncoder() const
  {
    return flatblock::TexelEncoder<T, Texel>(this->Encoding.Offset, this->Encoding.Scale);
  }

  // The first texel of its apron, as a sample of the volume.
  flatblock::Index3 GetFirst(std::int64_t block, int level) const
  {
    flatblock::Index3 first = this->Grid.GetFirstSample(block);
    std::for_each(first.begin(), first.end(),
      [before = this->Grid.GetApron() << level](int& sample) { sample -= before; });
    return first;
  }

  void CopyCoarserBorder(std::int64_t block, int level, const flatblock::BlockBorder& border,
    flatblock::BrickFilter<T, Texel>& filter, flatblock::BrickBorder<Texel>& brick) const
  {
    std::vector<Texel> coarse;
    for (int coarser = 1; level + coarser < this->Grid.GetNumberOfLevels(); ++coarser)
    {
      if (std::find(border.begin(), border.end(), coarser) != border.end())
      {
        const int coarseSide = this->Grid.GetBrickSide(level + coarser);
        coarse.resize(static_cast<std::size_t>(coarseSide) * coarseSide * coarseSide);
        filter.Read(
          this->Grid.GetFirstSample(block), coarseSide, 1 << (level + coarser), coarse.data());
        brick.CopyCoarser(border, coarser, coarse.data());
      }
    }
  }

  flatblock::BlockGrid Grid;
  const T* Samples;
  flatblock::TexelEncoding Encoding;
  flatblock::LevelFilter Filter;
};

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
#pragma omp parallel for reduction(+ : found)
      for (vtkIdType i = 0; i < count; ++i)
      {
        found += std::isfinite(samples[i]) ? 0 : 1;
      }
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
  this->BuiltBricks = bricks;
  switch (this->Scalars->GetDataType())
  {
    vtkTemplateMacro(
      this->BuildSource(static_cast<const VTK_TT*>(this->Scalars->GetVoidPointer(0))));
  }
  if (bricks.Bits > 0 && this->NonFiniteSamples == 0)
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

template <typename T>
void vtkFlatBlockBuilder::BuildSource(const T* samples)
{
  const flatblock::BlockGrid grid(
    this->Grid.GetSamples(), this->Grid.GetSamplesPerBlock(), this->BuiltBricks.Apron);
  this->Source = std::make_unique<ImageBrickSource<T>>(
    grid, samples, MakeEncoding<T>(this->Range), this->BuiltBricks.Filter);
}

// What a filter and an apron take from around a block is of its neighbours' ranges.
std::vector<flatblock::TexelRange> vtkFlatBlockBuilder::GetTexelRanges() const
{
  const flatblock::TexelEncoding& encoding = this->Source->GetEncoding();
  std::vector<flatblock::TexelRange> ranges(this->BlockRanges.size());
  std::transform(this->BlockRanges.begin(), this->BlockRanges.end(), ranges.begin(),
    [&encoding](const flatblock::ValueRange& range) -> flatblock::TexelRange
    {
      return { static_cast<float>((range.Lowest - encoding.Offset) / encoding.Scale),
        static_cast<float>((range.Highest - range.Lowest) / encoding.Scale) };
    });
  const bool isWidened =
    this->BuiltBricks.Filter == flatblock::LevelFilter::Tent || this->BuiltBricks.Apron > 0;
  return isWidened ? flatblock::WidenRanges(this->Grid.GetBlocks(), ranges) : ranges;
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
    this->CellsPerRange = cells;
    const flatblock::Index3 count =
      flatblock::BlockGrid(this->Grid.GetSamples(), cells + 1).GetBlocks();
    switch (this->Scalars->GetDataType())
    {
      vtkTemplateMacro(
        this->BuildCellRanges(static_cast<const VTK_TT*>(this->Scalars->GetVoidPointer(0)), count));
    }
  }
  return this->CellRanges;
}

template <typename T>
void vtkFlatBlockBuilder::BuildCellRanges(const T* samples, const flatblock::Index3& count)
{
  this->CellRanges.resize(static_cast<std::size_t>(count[0]) * count[1] * count[2]);
  flatblock::ComputeCellRanges(samples, this->Grid.GetSamples(), this->CellsPerRange, count,
    this->CellScale, this->CellRanges.data());
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
