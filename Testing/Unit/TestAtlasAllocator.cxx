#include "AtlasAllocator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

using flatblock::AtlasAllocator;
using flatblock::AtlasShape;
using flatblock::BrickPlace;
using flatblock::Index3;

namespace
{
const std::vector<int> Sides33 = { 33, 17, 9, 5, 3, 2 };

// The box of texels of a brick.
struct Box
{
  Index3 First;
  int Side;

  bool Overlaps(const Box& other) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->First[axis] >= other.First[axis] + other.Side ||
          other.First[axis] >= this->First[axis] + this->Side)
      {
        return false;
      }
    }
    return true;
  }
};

Box GetBox(const AtlasAllocator& atlas, const BrickPlace& place)
{
  return { atlas.GetOrigin(place), atlas.GetShape().GetSide(atlas.GetLevel(place)) };
}
} // namespace

TEST(AtlasShape, WastesLittleAtEveryLevel)
{
  for (const std::vector<int>& sides :
    { std::vector<int>{ 17, 9, 5, 3, 2 }, Sides33, { 65, 33, 17, 9, 5, 3, 2 } })
  {
    const std::int64_t texels = std::int64_t(256) << 20;
    const AtlasShape shape({ sides, texels, 1'000'000, 2048 });
    const std::int64_t area = std::int64_t(shape.GetWidth()) * shape.GetHeight();
    EXPECT_LE(area * shape.GetDepth(), texels);
    EXPECT_GE(area * shape.GetDepth(), texels * 99 / 100);
    double loss = 0.0;
    for (int level = 0; level < 3; ++level)
    {
      const double used = double(shape.GetBricksPerSlab(level)) * sides[level] * sides[level];
      loss += 0.75 * std::pow(0.25, level) * (1.0 - used / double(area));
    }
    EXPECT_LE(loss, 0.04) << sides[0] << ": " << shape.GetWidth() << " x " << shape.GetHeight();
  }
}

TEST(AtlasShape, IsHardlyLargerThanTheFinestBricks)
{
  for (std::int64_t bricks : { 1, 2, 7, 61, 100, 997 })
  {
    const AtlasShape shape({ Sides33, std::int64_t(256) << 20, bricks, 2048 });
    const std::int64_t texels =
      shape.GetDepthOf({ bricks, 0, 0, 0, 0, 0 }) * shape.GetWidth() * shape.GetHeight();
    EXPECT_LE(texels, bricks * 33 * 33 * 33 * 103 / 100) << bricks << " bricks";
  }
}

TEST(AtlasAllocator, PlacesNeverOverlapNorLeak)
{
  std::mt19937 random(3);
  const AtlasShape shape({ Sides33, 3'000'000, 1000, 2048 });
  AtlasAllocator atlas(shape, shape.GetDepth());
  std::map<int, std::vector<BrickPlace>> held; // by level
  std::vector<std::int64_t> counts(6, 0);
  for (int step = 0; step < 20000; ++step)
  {
    const int level = static_cast<int>(random() % 6);
    auto& places = held[level];
    if (random() % 5 < 2 && !places.empty())
    {
      std::swap(places[random() % places.size()], places.back());
      atlas.Free(places.back());
      places.pop_back();
      --counts[level];
      continue;
    }
    const auto place = atlas.Allocate(level);
    if (!place)
    {
      continue;
    }
    const Box box = GetBox(atlas, *place);
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_GE(box.First[axis], 0);
      ASSERT_LE(box.First[axis] + box.Side, atlas.GetTextureSize()[axis]);
    }
    if (step % 50 == 0)
    {
      for (const auto& [otherLevel, others] : held)
      {
        for (const BrickPlace& other : others)
        {
          ASSERT_FALSE(box.Overlaps(GetBox(atlas, other)));
        }
      }
    }
    places.push_back(*place);
    ++counts[level];
  }
  std::int64_t used = 0;
  for (int level = 0; level < 6; ++level)
  {
    used += counts[level] * shape.GetSide(level) * shape.GetSide(level) * shape.GetSide(level);
  }
  EXPECT_EQ(atlas.GetUsedTexels(), used);
  const std::vector<bool> all(6, true);
  EXPECT_LE(atlas.GetUsedTexels() + atlas.GetFreeTexels(all), atlas.GetTexels());
  EXPECT_GE(atlas.GetUsedTexels() + atlas.GetFreeTexels(all), atlas.GetTexels() * 90 / 100);
  for (auto& [level, places] : held)
  {
    for (const BrickPlace& place : places)
    {
      atlas.Free(place);
    }
  }
  EXPECT_EQ(atlas.GetUsedTexels(), 0);
  EXPECT_EQ(atlas.GetFreeTexels(all), atlas.GetTexels());
  EXPECT_TRUE(atlas.Allocate(0)); // all slabs are gone: there is room for the thickest
}

