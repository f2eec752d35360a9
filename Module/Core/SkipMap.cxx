#include "SkipMap.h"

#include <algorithm>
#include <cstddef>

namespace flatblock
{
namespace
{
using Kind = SkipMap::Kind;
using Bytes = std::vector<std::uint8_t>;

// Rows of a grid, with one byte more at both ends, and those beyond the grid.
class Rows
{
public:
  Rows(const Index3& size, Bytes& bytes)
    : Size(size), Bytes(bytes), Beyond(static_cast<std::size_t>(size[0]), SkipMap::FarthestLeap)
  {
  }

  std::uint8_t* Get(int y, int z) const
  {
    const std::size_t row = static_cast<std::size_t>(z) * this->Size[1] + y;
    return &this->Bytes[row * this->Size[0]];
  }

  const std::uint8_t* GetOrBeyond(int y, int z) const
  {
    const bool isInside = y >= 0 && y < this->Size[1] && z >= 0 && z < this->Size[2];
    return isInside ? this->Get(y, z) : this->Beyond.data();
  }

private:
  Index3 Size;
  std::vector<std::uint8_t>& Bytes;
  std::vector<std::uint8_t> Beyond;
};

// Distances of a row by those of the rows that were done before, in y or z by `back`.
void PassRow(const Rows& rows, int length, int y, int z, int back, Bytes& nearest)
{
  const std::uint8_t* before[4] = { rows.GetOrBeyond(y - 1, z + back),
    rows.GetOrBeyond(y, z + back), rows.GetOrBeyond(y + 1, z + back),
    rows.GetOrBeyond(y + back, z) };
  std::uint8_t* least = nearest.data() + 1; // one more at both ends, of cubes beyond
  for (int x = 0; x < length; ++x)
  {
    least[x] = std::min(std::min(before[0][x], before[1][x]), std::min(before[2][x], before[3][x]));
  }
  std::uint8_t* row = rows.Get(y, z);
  for (int x = 0; x < length; ++x)
  {
    const int of3 = std::min(least[x], std::min(least[x - 1], least[x + 1])) + 1;
    row[x] = static_cast<std::uint8_t>(std::min<int>(row[x], of3));
  }
}

void PassAlong(std::uint8_t* row, int length, bool isForward)
{
  int distance = SkipMap::FarthestLeap;
  for (int i = 0; i < length; ++i)
  {
    std::uint8_t& here = row[isForward ? i : length - 1 - i];
    distance = std::min<int>(here, distance + 1);
    here = static_cast<std::uint8_t>(distance);
  }
}

void Pass(const Index3& size, Bytes& bytes, bool isForward)
{
  const Rows rows(size, bytes);
  Bytes nearest(static_cast<std::size_t>(size[0]) + 2, SkipMap::FarthestLeap);
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      const int y = isForward ? j : size[1] - 1 - j;
      const int z = isForward ? k : size[2] - 1 - k;
      PassRow(rows, size[0], y, z, isForward ? -1 : 1, nearest);
      PassAlong(rows.Get(y, z), size[0], isForward);
    }
  }
}
} // namespace

void CoarsenKinds(
  const Index3& size, const Coarsening& coarsening, std::vector<SkipMap::Kind>& kinds)
{
  Coarsen(size, coarsening, kinds, [](Kind a, Kind b) { return a == b ? a : Kind::Varying; });
}

void MeasureDistances(const Index3& size, std::vector<std::uint8_t>& bytes)
{
  Pass(size, bytes, true);
  Pass(size, bytes, false);
}

namespace
{
// The map of one block, of all blocks at once.
class BlockMapper
{
public:
  BlockMapper(
    const CubeGrid& grid, const std::vector<Kind>& kinds, const Bytes& reach, SkipMap& map)
    : Grid(grid), Kinds(kinds), Reach(reach), Map(map)
  {
  }

  void Hide(const Index3& block, std::uint8_t distance)
  {
    const auto leap = static_cast<std::uint8_t>(SkipMap::KindFactor * std::uint8_t(Kind::Hidden));
    this->ForRows(block, [&](std::size_t row, std::size_t, int length)
      { std::fill_n(&this->Map.Leaps[row], length, static_cast<std::uint8_t>(leap + distance)); });
  }

