#include "LodSelector.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace flatblock
{
namespace
{
struct Candidate
{
  bool IsInView;
  double Priority;
  std::int64_t Block;

  // Ties go to the block with the smaller number.
  bool operator<(const Candidate& other) const
  {
    if (this->IsInView != other.IsInView)
    {
      return other.IsInView;
    }
    return this->Priority != other.Priority ? this->Priority < other.Priority
                                            : this->Block > other.Block;
  }
};

double GetDistance(const BlockGrid& grid, std::int64_t block, const LodCriteria& criteria)
{
  const Index3 first = grid.GetFirstSample(block);
  double squares = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double center = first[axis] + 0.5 * grid.GetCellsPerBlock();
    const double apart = (center - criteria.PointOfInterest[axis]) * criteria.Spacing[axis];
    squares += apart * apart;
  }
  return std::sqrt(squares);
}

double GetDiagonal(const BlockGrid& grid, int level, const LodCriteria& criteria)
{
  const auto& spacing = criteria.Spacing;
  const double voxels = grid.GetCellsPerBlock() >> level;
  return voxels * std::hypot(spacing[0], spacing[1], spacing[2]);
}

// Whether the block has a corner on the inner side of each plane.
bool IsInView(const BlockGrid& grid, std::int64_t block, const LodCriteria& criteria)
{
  const Index3 first = grid.GetFirstSample(block);
  return std::all_of(criteria.ViewPlanes.begin(), criteria.ViewPlanes.end(),
    [&](const std::array<double, 4>& plane)
    {
      double farthest = plane[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        const double low = plane[axis] * first[axis];
        const double high = plane[axis] * (first[axis] + grid.GetCellsPerBlock());
        farthest += std::max(low, high);
      }
      return farthest >= 0.0;
    });
}

// The coarsest level that is needed for all visible blocks to fit; none if there is no such level.
std::optional<int> FindCoarsest(const AtlasShape& shape, std::int64_t blocks, int numberOfLevels)
{
  const int levels = shape.GetNumberOfLevels();
  for (int level = std::clamp(numberOfLevels, 1, levels) - 1; level < levels; ++level)
  {
    std::vector<std::int64_t> bricks(levels, 0);
    bricks[level] = blocks;
    if (shape.GetDepthOf(bricks) <= shape.GetDepth())
    {
      return level;
    }
  }
  return {};
}
} // namespace

std::optional<std::vector<std::int8_t>> SelectLevels(const BlockGrid& grid, const AtlasShape& shape,
  const std::vector<std::uint8_t>& visible, const LodCriteria& criteria)
{
  const std::int64_t blocks =
    std::count_if(visible.begin(), visible.end(), [](std::uint8_t v) { return v != 0; });
  const std::optional<int> coarsest = FindCoarsest(shape, blocks, criteria.NumberOfLevels);
  if (!coarsest)
  {
    return {};
  }
  std::vector<std::int8_t> levels(visible.size(), NoLevel);
  std::vector<std::int64_t> bricks(shape.GetNumberOfLevels(), 0);
  bricks[0] = blocks;
  if (shape.GetDepthOf(bricks) <= shape.GetDepth())
  {
    std::transform(visible.begin(), visible.end(), levels.begin(),
      [](std::uint8_t v) -> std::int8_t { return v ? 0 : NoLevel; });
    return levels;
  }
  bricks[0] = 0;
  bricks[*coarsest] = blocks;
  std::vector<double> distances(visible.size(), 0.0);
  std::vector<Candidate> start;
  for (std::size_t block = 0; block < visible.size(); ++block)
  {
    if (visible[block])
    {
      const auto number = static_cast<std::int64_t>(block);
      levels[block] = static_cast<std::int8_t>(*coarsest);
      distances[block] = GetDistance(grid, number, criteria);
      start.push_back({ IsInView(grid, number, criteria),
        1.0 / (distances[block] + GetDiagonal(grid, *coarsest, criteria)), number });
    }
  }

  std::priority_queue<Candidate> queue({}, std::move(start));
  while (!queue.empty())
  {
    const std::int64_t block = queue.top().Block;
    const bool isInView = queue.top().IsInView;
    queue.pop();
    const int level = levels[block];
    if (level == 0)
    {
      continue;
    }
    --bricks[level];
    ++bricks[level - 1];
    if (shape.GetDepthOf(bricks) > shape.GetDepth())
    {
      ++bricks[level];
      --bricks[level - 1];
      continue; // a smaller brick may still find a place
    }
    levels[block] = static_cast<std::int8_t>(level - 1);
    queue.push(
      { isInView, 1.0 / (distances[block] + GetDiagonal(grid, level - 1, criteria)), block });
  }
  return levels;
}
} // namespace flatblock
