/// How a volume is cut into flat blocks.
#pragma once

#include <array>
#include <cstdint>

namespace flatblock
{
using Index3 = std::array<int, 3>;

/// Blocks of a fixed number of cells a side over a regular grid of samples. Neighbours share their
/// border samples; a block at a far face may be partial. Blocks are numbered x fastest.
class BlockGrid
{
public:
  /// A grid without blocks.
  BlockGrid() = default;

  /// @param samples          samples an axis, each >= 1
  /// @param samplesPerBlock  samples a block's side, 2^n + 1 with n >= 1
  /// @param apron            samples that bricks have around their border
  BlockGrid(const Index3& samples, int samplesPerBlock, int apron = 0);

  const Index3& GetSamples() const { return this->Samples; }
  const Index3& GetBlocks() const { return this->Blocks; }
  int GetSamplesPerBlock() const { return this->CellsPerBlock + 1; }
  int GetCellsPerBlock() const { return this->CellsPerBlock; }
  int GetApron() const { return this->Apron; }
  std::int64_t GetNumberOfBlocks() const;

  /// The block at position (i,j,k) of the grid of blocks.
  std::int64_t GetBlock(const Index3& position) const;

  /// Levels of detail of a block: level 0 holds every sample, level l one at a stride of 2^l, down
  /// to the eight corners.
  int GetNumberOfLevels() const;

  /// Samples a side of a block at this level.
  int GetBrickSide(int level) const { return (this->CellsPerBlock >> level) + 1; }

  /// Texels a side of its brick: that, and the apron.
  int GetTexelSide(int level) const { return this->GetBrickSide(level) + 2 * this->Apron; }

  /// The block's position in the grid of blocks.
  Index3 GetPosition(std::int64_t block) const;

  /// The block's first sample along each axis.
  Index3 GetFirstSample(std::int64_t block) const;

private:
  Index3 Samples = { 0, 0, 0 };
  Index3 Blocks = { 0, 0, 0 };
  int CellsPerBlock = 0;
  int Apron = 0;
};
} // namespace flatblock
