/// Which level of detail each block is to have.
#pragma once

#include "AtlasShape.h"
#include "BlockGrid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace flatblock
{
/// Level of a block of which nothing is drawn.
constexpr std::int8_t NoLevel = -1;

struct LodCriteria
{
  /// Levels that a block may have, at least 1. Coarser ones are added where these don't fit.
  int NumberOfLevels = 4;

  /// In samples, as the block's own coordinates are.
  std::array<double, 3> PointOfInterest = { 0.0, 0.0, 0.0 };

  /// World units of a sample's spacing along each axis.
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };

  /// Planes (a, b, c, d) in samples: what has a x + b y + c z + d < 0 on any of them is out of
  /// view.
  std::vector<std::array<double, 4>> ViewPlanes;

  bool operator==(const LodCriteria& other) const
  {
    return this->NumberOfLevels == other.NumberOfLevels &&
           this->PointOfInterest == other.PointOfInterest && this->Spacing == other.Spacing &&
           this->ViewPlanes == other.ViewPlanes;
  }
};

/// Begins with every visible block at the coarsest level, and refines by one level the block for
/// which 1 / (d + diagonal) is the largest, until nothing more fits: d is the distance from the
/// point of interest to the block's centre, the diagonal that of the block counted in voxels of its
/// present level, both in world units of the finest voxel. Blocks out of view come after all that
/// are in it. Where all blocks fit at level 0 they have it. Depends on its arguments alone.
///
/// @return the level of every block, NoLevel where it is not visible; nothing where not even the
/// coarsest levels of all visible blocks fit the shape
std::optional<std::vector<std::int8_t>> SelectLevels(const BlockGrid& grid, const AtlasShape& shape,
  const std::vector<std::uint8_t>& visible, const LodCriteria& criteria);
} // namespace flatblock
