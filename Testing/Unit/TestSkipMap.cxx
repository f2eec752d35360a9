#include "SkipMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

using flatblock::Index3;
using flatblock::SkipMap;
using Kind = SkipMap::Kind;

namespace
{
std::size_t At(const Index3& size, int x, int y, int z)
{
  return (static_cast<std::size_t>(z) * size[1] + y) * size[0] + x;
}

// By looking at all pairs.
int GetDistance(const Index3& size, const std::vector<std::uint8_t>& isZero, const Index3& from)
{
  int nearest = SkipMap::FarthestLeap;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        if (isZero[At(size, x, y, z)] != 0)
        {
          nearest = std::min(nearest,
            std::max({ std::abs(x - from[0]), std::abs(y - from[1]), std::abs(z - from[2]) }));
        }
      }
    }
  }
  return nearest;
}

template <typename Action>
void ForAll(const Index3& size, const Action& action)
{
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        action(Index3{ x, y, z });
      }
    }
  }
}

std::vector<Kind> MakeKinds(const Index3& size, double shareOfVarying, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> dice;
  std::vector<Kind> kinds(At(size, 0, 0, size[2]));
  for (Kind& kind : kinds)
  {
    const double plain = dice(random) < 0.5 ? 1.0 : 2.0;
    kind = dice(random) < shareOfVarying ? Kind::Varying : static_cast<Kind>(plain);
  }
  return kinds;
}
} // namespace

TEST(SkipMap, MeasuresDistances)
{
  unsigned seed = 0;
  for (const Index3& size : { Index3{ 1, 1, 1 }, Index3{ 90, 1, 2 }, Index3{ 7, 9, 8 },
         Index3{ 1, 17, 3 }, Index3{ 12, 5, 11 } })
  {
    for (const double share : { 0.0, 0.01, 0.3, 1.0 })
    {
      std::vector<std::uint8_t> isZero;
      std::vector<std::uint8_t> bytes;
      for (const Kind kind : MakeKinds(size, share, ++seed))
      {
        isZero.push_back(kind == Kind::Varying ? 1 : 0);
        bytes.push_back(kind == Kind::Varying ? 0 : SkipMap::FarthestLeap);
      }
      flatblock::MeasureDistances(size, bytes);
      ForAll(size, [&](const Index3& at)
        { ASSERT_EQ(bytes[At(size, at[0], at[1], at[2])], GetDistance(size, isZero, at)); });
    }
  }
}

// Cubes of visible blocks look no farther than their block; hidden blocks, over all the grid.
TEST(SkipMap, HasKindsAndDistances)
{
  const flatblock::CubeGrid grid = { { 14, 9, 8 }, { 4, 3, 2 }, 4 };
  const std::vector<Kind> kinds = MakeKinds(grid.Cubes, 0.03, 11);
  std::vector<std::uint8_t> visible(24, 0);
  visible[0] = visible[7] = visible[13] = visible[23] = 1;
  const SkipMap map = flatblock::BuildSkipMap(grid, kinds, visible);
  ForAll(grid.Cubes,
    [&](const Index3& at)
    {
      const std::size_t cube = At(grid.Cubes, at[0], at[1], at[2]);
      const Index3 block = { at[0] / 4, at[1] / 4, at[2] / 4 };
      const bool isVisible = visible[At(grid.Blocks, block[0], block[1], block[2])] != 0;
      const Kind kind = isVisible ? kinds[cube] : Kind::Hidden;
      ASSERT_EQ(map.Leaps[cube] / SkipMap::KindFactor, static_cast<int>(kind));
      int distance = GetDistance(grid.Blocks, visible, block);
      if (isVisible)
      {
        std::vector<std::uint8_t> others(kinds.size(), 0);
        ForAll(grid.Cubes,
          [&](const Index3& other)
          {
            const std::size_t i = At(grid.Cubes, other[0], other[1], other[2]);
            const bool isSameBlock = Index3{ other[0] / 4, other[1] / 4, other[2] / 4 } == block;
            const bool isOther = (kinds[i] == Kind::Varying) != (kind == Kind::Varying);
            others[i] = isSameBlock && isOther ? 1 : 0;
          });
        distance = GetDistance(grid.Cubes, others, at);
      }
      ASSERT_EQ(map.Leaps[cube] % SkipMap::KindFactor, distance);
    });
}

// A cell of the coarsest level reads samples of all the cubes in it; means, of those beside, too.
TEST(SkipMap, LetsCoarseCellsVaryAsAWhole)
{
  const Index3 size = { 10, 4, 4 };
  for (const bool isFiltered : { false, true })
  {
    std::vector<Kind> kinds(160, Kind::Transparent);
    kinds[At(size, 5, 1, 2)] = Kind::Varying;
    flatblock::CoarsenKinds(size, { 2, isFiltered }, kinds);
    const int reach = isFiltered ? 2 : 0;
    for (int z = 0; z < size[2]; ++z)
    {
      for (int y = 0; y < size[1]; ++y)
      {
        for (int x = 0; x < size[0]; ++x)
        {
          const bool isNear = x >= 4 - reach && x < 6 + reach && y < 2 + reach && z >= 2 - reach;
          EXPECT_EQ(kinds[At(size, x, y, z)] == Kind::Varying, isNear) << x << y << z;
        }
      }
    }
  }
}

TEST(SkipMap, LeavesTheFinestLevelAlone)
{
  const Index3 size = { 6, 6, 6 };
  const std::vector<Kind> kinds = MakeKinds(size, 0.2, 3);
  std::vector<Kind> coarsened = kinds;
  flatblock::CoarsenKinds(size, {}, coarsened);
  EXPECT_EQ(coarsened, kinds);
}

// Most of which the transfer function hides.
TEST(SkipMap, FourHundredThousandBlocksTakeTenMilliseconds)
{
  const flatblock::CubeGrid grid = { { 74, 74, 74 }, { 74, 74, 74 }, 1 };
  std::mt19937 random(1);
  const std::size_t blocks = std::size_t(74) * 74 * 74;
  std::vector<flatblock::SkipMap::Kind> kinds(blocks, flatblock::SkipMap::Kind::Transparent);
  std::vector<std::uint8_t> visible(blocks, 0);
  for (std::size_t i = 0; i < blocks; ++i)
  {
    const bool isVisible = random() % 10 == 0;
    visible[i] = isVisible ? 1 : 0;
    kinds[i] = isVisible ? flatblock::SkipMap::Kind::Varying : kinds[i];
  }
  std::vector<double> milliseconds;
  for (int run = 0; run < 9; ++run)
  {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(flatblock::BuildSkipMap(grid, kinds, visible).Leaps.size(), blocks);
    const std::chrono::duration<double, std::milli> taken =
      std::chrono::steady_clock::now() - begin;
    milliseconds.push_back(taken.count());
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::cout << "a map of " << blocks << " blocks: " << milliseconds[4] << " ms\n";
  EXPECT_LE(milliseconds.front(), 10.0); // the least, as others share the machine
}
