#include "AtlasShape.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace flatblock
{
namespace
{
// Multiples of the bricks' sides: other widths leave more over than the next smaller of these.
std::vector<int> GetCandidates(const std::vector<int>& sides, int largest)
{
  constexpr int WidestWorthTrying = 1200;
  constexpr std::size_t LevelsWorthTrying = 3;
  std::set<int> candidates;
  for (std::size_t level = 0; level < std::min(sides.size(), LevelsWorthTrying); ++level)
  {
    for (int n = sides[level]; n <= std::min(largest, WidestWorthTrying); n += sides[level])
    {
      if (n >= sides[0])
      {
        candidates.insert(n);
      }
    }
  }
  return { candidates.begin(), candidates.end() };
}

double GetUsedShare(int texels, int side)
{
  const int used = texels / side * side;
  return static_cast<double>(used) / texels;
}

// The largest share of the atlas that can be lost: beside the bricks of any of the finer levels,
// which take nearly all of the memory, and in layers that are too few for a brick.
double GetLargestLoss(const std::vector<int>& sides, int width, int height, double texels)
{
  double loss = 0.0;
  const std::size_t finer = std::min<std::size_t>(sides.size(), 4);
  for (std::size_t level = 0; level < finer; ++level)
  {
    const double used = GetUsedShare(width, sides[level]) * GetUsedShare(height, sides[level]);
    loss = std::max(loss, 1.0 - used);
  }
  return loss + static_cast<double>(sides[finer / 2]) * width * height / texels;
}

// What is lost with so many bricks of the finest level and no others, as a share of them.
double GetFinestLoss(const std::vector<int>& sides, int width, int height, std::int64_t bricks)
{
  const int side = sides[0];
  const std::int64_t perSlab = static_cast<std::int64_t>(width / side) * (height / side);
  const std::int64_t depth =
    (bricks + perSlab - 1) / perSlab * side + std::accumulate(sides.begin() + 1, sides.end(), 0);
  return static_cast<double>(depth) * width * height /
           (static_cast<double>(bricks) * side * side * side) -
         1.0;
}
} // namespace

AtlasShape::AtlasShape(const Request& request)
  : Sides(request.Sides), MostTexels(request.MostTexels)
{
  const std::int64_t mostTexels = request.MostTexels;
  const int largestTexture = request.LargestTexture;
  const int side = this->Sides[0];
  const std::int64_t bricks = std::max<std::int64_t>(request.FinestBricks, 1);
  const std::int64_t finestTexels = bricks * side * side * side;
  const bool isFinest = finestTexels <= mostTexels;
  const std::int64_t texels = std::min(finestTexels, std::max<std::int64_t>(mostTexels, 1));
  double least = std::numeric_limits<double>::infinity();
  const std::vector<int> candidates = GetCandidates(this->Sides, largestTexture);
  for (int height : candidates)
  {
    for (int width : candidates)
    {
      const std::int64_t area = static_cast<std::int64_t>(width) * height;
      const bool isDeepEnough = area * largestTexture >= texels;
      // Where even the widest is not deep enough, it holds the most; where no slab of the finest
      // level fits, a small one is better.
      const double tooShallow = (isDeepEnough ? 0.0 : 1e18 / static_cast<double>(area)) +
                                (area * side > mostTexels ? static_cast<double>(area) : 0.0);
      const double loss =
        tooShallow + (isFinest ? GetFinestLoss(this->Sides, width, height, bricks)
                               : GetLargestLoss(this->Sides, width, height, double(texels)));
      if (width >= height && loss < least)
      {
        least = loss;
        this->Width = width;
        this->Height = height;
      }
    }
  }
  if (this->Width > 0)
  {
    const std::int64_t area = static_cast<std::int64_t>(this->Width) * this->Height;
    const std::int64_t most = std::min<std::int64_t>(largestTexture, mostTexels / area);
    // Every block at its finest level, and a slab of each other level on the way there.
    const std::int64_t useful = this->GetDepthOf({ bricks }) + this->GetDepthOnTheWay();
    this->Depth = static_cast<int>(std::min(most, useful));
  }
}

int AtlasShape::GetDepthOnTheWay() const
{
  return std::accumulate(this->Sides.begin() + 1, this->Sides.end(), 0);
}

std::int64_t AtlasShape::GetBricksPerSlab(int level) const
{
  const int side = this->Sides[level];
  return static_cast<std::int64_t>(this->Width / side) * (this->Height / side);
}

std::int64_t AtlasShape::GetDepthOf(const std::vector<std::int64_t>& bricks) const
{
  std::int64_t depth = 0;
  for (std::size_t level = 0; level < bricks.size(); ++level)
  {
    const std::int64_t perSlab = this->GetBricksPerSlab(static_cast<int>(level));
    depth += (bricks[level] + perSlab - 1) / perSlab * this->Sides[level];
  }
  return depth;
}
} // namespace flatblock
