/// How far a ray may leap.
#pragma once

#include "Coarsening.h"

#include <cstdint>
#include <vector>

namespace flatblock
{
/// Cubes of cells of a volume, x fastest, each with a byte: its kind times KindFactor plus a
/// Chebyshev distance, 1 to FarthestLeap. For cubes of hidden blocks that is the distance of the
/// block to the nearest one that is not, in blocks. For those that vary it is the distance to the
/// nearest cube of the same block that doesn't, for all others to the nearest one that does, in
/// cubes.
///
/// Cubes share their border samples, so neighbours that don't vary are of one kind, and all within
/// the distance are the same matter.
struct SkipMap
{
  enum class Kind : std::uint8_t
  {
    Varying,
    Transparent,
    Constant, ///< all the same, and not transparent
    Hidden    ///< in a block without a brick
  };
  static constexpr std::uint8_t FarthestLeap = 63;
  static constexpr std::uint8_t KindFactor = 64;

  Index3 Size = { 0, 0, 0 }; ///< cubes an axis
  std::vector<std::uint8_t> Leaps;
};

/// Blocks of 2^n cubes a side; those at the far faces may have fewer.
struct CubeGrid
{
  Index3 Cubes = { 0, 0, 0 };
  Index3 Blocks = { 0, 0, 0 };
  int CubesPerBlock = 1;
};

/// Lets a cube count as varying where, at a coarser level, another one that does could show in it.
void CoarsenKinds(
  const Index3& size, const Coarsening& coarsening, std::vector<SkipMap::Kind>& kinds);

/// Distances between blocks are those of a pass there and one back over their grid; within blocks
/// likewise. What lies beyond the volume is of any kind.
///
/// @param kinds    of all cubes
/// @param visible  of all blocks, 0: its cubes are hidden, whatever their kind
/// @param reach    of all cubes, as MeasureVariation() has it, or empty: those that vary but little
///                 count as constant, so far
SkipMap BuildSkipMap(const CubeGrid& grid, const std::vector<SkipMap::Kind>& kinds,
  const std::vector<std::uint8_t>& visible, const std::vector<std::uint8_t>& reach = {});

/// Replaces 0 and FarthestLeap by Chebyshev distances from what is 0, up to FarthestLeap.
void MeasureDistances(const Index3& size, std::vector<std::uint8_t>& bytes);
} // namespace flatblock
