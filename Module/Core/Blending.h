/// What becomes of the values along a ray.
#pragma once

#include "TransferTable.h"

#include <array>
#include <vector>

namespace flatblock
{
enum class BlendMode
{
  Composite,
  Maximum,
  Minimum,
  Average,
  Additive,
  Isosurface,
  Slice
};

struct Blending
{
  BlendMode Mode = BlendMode::Composite;
  std::vector<double> IsoValues;                 ///< rising; of isosurfaces
  std::array<double, 2> AverageRange = { 0, 0 }; ///< values that an average counts

  bool IsComposite() const { return this->Mode == BlendMode::Composite; }
  bool IsExtreme() const
  {
    return this->Mode == BlendMode::Maximum || this->Mode == BlendMode::Minimum;
  }

  /// Whether there are surfaces that light falls on.
  bool HasSurfaces() const { return this->IsComposite() || this->Mode == BlendMode::Isosurface; }

  bool operator==(const Blending& other) const
  {
    return this->Mode == other.Mode && this->IsoValues == other.IsoValues &&
           this->AverageRange == other.AverageRange;
  }
};

/// A table that is transparent over an interval of values only where samples in it make no
/// difference to any picture; its colours mean nothing. A maximum differs where any value up to its
/// own is not transparent, for it may hide that one; a minimum likewise from above.
TransferTable GetDecisiveValues(const TransferTable& table, const Blending& blending);
} // namespace flatblock
