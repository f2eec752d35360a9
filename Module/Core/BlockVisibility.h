/// Which blocks hide behind others.
#pragma once

#include "BlockGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace flatblock
{
/// From where rays come, in samples.
struct Viewpoint
{
  bool IsParallel = false;
  std::array<double, 3> Eye = {};   ///< perspective
  std::array<double, 3> Sight = {}; ///< parallel: direction
  /// What has a x + b y + c z + d < 0 lies before the near plane, where nothing is drawn.
  std::array<double, 4> NearPlane = { 0.0, 0.0, 0.0, 1.0 };

  bool operator==(const Viewpoint& other) const
  {
    return this->IsParallel == other.IsParallel && this->Eye == other.Eye &&
           this->Sight == other.Sight && this->NearPlane == other.NearPlane;
  }
};

/// The largest transmittance with which any ray from the viewpoint reaches each block, or more: so
/// a block that is seen at all is never taken for hidden. A ray that goes farthest along one axis
/// passes at least a block's width of each layer of blocks across that axis, and there moves aside
/// by no more than a block: of the 2 x 2 blocks that it may meet, the clearest one counts.
///
/// @param extinction  of each block the smallest one in it, per world unit of length, at least 0
/// @param spacing     world units of a sample's spacing along each axis
/// @return in [0, 1], of every block
std::vector<float> ComputeTransmittance(const BlockGrid& grid, const std::vector<float>& extinction,
  const std::array<double, 3>& spacing, const Viewpoint& viewpoint);
} // namespace flatblock