  // A cube that is the whole block.
  void MarkAlone(std::size_t cube)
  {
    const Kind kind = this->IsNear(cube) ? Kind::Constant : this->Kinds[cube];
    this->Map.Leaps[cube] =
      static_cast<std::uint8_t>(SkipMap::KindFactor * static_cast<int>(kind) + 1);
  }

  void Measure(const Index3& block)
  {
    const Index3 size = this->GetSize(block);
    Bytes& toVarying = this->ToVarying;
    Bytes& toPlain = this->ToPlain;
    toVarying.resize(static_cast<std::size_t>(size[0]) * size[1] * size[2]);
    toPlain.resize(toVarying.size());
    this->ForRows(block,
      [&](std::size_t row, std::size_t own, int length)
      {
        for (int i = 0; i < length; ++i)
        {
          const bool varies = this->Kinds[row + i] == Kind::Varying;
          toVarying[own + i] = varies ? 0 : SkipMap::FarthestLeap;
          toPlain[own + i] = varies && !this->IsNear(row + i) ? SkipMap::FarthestLeap : 0;
        }
      });
    MeasureDistances(size, toVarying);
    MeasureDistances(size, toPlain);
    this->ForRows(block,
      [&](std::size_t row, std::size_t own, int length)
      {
        for (int i = 0; i < length; ++i)
        {
          const bool isNear = this->IsNear(row + i);
          const Kind kind = isNear ? Kind::Constant : this->Kinds[row + i];
          const int distance =
            isNear ? this->Reach[row + i] : toVarying[own + i] + toPlain[own + i];
          this->Map.Leaps[row + i] =
            static_cast<std::uint8_t>(SkipMap::KindFactor * static_cast<int>(kind) + distance);
        }
      });
  }

private:
  bool IsNear(std::size_t cube) const
  {
    return this->Kinds[cube] == Kind::Varying && !this->Reach.empty() && this->Reach[cube] > 0;
  }

  Index3 GetSize(const Index3& block) const
  {
    Index3 size;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int first = block[axis] * this->Grid.CubesPerBlock;
      size[axis] = std::min(this->Grid.CubesPerBlock, this->Grid.Cubes[axis] - first);
    }
    return size;
  }

  // Calls action(first cube of the row in the volume, and in the block, cubes).
  template <typename Action>
  void ForRows(const Index3& block, const Action& action) const
  {
    const Index3 size = this->GetSize(block);
    const Index3& cubes = this->Grid.Cubes;
    const int side = this->Grid.CubesPerBlock;
    std::size_t own = 0;
    for (int z = 0; z < size[2]; ++z)
    {
      for (int y = 0; y < size[1]; ++y, own += size[0])
      {
        const std::size_t row =
          static_cast<std::size_t>(block[2] * side + z) * cubes[1] + block[1] * side + y;
        action(row * cubes[0] + block[0] * side, own, size[0]);
      }
    }
  }

  const CubeGrid& Grid;
  const std::vector<Kind>& Kinds;
  const Bytes& Reach;
  SkipMap& Map;
  Bytes ToVarying; // of the block at hand
  Bytes ToPlain;
};
} // namespace

SkipMap BuildSkipMap(const CubeGrid& grid, const std::vector<SkipMap::Kind>& kinds,
  const std::vector<std::uint8_t>& visible, const std::vector<std::uint8_t>& reach)
{
  SkipMap map{ grid.Cubes, Bytes(kinds.size()) };
  Bytes toVisible(visible.size());
  std::transform(visible.begin(), visible.end(), toVisible.begin(),
    [](std::uint8_t v) -> std::uint8_t { return v != 0 ? 0 : SkipMap::FarthestLeap; });
  MeasureDistances(grid.Blocks, toVisible);
  BlockMapper mapper(grid, kinds, reach, map);
  Index3 block = { 0, 0, 0 };
  std::size_t number = 0;
  for (block[2] = 0; block[2] < grid.Blocks[2]; ++block[2])
  {
    for (block[1] = 0; block[1] < grid.Blocks[1]; ++block[1])
    {
      for (block[0] = 0; block[0] < grid.Blocks[0]; ++block[0], ++number)
      {
        if (visible[number] == 0)
        {
          mapper.Hide(block, toVisible[number]);
        }
        else if (grid.CubesPerBlock == 1)
        {
          mapper.MarkAlone(number);
        }
        else
        {
          mapper.Measure(block);
        }
      }
    }
  }
  return map;
}
} // namespace flatblock
