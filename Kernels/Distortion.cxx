#include "Distortion.h"

#include "Interruption.h"
#include "LevelInterpolator.h"
#include "SampleTypes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace flatblock
{
namespace
{
// Positions in the table are exact integers for these types.
template <typename T>
constexpr bool HasIntegerPositions = std::is_integral_v<T> && sizeof(T) <= 2;

// The positions of a row in the table, and what they add to the sums.
struct RowPositions
{
  explicit RowPositions(int samples) : Nearest(samples), Next(samples), Share(samples) {}

  void Set(int i, const TablePosition& position)
  {
    this->Nearest[i] = position.Nearest;
    this->Next[i] = position.Next;
    this->Share[i] = position.Share;
  }

  std::vector<std::int32_t> Nearest;
  std::vector<std::int32_t> Next;
  std::vector<float> Share;
};

// Floats are exact enough for so many terms; then they go into a double.
constexpr int TermsPerSum = 16;

template <typename T>
class BlockDistortion
{
public:
  BlockDistortion(
    const T* samples, const BlockedVolume& volume, int levels, const ClassifiedTable& table)
    : Samples(samples), Volume(volume), Table(table), Fine(volume.Cells + 1),
      FineReal(volume.Cells + 1), Coarse(volume.Cells + 1), Values(volume.Cells + 1),
      CoarseReal(volume.Cells + 1), IsFinite(volume.Cells + 1, 1)
  {
    if constexpr (HasIntegerPositions<T>)
    {
      this->Lowest = static_cast<std::int32_t>(table.GetLowest());
      this->Last = static_cast<std::int32_t>(table.GetColors().size()) - 1;
    }
    // An entry after the last position, which has no share there.
    this->Colors = table.GetColors();
    this->Colors.push_back(this->Colors.back());
    for (int level = 1; level <= levels; ++level)
    {
      const bool isExact = HasIntegerPositions<T> && 3 * level <= MostShift;
      this->Exact.push_back(
        isExact ? std::make_unique<LevelInterpolator<std::int32_t>>(level, volume.Cells) : nullptr);
      this->Real.push_back(
        isExact ? nullptr : std::make_unique<LevelInterpolator<double>>(level, volume.Cells));
    }
  }

  // Samples that are not finite.
  std::int64_t Compute(std::int64_t block, float* distortion, BlockSummary* summary)
  {
    const auto levels = this->Exact.size();
    this->FindBox(block);
    this->Counts.clear();
    if (summary)
    {
      this->FindRange();
      this->Counts.resize(levels * PairsOfBins, 0);
    }
    for (std::size_t l = 0; l < levels; ++l)
    {
      this->Exact[l] ? this->ReadLattice(*this->Exact[l]) : this->ReadLattice(*this->Real[l]);
    }
    this->Sums.assign(levels, 0.0);
    std::int64_t finite = 0;
    for (int z = 0; z < this->Count[2]; ++z)
    {
      for (std::size_t l = 0; l < levels; ++l)
      {
        this->Exact[l] ? this->Exact[l]->SetPlane(z) : this->Real[l]->SetPlane(z);
      }
      for (int y = 0; y < this->Count[1]; ++y)
      {
        finite += this->ReadFineRow(y, z);
        for (std::size_t l = 0; l < levels; ++l)
        {
          this->Sums[l] +=
            this->Exact[l] ? this->AddRow(*this->Exact[l], y) : this->AddRow(*this->Real[l], y);
          if (summary)
          {
            this->CountRow(&this->Counts[l * PairsOfBins]);
          }
        }
      }
    }
    if (summary)
    {
      summary->Set(this->RangeFirst, this->RangeFirst + this->RangeSize - 1, this->Counts);
    }
    for (std::size_t l = 0; l < levels; ++l)
    {
      const double mean = finite > 0 ? this->Sums[l] / static_cast<double>(finite) : 0.0;
      distortion[l] = static_cast<float>(std::sqrt(mean));
    }
    return std::int64_t(this->Count[0]) * this->Count[1] * this->Count[2] - finite;
  }

private:
  static constexpr int MostShift = 13; // 16 bit and this fit a std::int32_t

  void FindBox(std::int64_t block)
  {
    const auto& blocks = this->Volume.Blocks;
    const std::int64_t row = block / blocks[0];
    const int position[3] = { static_cast<int>(block % blocks[0]),
      static_cast<int>(row % blocks[1]), static_cast<int>(row / blocks[1]) };
    for (int axis = 0; axis < 3; ++axis)
    {
      this->First[axis] = position[axis] * this->Volume.Cells;
      this->Count[axis] =
        std::min(this->Volume.Cells + 1, this->Volume.Samples[axis] - this->First[axis]);
    }
  }

  // Row y, z of the block, or the last one of the volume.
  const T* GetRow(int y, int z) const
  {
    const auto& dims = this->Volume.Samples;
    const std::ptrdiff_t j = std::min(this->First[1] + y, dims[1] - 1);
    const std::ptrdiff_t k = std::min(this->First[2] + z, dims[2] - 1);
    return this->Samples + (k * dims[1] + j) * dims[0] + this->First[0];
  }

  std::int32_t ToPosition(T value, std::int32_t) const
  {
    return std::clamp(static_cast<std::int32_t>(value) - this->Lowest, 0, this->Last);
  }

  // NaN and infinities as the lowest or highest value; nothing is drawn around them.
  double ToPosition(T value, double) const
  {
    return this->Table.GetPosition(static_cast<double>(value));
  }

  template <typename Number>
  void ReadLattice(LevelInterpolator<Number>& level)
  {
    Number* out = level.GetLattice();
    const int last = this->Count[0] - 1;
    for (int k = 0; k < level.GetSide(); ++k)
    {
      for (int j = 0; j < level.GetSide(); ++j)
      {
        const T* row = this->GetRow(j * level.GetStride(), k * level.GetStride());
        for (int i = 0; i < level.GetSide(); ++i)
        {
          *out++ = this->ToPosition(row[std::min(i * level.GetStride(), last)], Number());
        }
      }
    }
  }

  std::int64_t ReadFineRow(int y, int z)
  {
    const T* row = this->GetRow(y, z);
    std::int64_t finite = this->Count[0];
    for (int x = 0; x < this->Count[0]; ++x)
    {
      if constexpr (HasIntegerPositions<T>)
      {
        this->Fine[x] = this->ToPosition(row[x], std::int32_t());
      }
      else
      {
        this->FineReal[x] = this->ToPosition(row[x], 0.0);
        this->Fine[x] = ToTablePosition(this->FineReal[x]).Nearest;
        if constexpr (std::is_floating_point_v<T>)
        {
          this->IsFinite[x] = std::isfinite(row[x]) ? 1 : 0;
          finite -= 1 - this->IsFinite[x];
        }
      }
    }
    return finite;
  }

  double AddRow(LevelInterpolator<std::int32_t>& level, int y)
  {
    const int count = this->Count[0];
    level.SetRow(y);
    level.GetRow(count, this->Values.data());
    const int shift = level.GetShift();
    for (int x = 0; x < count; ++x)
    {
      this->Coarse.Set(x, ToTablePosition(this->Values[x], shift));
    }
    return this->AddRow();
  }

  double AddRow(LevelInterpolator<double>& level, int y)
  {
    const int count = this->Count[0];
    level.SetRow(y);
    level.GetRow(count, this->CoarseReal.data());
    const double unit = std::ldexp(1.0, -level.GetShift());
    for (int x = 0; x < count; ++x)
    {
      this->CoarseReal[x] *= unit;
      this->Coarse.Set(x, ToTablePosition(this->CoarseReal[x]));
    }
    return this->AddRow();
  }

  double AddRow() const
  {
    double sum = 0.0;
    for (int begin = 0; begin < this->Count[0]; begin += TermsPerSum)
    {
      const int end = std::min(begin + TermsPerSum, this->Count[0]);
      ClassifiedColor squares = {};
      for (int x = begin; x < end; ++x)
      {
        squares = squares + this->GetSquare(x);
      }
      sum += (double(squares[0]) + squares[1]) + (double(squares[2]) + squares[3]);
    }
    return sum;
  }

  ClassifiedColor GetSquare(int x) const
  {
    const ClassifiedColor* colors = this->Colors.data();
    const RowPositions& coarse = this->Coarse;
    if constexpr (HasIntegerPositions<T>)
    {
      return GetSquaredDifference(
        colors[this->Fine[x]], colors[coarse.Nearest[x]], colors[coarse.Next[x]], coarse.Share[x]);
    }
    else
    {
      return this->IsFinite[x]
               ? GetSquaredDifference(colors, this->FineReal[x], this->CoarseReal[x])
               : ClassifiedColor{};
    }
  }

  // Of the nearest entries of all samples, and so of all that is interpolated between them.
  void FindRange()
  {
    std::int32_t lowest = std::numeric_limits<std::int32_t>::max();
    std::int32_t highest = 0;
    for (int z = 0; z < this->Count[2]; ++z)
    {
      for (int y = 0; y < this->Count[1]; ++y)
      {
        this->ReadFineRow(y, z);
        for (int x = 0; x < this->Count[0]; ++x)
        {
          lowest = std::min(lowest, this->Fine[x]);
          highest = std::max(highest, this->Fine[x]);
        }
      }
    }
    this->RangeFirst = lowest;
    this->RangeSize = highest - lowest + 1;
  }

  int GetBin(std::int32_t entry) const
  {
    return (entry - this->RangeFirst) * BlockSummary::Bins / this->RangeSize;
  }

  void CountRow(std::uint32_t* counts) const
  {
    for (int x = 0; x < this->Count[0]; ++x)
    {
      counts[this->GetBin(this->Fine[x]) * BlockSummary::Bins +
             this->GetBin(this->Coarse.Nearest[x])] += this->IsFinite[x];
    }
  }

  static constexpr std::size_t PairsOfBins = BlockSummary::Bins * BlockSummary::Bins;

  const T* Samples;
  const BlockedVolume& Volume;
  const ClassifiedTable& Table;
  std::vector<ClassifiedColor> Colors;
  std::vector<std::uint32_t> Counts; // of pairs of bins, by level
  std::int32_t RangeFirst = 0;
  std::int32_t RangeSize = 1;
  std::int32_t Lowest = 0;
  std::int32_t Last = 0;
  std::vector<std::unique_ptr<LevelInterpolator<std::int32_t>>> Exact;
  std::vector<std::unique_ptr<LevelInterpolator<double>>> Real;
  std::vector<std::int32_t> Fine; // nearest entries
  std::vector<double> FineReal;   // positions, where they are no integers
  RowPositions Coarse;
  std::vector<std::int32_t> Values;
  std::vector<double> CoarseReal;
  std::vector<std::uint8_t> IsFinite;
  std::vector<double> Sums;
  std::array<int, 3> First = {};
  std::array<int, 3> Count = {};
};
} // namespace

template <typename T>
std::int64_t ComputeDistortion(const T* samples, const BlockedVolume& volume,
  const std::vector<std::int64_t>& blocks, int levels, const ClassifiedTable& table,
  [[maybe_unused]] int threads, float* distortion, BlockSummary* summaries)
{
  const auto count = static_cast<std::int64_t>(blocks.size());
  std::int64_t left = 0;
  ParallelLoop loop;
#ifdef _OPENMP
  const int team = threads > 0 ? threads : omp_get_max_threads();
#pragma omp parallel num_threads(team) reduction(+ : left)
#endif
  {
    std::unique_ptr<BlockDistortion<T>> kernel; // of this thread
    loop.Do([&] { kernel = std::make_unique<BlockDistortion<T>>(samples, volume, levels, table); });
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t i = 0; i < count; ++i)
    {
      loop.Do(
        [&]
        {
          left += kernel->Compute(
            blocks[i], distortion + i * levels, summaries ? summaries + i : nullptr);
        });
    }
  }
  loop.Finish();
  return left;
}

#define FLATBLOCK_INSTANTIATE(T)                                                                   \
  template std::int64_t ComputeDistortion(const T*, const BlockedVolume&,                          \
    const std::vector<std::int64_t>&, int, const ClassifiedTable&, int, float*, BlockSummary*);
FLATBLOCK_FOR_SAMPLE_TYPES(FLATBLOCK_INSTANTIATE)
#undef FLATBLOCK_INSTANTIATE
} // namespace flatblock
