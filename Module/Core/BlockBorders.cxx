#include "BlockBorders.h"

#include <algorithm>
#include <cstdlib>

namespace flatblock
{
namespace
{
constexpr int Middle = 13;

Index3 GetDirection(int index)
{
  return { index % 3 - 1, index / 3 % 3 - 1, index / 9 - 1 };
}

int CountAxes(int index)
{
  const Index3 d = GetDirection(index);
  return std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
}

// Whether the face, edge or corner is part of, or is, the other one.
bool LiesOn(int index, int other)
{
  const Index3 part = GetDirection(index);
  const Index3 whole = GetDirection(other);
  bool lies = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    lies = lies && (whole[axis] == 0 || whole[axis] == part[axis]);
  }
  return lies;
}

// A face, edge or corner, and one on which it lies: itself to begin with.
struct Pair
{
  int Part;
  int Whole;
};

std::vector<Pair> FindPairs(int mostAxes)
{
  std::vector<Pair> pairs;
  for (int part = 0; part < 27; ++part)
  {
    for (int whole = 0; whole < 27; ++whole)
    {
      if (part != Middle && whole != Middle && CountAxes(part) <= mostAxes && LiesOn(part, whole))
      {
        pairs.push_back({ part, whole });
      }
    }
  }
  return pairs;
}

const std::vector<Pair> FacesAndEdges = FindPairs(2);
const std::vector<Pair> AllPairs = FindPairs(3);

// Levels of the block and its neighbours; the block's own where there is no neighbour, or a finer
// one.
BlockBorder GetCoarserNeighbours(
  const BlockGrid& grid, const std::vector<std::int8_t>& levels, std::int64_t block)
{
  const Index3 position = grid.GetPosition(block);
  const Index3& blocks = grid.GetBlocks();
  BlockBorder around;
  int index = 0;
  for (int z = position[2] - 1; z <= position[2] + 1; ++z)
  {
    for (int y = position[1] - 1; y <= position[1] + 1; ++y)
    {
      for (int x = position[0] - 1; x <= position[0] + 1; ++x)
      {
        const bool isInside =
          x >= 0 && y >= 0 && z >= 0 && x < blocks[0] && y < blocks[1] && z < blocks[2];
        const std::int8_t level = isInside ? levels[grid.GetBlock({ x, y, z })] : levels[block];
        around[index++] = std::max(level, levels[block]);
      }
    }
  }
  return around;
}
} // namespace

BlockBorder GetBlockBorder(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
  std::int64_t block, Continuity continuity)
{
  BlockBorder border = {};
  if (continuity == Continuity::Off)
  {
    return border;
  }
  const BlockBorder around = GetCoarserNeighbours(grid, levels, block);
  const std::int8_t own = levels[block];
  if (std::all_of(around.begin(), around.end(), [own](std::int8_t level) { return level == own; }))
  {
    return border;
  }
  for (const auto& [part, whole] : continuity == Continuity::Filtered ? AllPairs : FacesAndEdges)
  {
    border[part] = std::max<std::int8_t>(border[part], around[whole] - own);
  }
  return border;
}

BrickParts GetChangedParts(const BlockBorder& before, const BlockBorder& after)
{
  BrickParts differ = 0;
  for (int part = 0; part < 27; ++part)
  {
    differ |= before[part] != after[part] ? 1U << part : 0U;
  }
  // What is interpolated follows its own edges and corners.
  BrickParts changed = differ;
  for (const auto& [part, whole] : AllPairs)
  {
    changed |= (differ >> part & 1U) != 0 && after[whole] > 0 ? 1U << whole : 0U;
  }
  BrickParts parts = changed;
  for (const auto& [part, whole] : AllPairs)
  {
    parts &= part != whole && (changed >> whole & 1U) != 0 ? ~(1U << part) : ~0U;
  }
  return parts;
}

std::vector<BrickBox> GetBoxes(BrickParts parts, int side, int apron)
{
  std::vector<BrickBox> boxes;
  for (int part = 0; part < 27; ++part)
  {
    if ((parts >> part & 1U) != 0)
    {
      const Index3 direction = GetDirection(part);
      const bool isWhole = (1U << part) == WholeBrick;
      BrickBox box;
      for (int axis = 0; axis < 3; ++axis)
      {
        box.First[axis] = (isWhole ? 0 : apron) + (direction[axis] > 0 ? side - 1 : 0);
        box.Size[axis] = direction[axis] == 0 ? side + (isWhole ? 2 * apron : 0) : 1;
      }
      boxes.push_back(box);
    }
  }
  return boxes;
}

std::int64_t CountTexels(BrickParts parts, int side)
{
  std::int64_t texels = 0;
  for (const BrickBox& box : GetBoxes(parts, side))
  {
    texels += static_cast<std::int64_t>(box.Size[0]) * box.Size[1] * box.Size[2];
  }
  return texels;
}

std::vector<std::uint8_t> FindTouched(const BlockGrid& grid, const std::vector<std::int8_t>& before,
  const std::vector<std::int8_t>& after)
{
  std::vector<std::uint8_t> touched(after.size(), 0);
  const Index3& blocks = grid.GetBlocks();
  for (std::size_t block = 0; block < after.size(); ++block)
  {
    if (before[block] == after[block])
    {
      continue;
    }
    const Index3 p = grid.GetPosition(static_cast<std::int64_t>(block));
    for (int z = std::max(p[2] - 1, 0); z <= std::min(p[2] + 1, blocks[2] - 1); ++z)
    {
      for (int y = std::max(p[1] - 1, 0); y <= std::min(p[1] + 1, blocks[1] - 1); ++y)
      {
        const std::int64_t row = grid.GetBlock({ 0, y, z });
        std::fill(touched.begin() + row + std::max(p[0] - 1, 0),
          touched.begin() + row + std::min(p[0] + 1, blocks[0] - 1) + 1, std::uint8_t(1));
      }
    }
  }
  return touched;
}
} // namespace flatblock
