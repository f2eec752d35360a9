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

// The share of the atlas that is expected to be lost beside the bricks of each level, and in slabs
// that are half full.
double GetMixedLoss(const std::vector<int>& sides, int width, int height, double texels)
{
  double loss = 0.0;
  double weight = 0.75; // most of the memory goes to the finest levels
  double thickness = 0.0;
  for (int side : sides)
  {
    loss += weight * (1.0 - GetUsedShare(width, side) * GetUsedShare(height, side));
    weight *= 0.25;
    thickness += side;
  }
  return loss + 0.5 * thickness * width * height / texels;
}

// What is lost with so many bricks of the finest level and no others, in texels.
double GetFinestLoss(int side, int width, int height, std::int64_t bricks)
{
  const std::int64_t perSlab = static_cast<std::int64_t>(width / side) * (height / side);
  const std::int64_t slabs = (bricks + perSlab - 1) / perSlab;
  const double texels = static_cast<double>(slabs) * width * height * side;
  return texels - static_cast<double>(bricks) * side * side * side;
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
      // Where even the widest is not deep enough, it holds the most.
      const double tooShallow = isDeepEnough ? 0.0 : 1e18 / static_cast<double>(area);
      const double loss =
        tooShallow + (isFinest ? GetFinestLoss(side, width, height, bricks)
                               : GetMixedLoss(this->Sides, width, height, double(texels)));
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
    const std::int64_t useful =
      this->GetDepthOf({ bricks }) + std::accumulate(this->Sides.begin(), this->Sides.end(), 0);
    this->Depth = static_cast<int>(std::min(most, useful));
  }
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
