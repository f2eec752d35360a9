#include "BlockBorders.h"
#include "BlockGrid.h"
#include "BrickBorder.h"
#include "BrickCopy.h"
#include "BrickFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

using flatblock::BlockGrid;
using flatblock::Continuity;
using flatblock::Index3;

namespace
{
// A volume of random levels and samples, and what a ray would see of it, as a share of the range.
template <typename Texel>
class Volume
{
public:
  Volume(const Index3& samples, int blockSize, Continuity continuity, unsigned seed)
    : Grid(samples, blockSize)
  {
    std::mt19937 random(seed);
    this->Samples.resize(std::size_t(samples[0]) * samples[1] * samples[2]);
    std::generate(this->Samples.begin(), this->Samples.end(),
      [&] { return static_cast<Texel>(this->Range * (random() % 4097) / 4096.0); });
    this->Levels.resize(this->Grid.GetNumberOfBlocks());
    for (std::int8_t& level : this->Levels)
    {
      level = static_cast<std::int8_t>(random() % this->Grid.GetNumberOfLevels());
    }
    for (std::int64_t block = 0; block < this->Grid.GetNumberOfBlocks(); ++block)
    {
      this->Bricks.push_back(this->MakeBrick(block, continuity));
    }
  }

  // The trilinear interpolant of a block's brick at a position in samples.
  double Sample(std::int64_t block, const std::array<double, 3>& position) const
  {
    const int level = this->Levels[block];
    const int side = this->Grid.GetBrickSide(level);
    const Index3 first = this->Grid.GetFirstSample(block);
    int cell[3];
    double share[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double local = (position[axis] - first[axis]) / (1 << level);
      cell[axis] = std::clamp(static_cast<int>(std::floor(local)), 0, side - 2);
      share[axis] = local - cell[axis];
    }
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      int index = 0;
      for (int axis = 2; axis >= 0; --axis)
      {
        const int up = corner >> axis & 1;
        weight *= up ? share[axis] : 1.0 - share[axis];
        index = index * side + cell[axis] + up;
      }
      sum += weight * this->Bricks[block][index];
    }
    return sum / this->Range;
  }

  // The largest step between any two blocks that share a random point of a border.
  double GetLargestStep(unsigned seed, int trials) const
  {
    std::mt19937 random(seed);
    const int cells = this->Grid.GetCellsPerBlock();
    double largest = 0.0;
    for (int trial = 0; trial < trials; ++trial)
    {
      std::array<double, 3> position;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double last = this->Grid.GetSamples()[axis] - 1;
        position[axis] = std::uniform_real_distribution<double>(0.0, last)(random);
      }
      // On a face, an edge or a corner.
      for (int axis = 0, borders = 1 + int(random() % 3); borders > 0; ++axis, --borders)
      {
        const int blocks = this->Grid.GetBlocks()[axis];
        position[axis] = cells * (1 + int(random() % (blocks - 1)));
      }
      std::rotate(position.begin(), position.begin() + random() % 3, position.end());
      largest = std::max(largest, this->GetStepAt(position));
    }
    return largest;
  }

