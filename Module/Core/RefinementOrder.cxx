#include "RefinementOrder.h"

#include <algorithm>
#include <cmath>

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
    this->Delays[level] = static_cast<int>(std::lround(voxels * voxel * scale));
  }
  this->Blocks.resize(ranks.size());
  std::vector<double> squares(x.size());
  std::transform(x.begin(), x.end(), squares.begin(), [](double d) { return d * d; });
  std::vector<std::int32_t> row(x.size());
  std::uint16_t* number = this->Blocks.data();
  const BlockRank* rank = ranks.data();
  for (const double dz : z)
  {
    for (const double dy : y)
    {
      const double plane = dy * dy + dz * dz;
      for (std::size_t i = 0; i < row.size(); ++i)
      {
        const double steps = (std::sqrt(squares[i] + plane) - nearest) * scale;
        row[i] = static_cast<std::int32_t>(std::min(std::max(steps, 0.0), Steps));
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
} // namespace flatblock
