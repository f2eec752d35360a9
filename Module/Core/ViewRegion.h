/// Which blocks can be seen at all.
#pragma once

#include "BlockGrid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace flatblock
{
/// How much a block matters: all that are in view come before all that are not.
enum class BlockRank : std::uint8_t
{
  Transparent, ///< nothing of it is drawn
  OutOfView,
  InView
};

/// vtkVolumeMapper's cropping: two planes an axis cut space into 27 regions.
struct CroppingRegions
{
  /// Low and high plane of x, y, z, in the data set's coordinates.
  std::array<double, 6> Planes = {};
  /// Bit x + 3 y + 9 z, each 0 below, 1 between and 2 above the planes: the region is shown.
  int Flags = 0;
  /// Rows (a, b, c, d) that take a sample's indices to a data set coordinate a i + b j + c k + d.
  std::array<std::array<double, 4>, 3> SampleToDataSet = {};

  bool operator==(const CroppingRegions& other) const
  {
    return this->Planes == other.Planes && this->Flags == other.Flags &&
           this->SampleToDataSet == other.SampleToDataSet;
  }
};

/// Planes (a, b, c, d) in samples: what has a x + b y + c z + d < 0 on any of them is cut off.
using Planes = std::vector<std::array<double, 4>>;

/// What is cut off a volume, and whether only a slice of it is drawn.
struct Clipping
{
  flatblock::Planes Planes;
  std::optional<CroppingRegions> Cropping;
  std::optional<std::array<double, 4>> Slice; ///< where a x + b y + c z + d = 0

  bool operator==(const Clipping& other) const
  {
    return this->Planes == other.Planes && this->Cropping == other.Cropping &&
           this->Slice == other.Slice;
  }
};

struct ViewRegion
{
  Planes Frustum;
  flatblock::Clipping Clipping;

  bool operator==(const ViewRegion& other) const
  {
    return this->Frustum == other.Frustum && this->Clipping == other.Clipping;
  }
};

/// Conservative: a block that is out of view for each plane or cropping region by itself.
///
/// @param visible  for every block whether anything of it is drawn
std::vector<BlockRank> RankBlocks(
  const BlockGrid& grid, const std::vector<std::uint8_t>& visible, const ViewRegion& region);
} // namespace flatblock