private:
  std::vector<Texel> ReadLevel(std::int64_t block, int level, bool isFiltered) const
  {
    const int side = this->Grid.GetBrickSide(level);
    const Index3 first = this->Grid.GetFirstSample(block);
    const flatblock::TexelEncoder<Texel, Texel> encode;
    std::vector<Texel> brick(std::size_t(side) * side * side);
    if (isFiltered)
    {
      flatblock::BrickFilter<Texel, Texel>(this->Samples.data(), this->Grid.GetSamples(), encode)
        .Read(first, side, 1 << level, brick.data());
    }
    else
    {
      flatblock::CopyBrick(this->Samples.data(), this->Grid.GetSamples(), first, side, 1 << level,
        encode, brick.data());
    }
    return brick;
  }

  std::vector<Texel> MakeBrick(std::int64_t block, Continuity continuity) const
  {
    const int level = this->Levels[block];
    const int side = this->Grid.GetBrickSide(level);
    const bool isFiltered = continuity == Continuity::Filtered;
    auto brick = this->ReadLevel(block, level, isFiltered);
    const auto border = flatblock::GetBlockBorder(this->Grid, this->Levels, block, continuity);
    for (int coarser = 1; isFiltered && level + coarser < this->Grid.GetNumberOfLevels(); ++coarser)
    {
      const auto coarse = this->ReadLevel(block, level + coarser, true);
      flatblock::BrickBorder<Texel>(brick.data(), side).CopyCoarser(border, coarser, coarse.data());
    }
    flatblock::BrickBorder<Texel>(brick.data(), side).Coarsen(border);
    return brick;
  }

  double GetStepAt(const std::array<double, 3>& position) const
  {
    const int cells = this->Grid.GetCellsPerBlock();
    double lowest = 2.0;
    double highest = -1.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      Index3 block;
      bool isShared = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int above = static_cast<int>(std::floor(position[axis] / cells));
        block[axis] = above - (corner >> axis & 1);
        isShared = isShared && block[axis] >= 0 && block[axis] < this->Grid.GetBlocks()[axis] &&
                   (block[axis] == above || position[axis] == double(above) * cells);
      }
      if (isShared)
      {
        const double value = this->Sample(this->Grid.GetBlock(block), position);
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
      }
    }
    return highest - lowest;
  }

  static constexpr double Range =
    std::is_integral_v<Texel> ? double(std::numeric_limits<Texel>::max()) : 1.0;

  BlockGrid Grid;
  std::vector<Texel> Samples;
  std::vector<std::int8_t> Levels;
  std::vector<std::vector<Texel>> Bricks;
};

// The largest step of eight volumes each.
template <typename Texel>
double GetLargestStep(Continuity continuity)
{
  double largest = 0.0;
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    for (const Index3& samples : { Index3{ 65, 65, 65 }, { 50, 40, 70 } })
    {
      const Volume<Texel> volume(samples, 17, continuity, seed);
      largest = std::max(largest, volume.GetLargestStep(seed, 10000));
    }
  }
  std::cout << "largest step of " << 8 * sizeof(Texel) << " bit: " << largest << "\n";
  return largest;
}
} // namespace

TEST(BrickBorder, RandomLevelsMeetWithoutAStep)
{
  constexpr double MostStep = 1.0 / 65536.0;
  EXPECT_GE(GetLargestStep<float>(Continuity::Off), 0.5);
  EXPECT_LE(GetLargestStep<float>(Continuity::Nested), MostStep);
  EXPECT_LE(GetLargestStep<std::uint16_t>(Continuity::Nested), MostStep);
  // A texel of 8 bit holds no more than itself: edges are rounded, and faces between them again.
  EXPECT_LE(GetLargestStep<std::uint8_t>(Continuity::Nested), 1.0 / 255.0);
}

TEST(BrickBorder, FilteredLevelsMeetWithoutAStep)
{
  constexpr double MostStep = 1.0 / 65536.0;
  EXPECT_LE(GetLargestStep<float>(Continuity::Filtered), MostStep);
  EXPECT_LE(GetLargestStep<std::uint16_t>(Continuity::Filtered), MostStep);
  EXPECT_LE(GetLargestStep<std::uint8_t>(Continuity::Filtered), 1.0 / 255.0);
}

TEST(BrickBorder, EqualLevelsChangeNothing)
{
  std::vector<unsigned char> brick(17 * 17 * 17);
  std::mt19937 random(1);
  std::generate(brick.begin(), brick.end(), [&] { return static_cast<unsigned char>(random()); });
  const auto before = brick;
  flatblock::BrickBorder<unsigned char>(brick.data(), 17).Coarsen({});
  EXPECT_EQ(brick, before);
}

