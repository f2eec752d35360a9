#include "Relocation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using flatblock::AtlasAllocator;
using flatblock::AtlasShape;
using flatblock::BoxMove;
using flatblock::BrickPlace;

namespace
{
const std::vector<int> Sides = { 17, 9, 5, 3, 2 };

// Every texel of an atlas: the number of the block whose brick it belongs to.
class Texels
{
public:
  explicit Texels(const flatblock::Index3& size)
    : Size(size), Owners(std::size_t(size[0]) * size[1] * size[2], -1)
  {
  }

  void Fill(const flatblock::Index3& first, int side, std::int64_t owner)
  {
    this->ForEach(first, { side, side, side }, [owner](std::int64_t& o) { o = owner; });
  }

  void Move(const BoxMove& move)
  {
    std::vector<std::int64_t> box;
    this->ForEach(move.From, move.Size, [&box](std::int64_t& o) { box.push_back(o); });
    auto next = box.begin();
    this->ForEach(move.To, move.Size, [&next](std::int64_t& o) { o = *next++; });
  }

  bool IsFilled(const flatblock::Index3& first, int side, std::int64_t owner)
  {
    bool isFilled = true;
    this->ForEach(
      first, { side, side, side }, [&](std::int64_t& o) { isFilled = isFilled && o == owner; });
    return isFilled;
  }

private:
  template <typename Action>
  void ForEach(const flatblock::Index3& first, const flatblock::Index3& size, Action action)
  {
    for (int z = first[2]; z < first[2] + size[2]; ++z)
    {
      for (int y = first[1]; y < first[1] + size[1]; ++y)
      {
        for (int x = first[0]; x < first[0] + size[0]; ++x)
        {
          action(this->Owners.at((std::size_t(z) * this->Size[1] + y) * this->Size[0] + x));
        }
      }
    }
  }

  flatblock::Index3 Size;
  std::vector<std::int64_t> Owners;
};

struct Layout
{
  AtlasAllocator Atlas;
  std::vector<BrickPlace> Places;
};

// Bricks of random levels in a random order, as many as there is room for.
Layout MakeLayout(
  const AtlasShape& shape, const std::vector<std::int8_t>& levels, std::mt19937& random)
{
  Layout layout{ AtlasAllocator(shape, shape.GetDepth()), std::vector<BrickPlace>(levels.size()) };
  std::vector<std::size_t> order(levels.size());
  std::generate(order.begin(), order.end(), [n = std::size_t(0)]() mutable { return n++; });
  std::shuffle(order.begin(), order.end(), random);
  for (const std::size_t block : order)
  {
    const auto place = layout.Atlas.Allocate(levels[block]);
    layout.Places[block] = place ? *place : BrickPlace();
  }
  return layout;
}
} // namespace

TEST(Relocation, BringsEveryBrickToItsNewPlace)
{
  std::mt19937 random(17);
  const AtlasShape shape({ Sides, 60'000, 1000, 2048 });
  std::size_t moves = 0;
  std::size_t dropped = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    std::vector<std::int8_t> levels(300);
    std::generate(levels.begin(), levels.end(),
      [&random] { return static_cast<std::int8_t>(std::min(4U, unsigned(random() % 9))); });
    const Layout before = MakeLayout(shape, levels, random);
    const Layout after = MakeLayout(shape, levels, random);
    std::vector<std::uint8_t> stays(levels.size(), 0);
    Texels texels(before.Atlas.GetTextureSize());
    for (std::size_t block = 0; block < levels.size(); ++block)
    {
      stays[block] =
        before.Places[block].IsResident() && after.Places[block].IsResident() && random() % 4 != 0;
      if (stays[block])
      {
        texels.Fill(before.Atlas.GetOrigin(before.Places[block]), Sides[levels[block]],
          static_cast<std::int64_t>(block));
      }
    }
    const auto relocation =
      flatblock::Relocate(before.Atlas, before.Places, after.Atlas, after.Places, stays);
    for (const BoxMove& move : relocation.Moves)
    {
      texels.Move(move);
    }
    for (const std::int64_t block : relocation.Dropped)
    {
      ASSERT_TRUE(stays[block]);
      texels.Fill(after.Atlas.GetOrigin(after.Places[block]), Sides[levels[block]], block);
    }
    for (std::size_t block = 0; block < levels.size(); ++block)
    {
      ASSERT_TRUE(!stays[block] || texels.IsFilled(after.Atlas.GetOrigin(after.Places[block]),
                                     Sides[levels[block]], static_cast<std::int64_t>(block)))
        << "trial " << trial << ", block " << block;
    }
    moves += relocation.Moves.size();
    dropped += relocation.Dropped.size();
  }
  std::cout << moves << " moves, " << dropped << " bricks in each other's way\n";
  EXPECT_GT(moves, 4 * dropped);
}
