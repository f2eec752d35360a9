#include "ViewRegion.h"

#include <algorithm>
#include <cmath>

namespace flatblock
{
namespace
{
// Ranks down what lies wholly on the outer side of a plane.
void ApplyPlane(
  const BlockGrid& grid, const std::array<double, 4>& plane, std::vector<BlockRank>& ranks)
{
  const Index3& blocks = grid.GetBlocks();
  const double cells = grid.GetCellsPerBlock();
  double corner = plane[3]; // of the first block, the one that is farthest along the plane's normal
  for (int axis = 0; axis < 3; ++axis)
  {
    corner += std::max(plane[axis] * cells, 0.0);
  }
  BlockRank* rank = ranks.data();
  for (int k = 0; k < blocks[2]; ++k)
  {
    for (int j = 0; j < blocks[1]; ++j)
    {
      const double row = corner + cells * (plane[1] * j + plane[2] * k);
      const double step = cells * plane[0];
      for (int i = 0; i < blocks[0]; ++i, ++rank)
      {
        const bool isOutside = row + step * i < 0.0;
        *rank = isOutside ? std::min(*rank, BlockRank::OutOfView) : *rank;
      }
    }
  }
}

// The first and last of three regions that the interval meets.
std::array<int, 2> GetRegions(double low, double high, double lowPlane, double highPlane)
{
  const auto regionOf = [=](double x) { return x < lowPlane ? 0 : (x < highPlane ? 1 : 2); };
  return { regionOf(low), regionOf(high) };
}

bool IsShown(const CroppingRegions& cropping, const Index3& first, int cells)
{
  std::array<std::array<int, 2>, 3> regions;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& row = cropping.SampleToDataSet[axis];
    double center = row[3];
    double half = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      center += row[i] * (first[i] + 0.5 * cells);
      half += std::abs(row[i]) * 0.5 * cells;
    }
    regions[axis] = GetRegions(
      center - half, center + half, cropping.Planes[2 * axis], cropping.Planes[2 * axis + 1]);
  }
  for (int z = regions[2][0]; z <= regions[2][1]; ++z)
  {
    for (int y = regions[1][0]; y <= regions[1][1]; ++y)
    {
      for (int x = regions[0][0]; x <= regions[0][1]; ++x)
      {
        if ((cropping.Flags >> (x + 3 * y + 9 * z) & 1) != 0)
        {
          return true;
        }
      }
    }
  }
  return false;
}
} // namespace

std::vector<BlockRank> RankBlocks(
  const BlockGrid& grid, const std::vector<std::uint8_t>& visible, const ViewRegion& region)
{
  std::vector<BlockRank> ranks(visible.size());
  std::transform(visible.begin(), visible.end(), ranks.begin(),
    [](std::uint8_t v) { return v ? BlockRank::InView : BlockRank::Transparent; });
  for (const Planes* planes : { &region.Frustum, &region.Clipping.Planes })
  {
    for (const auto& plane : *planes)
    {
      ApplyPlane(grid, plane, ranks);
    }
  }
  if (region.Clipping.Slice)
  {
    const auto& [a, b, c, d] = *region.Clipping.Slice;
    ApplyPlane(grid, { a, b, c, d }, ranks);
    ApplyPlane(grid, { -a, -b, -c, -d }, ranks);
  }
  const std::optional<CroppingRegions>& cropping = region.Clipping.Cropping;
  for (std::size_t block = 0; cropping && block < ranks.size(); ++block)
  {
    if (ranks[block] == BlockRank::InView &&
        !IsShown(*cropping, grid.GetFirstSample(static_cast<std::int64_t>(block)),
          grid.GetCellsPerBlock()))
    {
      ranks[block] = BlockRank::OutOfView;
    }
  }
  return ranks;
}
} // namespace flatblock
