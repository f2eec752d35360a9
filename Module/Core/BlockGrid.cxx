#include "BlockGrid.h"

#include <algorithm>

namespace flatblock
{
BlockGrid::BlockGrid(const Index3& samples, int samplesPerBlock, int apron)
  : Samples(samples), CellsPerBlock(samplesPerBlock - 1), Apron(apron)
{
  std::transform(samples.begin(), samples.end(), this->Blocks.begin(),
    [cells = this->CellsPerBlock](int n) { return std::max(1, (n - 2) / cells + 1); });
}

std::int64_t BlockGrid::GetNumberOfBlocks() const
{
  return static_cast<std::int64_t>(this->Blocks[0]) * this->Blocks[1] * this->Blocks[2];
}

std::int64_t BlockGrid::GetBlock(const Index3& position) const
{
  return position[0] +
         this->Blocks[0] * (position[1] + static_cast<std::int64_t>(this->Blocks[1]) * position[2]);
}

int BlockGrid::GetNumberOfLevels() const
{
  int levels = 1;
  while (this->CellsPerBlock >> levels)
  {
    ++levels;
  }
  return levels;
}

Index3 BlockGrid::GetPosition(std::int64_t block) const
{
  const std::int64_t row = block / this->Blocks[0];
  return { static_cast<int>(block % this->Blocks[0]), static_cast<int>(row % this->Blocks[1]),
    static_cast<int>(row / this->Blocks[1]) };
}

Index3 BlockGrid::GetFirstSample(std::int64_t block) const
{
  Index3 first = this->GetPosition(block);
  for (int& coordinate : first)
  {
    coordinate *= this->CellsPerBlock;
  }
  return first;
}
} // namespace flatblock