TEST(AtlasAllocator, HoldsWhatTheShapeSays)
{
  const AtlasShape shape({ Sides33, 5'000'000, 1000, 2048 });
  std::vector<std::int64_t> bricks = { 20, 60, 100, 0, 500, 40 };
  ASSERT_LE(shape.GetDepthOf(bricks), shape.GetDepth());
  AtlasAllocator atlas(shape, static_cast<int>(shape.GetDepthOf(bricks)));
  for (int level = 0; level < 6; ++level)
  {
    for (std::int64_t i = 0; i < bricks[level]; ++i)
    {
      ASSERT_TRUE(atlas.Allocate(level)) << level << " " << i;
    }
  }
}

namespace
{
// Blocks with bricks in an atlas, and who owns each texel of it.
class Model
{
public:
  Model(const AtlasShape& shape, bool watchTexels)
    : Shape(shape), Atlas(shape, shape.GetDepth()), Bricks(shape.GetNumberOfLevels(), 0)
  {
    this->Owners.resize(watchTexels ? this->Atlas.GetTexels() : 0, -1);
  }

  // Gives a block a brick of another level, -1 for none; false where there is no room.
  bool SetLevel(int block, int level)
  {
    Held& held = this->Blocks[block];
    this->Bricks[std::max(held.Level, 0)] -= held.Level >= 0 ? 1 : 0;
    this->Bricks[std::max(level, 0)] += level >= 0 ? 1 : 0;
    if (this->Shape.GetDepthOf(this->Bricks) > this->Shape.GetDepth())
    {
      this->Bricks[std::max(held.Level, 0)] += held.Level >= 0 ? 1 : 0;
      this->Bricks[std::max(level, 0)] -= level >= 0 ? 1 : 0;
      return false;
    }
    if (held.Level >= 0)
    {
      this->Own(held, block, -1);
      this->Atlas.Free(held.Place);
    }
    held.Level = level;
    if (level >= 0)
    {
      auto place = this->Atlas.Allocate(level);
      if (!place)
      {
        held.Level = -1; // has no place yet
        this->Compact();
        held.Level = level;
        place = this->Atlas.Allocate(level);
      }
      held.Place = place.value(); // whatever fits is placed
      this->Own(held, -1, block);
    }
    return true;
  }

  int GetLevel(int block) { return this->Blocks[block].Level; }
  std::int64_t GetWaste() const
  {
    std::vector<bool> wanted(this->Shape.GetNumberOfLevels(), false);
    for (std::size_t level = 1; level < this->Bricks.size(); ++level)
    {
      wanted[level - 1] = this->Bricks[level] > 0;
    }
    return this->Shape.GetMostTexels() - this->Atlas.GetUsedTexels() -
           this->Atlas.GetFreeTexels(wanted);
  }
  std::int64_t GetUsed() const
  {
    std::int64_t texels = 0;
    for (int level = 0; level < this->Shape.GetNumberOfLevels(); ++level)
    {
      const std::int64_t side = this->Shape.GetSide(level);
      texels += this->Bricks[level] * side * side * side;
    }
    return texels;
  }

  AtlasShape Shape;
  AtlasAllocator Atlas;
  int Compactions = 0;

private:
  struct Held
  {
    int Level = -1;
    BrickPlace Place;
  };

  // Takes over the texels of a brick, all of which must belong to `from`.
  void Own(const Held& held, int from, int to)
  {
    if (this->Owners.empty())
    {
      return;
    }
    const Box box = GetBox(this->Atlas, held.Place);
    const Index3 size = this->Atlas.GetTextureSize();
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_GE(box.First[axis], 0);
      ASSERT_LE(box.First[axis] + box.Side, size[axis]);
    }
    for (int z = box.First[2]; z < box.First[2] + box.Side; ++z)
    {
      for (int y = box.First[1]; y < box.First[1] + box.Side; ++y)
      {
        const auto row =
          this->Owners.begin() + (std::int64_t(z) * size[1] + y) * size[0] + box.First[0];
        ASSERT_EQ(std::count(row, row + box.Side, from), box.Side);
        std::fill_n(row, box.Side, to);
      }
    }
  }

