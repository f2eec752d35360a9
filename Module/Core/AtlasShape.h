/// How large the atlas is, and how many bricks of each level it holds.
#pragma once

#include "BlockGrid.h"

#include <cstdint>
#include <vector>

namespace flatblock
{
/// The atlas is cut along z into slabs; a slab is as thick as the bricks of one level and holds
/// these side by side. So bricks of sizes that don't nest leave nearly nothing over.
class AtlasShape
{
public:
  struct Request
  {
    std::vector<int> Sides;        ///< texels a side of a brick, by level
    std::int64_t MostTexels = 0;   ///< that the atlas may have
    std::int64_t FinestBricks = 0; ///< that there would be if all were of level 0
    int LargestTexture = 0;        ///< texels a side that the driver allows

    bool operator==(const Request& other) const
    {
      return this->Sides == other.Sides && this->MostTexels == other.MostTexels &&
             this->FinestBricks == other.FinestBricks &&
             this->LargestTexture == other.LargestTexture;
    }
  };

  AtlasShape() = default;

  /// The width and height that leave the least over, at whatever mixture of levels. Tries many: to
  /// be asked only where the request has changed.
  explicit AtlasShape(const Request& request);

  /// Whether bricks have the same places in both, but for the depth.
  bool IsSameGrid(const AtlasShape& other) const
  {
    return this->Width == other.Width && this->Height == other.Height && this->Sides == other.Sides;
  }

  /// Texels an axis; Depth is the most that is of use within what is allowed.
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  int GetDepth() const { return this->Depth; }
  std::int64_t GetMostTexels() const { return this->MostTexels; }
  int GetSide(int level) const { return this->Sides[level]; }
  int GetNumberOfLevels() const { return static_cast<int>(this->Sides.size()); }

  std::int64_t GetBricksPerSlab(int level) const;

  /// Texels along z of the slabs that hold so many bricks of each level.
  std::int64_t GetDepthOf(const std::vector<std::int64_t>& bricks) const;

  /// Texels along z of one slab of each level but the finest.
  int GetDepthOnTheWay() const;

private:
  std::vector<int> Sides;
  std::int64_t MostTexels = 0;
  int Width = 0;
  int Height = 0;
  int Depth = 0;
};
} // namespace flatblock
