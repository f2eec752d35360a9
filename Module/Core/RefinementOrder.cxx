#include "RefinementOrder.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace flatblock
{
namespace
{
// Along one axis, in world units: from the point of interest to the centre of each block.
std::vector<double> GetOffsets(const BlockGrid& grid, int axis, double point, double spacing)
{
  std::vector<double> offsets(grid.GetBlocks()[axis]);
  for (std::size_t i = 0; i < offsets.size(); ++i)
  {
    const double center = (static_cast<double>(i) + 0.5) * grid.GetCellsPerBlock();
    offsets[i] = (center - point) * spacing;
  }
  return offsets;
}

double GetNearest(const std::vector<double>& offsets)
{
  const bool isBetween = offsets.front() < 0.0 && offsets.back() > 0.0;
  return isBetween ? 0.0 : std::min(std::abs(offsets.front()), std::abs(offsets.back()));
}

double GetFarthest(const std::vector<double>& offsets)
{
  return std::max(std::abs(offsets.front()), std::abs(offsets.back()));
}

// By level: 1, or by how much less a brick of the next finer level takes than one of the finest.
std::vector<float> GetWorths(const BlockGrid& grid, const BlockDistortion& distortion)
{
  std::vector<float> worths(distortion.Levels + 1, 1.0F);
  for (int level = 1; distortion.PerByte && level <= distortion.Levels; ++level)
  {
    const double ratio = static_cast<double>(grid.GetBrickSide(0)) / grid.GetBrickSide(level - 1);
    worths[level] = static_cast<float>(ratio * ratio * ratio);
  }
  return worths;
}

float GetError(const BlockDistortion& distortion, std::int64_t block, int level)
{
  const float error =
    distortion.Values ? distortion.Values[block * distortion.Levels + level - 1] : 1.0F;
  return distortion.Weights ? error * distortion.Weights[block] : error;
}
} // namespace

void RefinementOrder::SetToDistance(const BlockGrid& grid, const std::vector<BlockRank>& ranks,
  const std::array<double, 3>& point, const std::array<double, 3>& spacing)
{
  const auto x = GetOffsets(grid, 0, point[0], spacing[0]);
  const auto y = GetOffsets(grid, 1, point[1], spacing[1]);
  const auto z = GetOffsets(grid, 2, point[2], spacing[2]);
  const double nearest = std::hypot(GetNearest(x), GetNearest(y), GetNearest(z));
  const double farthest = std::hypot(GetFarthest(x), GetFarthest(y), GetFarthest(z));
  const double voxel = std::hypot(spacing[0], spacing[1], spacing[2]);
  const double span = std::max(farthest - nearest, voxel * grid.GetCellsPerBlock());
  constexpr double Steps = FirstOutOfView - 1;
  const double scale = Steps / span;

  this->Delays.resize(grid.GetNumberOfLevels());
  for (std::size_t level = 0; level < this->Delays.size(); ++level)
  {
    const int voxels = grid.GetCellsPerBlock() >> level;
    const double delay = voxels * voxel * scale;
    this->Delays[level] = delay > 0.0 ? static_cast<int>(std::lround(std::min(delay, Steps))) : 0;
  }
  this->Numbers.resize(1);
  this->Numbers[0].resize(ranks.size());
  std::vector<double> squares(x.size());
  std::transform(x.begin(), x.end(), squares.begin(), [](double d) { return d * d; });
  std::vector<std::int32_t> row(x.size());
  std::uint16_t* number = this->Numbers[0].data();
  const BlockRank* rank = ranks.data();
  for (const double dz : z)
  {
    for (const double dy : y)
    {
      const double plane = dy * dy + dz * dz;
      for (std::size_t i = 0; i < row.size(); ++i)
      {
        const double steps = (std::sqrt(squares[i] + plane) - nearest) * scale;
        row[i] = static_cast<std::int32_t>(steps > 0.0 ? std::min(steps, Steps) : 0.0);
      }
      for (const std::int32_t steps : row)
      {
        const auto inView = static_cast<std::uint16_t>(steps);
        const auto outOfView =
          static_cast<std::uint16_t>(std::min(steps + FirstOutOfView, Never - 1));
        *number++ = *rank == BlockRank::InView      ? inView
                    : *rank == BlockRank::OutOfView ? outOfView
                                                    : Never;
        ++rank;
      }
    }
  }
}

// importanceOf(block, level) > 0 of a refinement from a level.
template <typename Importance>
void RefinementOrder::SetToImportance(const BlockGrid& grid, const std::vector<BlockRank>& ranks,
  const BlockDistortion& distortion, const Importance& importanceOf)
{
  // Floats in their binary form are in the order of their values, and nearly logarithms of them.
  const auto toSteps = [](float value)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return static_cast<int>(bits >> 12);
  };
  float largest = 0.0F;
  const auto blocks = static_cast<std::int64_t>(ranks.size());
  for (std::int64_t block = 0; block < blocks; ++block)
  {
    for (int level = 1; ranks[block] != BlockRank::Transparent && level <= distortion.Levels;
         ++level)
    {
      largest = std::max(largest, importanceOf(block, level));
    }
  }
  const int most = toSteps(largest);
  constexpr int Last = FirstOutOfView - 1;
  this->Delays.assign(grid.GetNumberOfLevels(), 0);
  this->Numbers.resize(distortion.Levels);
  for (auto& numbers : this->Numbers)
  {
    numbers.assign(ranks.size(), Never);
  }
  for (std::int64_t block = 0; block < blocks; ++block)
  {
    int steps = 0;
    for (int level = distortion.Levels; ranks[block] != BlockRank::Transparent && level > 0;
         --level)
    {
      steps = std::max(steps, std::min(most - toSteps(importanceOf(block, level)), Last));
      const int number =
        ranks[block] == BlockRank::InView ? steps : std::min(steps + FirstOutOfView, Never - 1);
      this->Numbers[level - 1][block] = static_cast<std::uint16_t>(number);
    }
  }
}

void RefinementOrder::SetToDistortion(
  const BlockGrid& grid, const std::vector<BlockRank>& ranks, const BlockDistortion& distortion)
{
  const std::vector<float> worths = GetWorths(grid, distortion);
  this->SetToImportance(grid, ranks, distortion,
    [&](std::int64_t block, int level)
    { return GetError(distortion, block, level) * worths[level]; });
}

void RefinementOrder::SetToDistortionAndDistance(const BlockGrid& grid,
  const std::vector<BlockRank>& ranks, const BlockDistortion& distortion,
  const std::array<double, 3>& point, const std::array<double, 3>& spacing)
{
  const std::vector<float> worths = GetWorths(grid, distortion);
  const auto x = GetOffsets(grid, 0, point[0], spacing[0]);
  const auto y = GetOffsets(grid, 1, point[1], spacing[1]);
  const auto z = GetOffsets(grid, 2, point[2], spacing[2]);
  std::vector<float> distances(ranks.size());
  auto distance = distances.begin();
  for (const double dz : z)
  {
    for (const double dy : y)
    {
      for (const double dx : x)
      {
        *distance++ = static_cast<float>(std::sqrt(dx * dx + dy * dy + dz * dz));
      }
    }
  }
  const double voxel = std::hypot(spacing[0], spacing[1], spacing[2]);
  this->SetToImportance(grid, ranks, distortion,
    [&](std::int64_t block, int level)
    {
      const auto diagonal = static_cast<float>((grid.GetCellsPerBlock() >> level) * voxel);
      return GetError(distortion, block, level) * worths[level] / (distances[block] + diagonal);
    });
}
} // namespace flatblock
