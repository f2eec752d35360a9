#include "BlockBorders.h"
#include "BlockGrid.h"
#include "BrickBorder.h"
#include "BrickCopy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using flatblock::BlockGrid;
using flatblock::Index3;

namespace
{
// A volume of random levels and samples, and what a ray would see of it.
class Volume
{
public:
  Volume(const Index3& samples, int blockSize, bool continuity, unsigned seed)
    : Grid(samples, blockSize)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0F, 1.0F);
    this->Samples.resize(std::size_t(samples[0]) * samples[1] * samples[2]);
    std::generate(this->Samples.begin(), this->Samples.end(), [&] { return value(random); });
    this->Levels.resize(this->Grid.GetNumberOfBlocks());
    for (std::int8_t& level : this->Levels)
    {
      level = static_cast<std::int8_t>(random() % this->Grid.GetNumberOfLevels());
    }
    for (std::int64_t block = 0; block < this->Grid.GetNumberOfBlocks(); ++block)
    {
      const int level = this->Levels[block];
      const int side = this->Grid.GetBrickSide(level);
      std::vector<float> brick(std::size_t(side) * side * side);
      flatblock::CopyBrick(this->Samples.data(), samples, this->Grid.GetFirstSample(block), side,
        1 << level, flatblock::TexelEncoder<float, float>(), brick.data());
      if (continuity)
      {
        flatblock::BrickBorder<float>(brick.data(), side)
          .Coarsen(flatblock::GetBlockBorder(this->Grid, this->Levels, block));
      }
      this->Bricks.push_back(brick);
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
    return sum;
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

  BlockGrid Grid;
  std::vector<float> Samples;
  std::vector<std::int8_t> Levels;
  std::vector<std::vector<float>> Bricks;
};
} // namespace

TEST(BrickBorder, RandomLevelsMeetWithoutAStep)
{
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    for (const Index3& samples : { Index3{ 65, 65, 65 }, { 50, 40, 70 } })
    {
      const double off = Volume(samples, 17, false, seed).GetLargestStep(seed, 20000);
      const double on = Volume(samples, 17, true, seed).GetLargestStep(seed, 20000);
      EXPECT_LE(on, 1.0 / 65536.0) << "seed " << seed;
      EXPECT_GE(off, 0.1) << "seed " << seed;
      if (seed == 1)
      {
        std::cout << "largest step " << off << " without, " << on << " with continuity\n";
      }
    }
  }
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