TEST(BrickBorder, ApronsStay)
{
  constexpr int Side = 9;
  constexpr int Outer = Side + 2;
  const auto isInside = [](int i)
  {
    const std::array<int, 3> p = { i % Outer, i / Outer % Outer, i / (Outer * Outer) };
    return std::all_of(p.begin(), p.end(), [](int at) { return at > 0 && at <= Side; });
  };
  std::vector<float> whole(std::size_t(Outer) * Outer * Outer);
  std::mt19937 random(1);
  std::generate(whole.begin(), whole.end(), [&] { return float(random() % 1000); });
  std::vector<float> bare;
  for (int i = 0; i < int(whole.size()); ++i)
  {
    bare.insert(bare.end(), isInside(i) ? 1 : 0, whole[std::size_t(i)]);
  }
  const auto before = whole;
  flatblock::BorderCoarsening border;
  std::generate(border.begin(), border.end(), [&] { return std::int8_t(random() % 3); });
  flatblock::BrickBorder<float>(whole.data(), Side, 1).Coarsen(border);
  flatblock::BrickBorder<float>(bare.data(), Side).Coarsen(border);
  auto wanted = bare.begin();
  for (int i = 0; i < int(whole.size()); ++i)
  {
    const auto at = std::size_t(i);
    ASSERT_EQ(whole[at], isInside(i) ? *wanted++ : before[at]) << i;
  }
}

TEST(BrickBorder, BoxesOfBricksWithAprons)
{
  const auto whole = flatblock::GetBoxes(flatblock::WholeBrick, 9, 1);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].First, (flatblock::Index3{ 0, 0, 0 }));
  EXPECT_EQ(whole[0].Size, (flatblock::Index3{ 11, 11, 11 }));
  const auto farX = flatblock::GetBoxes(1U << 14, 9, 1); // direction (1, 0, 0)
  ASSERT_EQ(farX.size(), 1U);
  EXPECT_EQ(farX[0].First, (flatblock::Index3{ 9, 1, 1 }));
  EXPECT_EQ(farX[0].Size, (flatblock::Index3{ 1, 9, 9 }));
}

// A brick with an old border to which the changed parts of a new one are copied is the new brick.
TEST(BrickBorder, ChangedPartsAreAllThatDiffers)
{
  std::mt19937 random(5);
  const BlockGrid grid({ 49, 49, 49 }, 17);
  constexpr std::int64_t Middle = 13;
  constexpr int Side = 17;
  std::vector<float> samples(Side * Side * Side);
  std::uniform_real_distribution<float> value(0.0F, 1.0F);
  std::generate(samples.begin(), samples.end(), [&] { return value(random); });
  std::int64_t sent = 0;
  constexpr int Trials = 500;
  for (int trial = 0; trial < Trials; ++trial)
  {
    std::vector<std::int8_t> levels(27);
    std::generate(levels.begin(), levels.end(), [&] { return std::int8_t(random() % 4); });
    levels[Middle] = 0;
    const auto before = flatblock::GetBlockBorder(grid, levels, Middle, Continuity::Nested);
    for (int changes = 1 + int(random() % 3); changes > 0; --changes)
    {
      const std::int64_t block = std::int64_t(random() % 27);
      levels[block] = block == Middle ? std::int8_t(0) : std::int8_t(random() % 4);
    }
    const auto after = flatblock::GetBlockBorder(grid, levels, Middle, Continuity::Nested);
    auto brick = samples;
    auto wanted = samples;
    flatblock::BrickBorder<float>(brick.data(), Side).Coarsen(before);
    flatblock::BrickBorder<float>(wanted.data(), Side).Coarsen(after);
    const flatblock::BrickParts parts = flatblock::GetChangedParts(before, after);
    for (const auto& box : flatblock::GetBoxes(parts, Side))
    {
      for (int z = box.First[2]; z < box.First[2] + box.Size[2]; ++z)
      {
        for (int y = box.First[1]; y < box.First[1] + box.Size[1]; ++y)
        {
          const auto row = (std::ptrdiff_t(z) * Side + y) * Side + box.First[0];
          std::copy_n(wanted.begin() + row, box.Size[0], brick.begin() + row);
        }
      }
    }
    ASSERT_EQ(brick, wanted) << "trial " << trial;
    sent += flatblock::CountTexels(parts, Side);
  }
  EXPECT_LT(sent, Trials * 4 * Side * Side); // four faces' worth on average
}