  void Compact()
  {
    ++this->Compactions;
    for (auto& [block, held] : this->Blocks)
    {
      if (held.Level >= 0)
      {
        this->Own(held, block, -1);
      }
    }
    std::map<BrickPlace, BrickPlace> moved;
    for (const auto& [from, to] :
      this->Atlas.Compact(std::numeric_limits<std::int64_t>::max()).NewPlaces)
    {
      moved[from] = to;
    }
    for (auto& [block, held] : this->Blocks)
    {
      if (held.Level < 0)
      {
        continue;
      }
      for (auto next = moved.find(held.Place); next != moved.end(); next = moved.find(held.Place))
      {
        held.Place = next->second;
        moved.erase(next);
      }
      this->Own(held, -1, block);
    }
  }

  std::map<int, Held> Blocks;
  std::vector<std::int64_t> Bricks;
  std::vector<int> Owners;
};

// Refines blocks in turn until none fits any more.
void RefineAll(Model& model, int blocks)
{
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    for (int block = 0; block < blocks; ++block)
    {
      while (model.GetLevel(block) > 0 && model.SetLevel(block, model.GetLevel(block) - 1))
      {
        isChanged = true;
      }
    }
  }
}
} // namespace

TEST(AtlasAllocator, AMillionOperationsKeepEveryTexelToItsBrick)
{
  std::mt19937 random(9);
  Model model(AtlasShape({ { 17, 9, 5, 3, 2 }, 120'000, 1000, 2048 }), true);
  constexpr int Blocks = 300;
  for (int step = 0; step < 1'000'000 && !HasFailure(); ++step)
  {
    const int block = static_cast<int>(random() % Blocks);
    const int level = model.GetLevel(block);
    switch (random() % 8)
    {
    case 0: // come and go
      model.SetLevel(block, level < 0 ? static_cast<int>(random() % 5) : -1);
      break;
    case 1:
    case 2:
    case 3: // collapse
      model.SetLevel(block, level < 0 ? -1 : std::min(level + 1, 4));
      break;
    default: // refine
      model.SetLevel(block, std::max(level - 1, std::min(level, 0)));
    }
    if (step % 1000 == 0)
    {
      ASSERT_EQ(model.Atlas.GetUsedTexels(), model.GetUsed());
    }
  }
  EXPECT_GT(model.Compactions, 50);
  for (int block = 0; block < Blocks; ++block)
  {
    model.SetLevel(block, -1);
  }
  EXPECT_EQ(model.Atlas.GetUsedTexels(), 0);
}

// What is neither used nor of use, as a share of the limit, once all that fits was refined.
TEST(AtlasAllocator, WastesLittleAfterAnySequence)
{
  struct Case
  {
    std::vector<int> Sides;
    int Megatexels;
    double MostWaste;
  };
  const std::vector<int> sides65 = { 65, 33, 17, 9, 5, 3, 2 };
  const std::vector<int> sides17 = { 17, 9, 5, 3, 2 };
  for (const Case& c : { Case{ sides17, 16, 0.03 }, { sides17, 64, 0.03 }, { Sides33, 32, 0.05 },
         { Sides33, 64, 0.04 }, { Sides33, 128, 0.03 }, { Sides33, 256, 0.03 },
         { sides65, 128, 0.05 }, { sides65, 256, 0.05 } })
  {
    std::mt19937 random(21);
    const std::int64_t texels = std::int64_t(c.Megatexels) << 20;
    const int blocks = static_cast<int>(4 * texels / std::pow(c.Sides[0], 3));
    Model model(AtlasShape({ c.Sides, texels, blocks, 2048 }), false);
    double worst = 0.0;
    for (int block = 0; block < blocks; ++block)
    {
      model.SetLevel(block, 3);
    }
    for (int round = 0; round < 8; ++round)
    {
      for (int step = 0; step < blocks; ++step)
      {
        const int block = static_cast<int>(random() % blocks);
        const int level = model.GetLevel(block) + (random() % 3 == 0 ? -1 : 1);
        model.SetLevel(block, std::clamp(level, 0, 3));
      }
      RefineAll(model, blocks);
      worst = std::max(worst, double(model.GetWaste()) / double(texels));
    }
    std::cout << "blocks of " << c.Sides[0] << ", " << c.Megatexels << " Mi texels ("
              << model.Shape.GetWidth() << " x " << model.Shape.GetHeight()
              << "): " << 100.0 * worst << " % wasted\n";
    EXPECT_LE(worst, c.MostWaste);
  }
}

TEST(AtlasAllocator, HandsOutFreedPlacesAgain)
{
  AtlasAllocator atlas(AtlasShape({ Sides33, 33 * 33 * 33 * 2, 2, 2048 }), 33);
  const auto first = atlas.Allocate(0);
  ASSERT_TRUE(first);
  while (atlas.Allocate(0))
  {
  }
  atlas.Free(*first);
  EXPECT_EQ(atlas.Allocate(0), first);
  EXPECT_FALSE(atlas.Allocate(0));
}
