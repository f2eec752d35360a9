#include "AtlasAllocator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
  EXPECT_LE(atlas.GetUsedTexels() + atlas.GetFreeTexels(), atlas.GetTexels());
  EXPECT_GE(atlas.GetUsedTexels() + atlas.GetFreeTexels(), atlas.GetTexels() * 90 / 100);
  for (auto& [level, places] : held)
  {
    for (const BrickPlace& place : places)
    {
      atlas.Free(place);
    }
  }
  EXPECT_EQ(atlas.GetUsedTexels(), 0);
  EXPECT_EQ(atlas.GetFreeTexels(), atlas.GetTexels());
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

// After compaction only what is too little for the brick that is asked for is left over.
TEST(AtlasAllocator, CompactionMakesRoomForWhateverFits)
{
  std::mt19937 random(9);
  const AtlasShape shape({ Sides33, 3'000'000, 100000, 2048 });
  AtlasAllocator atlas(shape, shape.GetDepth());
  std::vector<std::vector<BrickPlace>> held(6);
  const auto count = [&held](int level)
  {
    std::vector<std::int64_t> bricks;
    for (const auto& places : held)
    {
      bricks.push_back(static_cast<std::int64_t>(places.size()));
    }
    ++bricks[level];
    return bricks;
  };
  int compactions = 0;
  for (int step = 0; step < 200000; ++step)
  {
    const int level = static_cast<int>(random() % 6);
    auto& places = held[level];
    if (!places.empty() && random() % 100 < 48)
    {
      std::swap(places[random() % places.size()], places.back());
      atlas.Free(places.back());
      places.pop_back();
      continue;
    }
    auto place = atlas.Allocate(level);
    if (!place)
    {
      const bool fits = shape.GetDepthOf(count(level)) <= shape.GetDepth();
      std::map<BrickPlace, BrickPlace> moved;
      for (const auto& [from, to] : atlas.Compact().NewPlaces)
      {
        moved[from] = to;
      }
      for (auto& others : held)
      {
        for (BrickPlace& other : others)
        {
          for (auto next = moved.find(other); next != moved.end(); next = moved.find(other))
          {
            other = next->second;
            moved.erase(next);
          }
        }
      }
      ++compactions;
      place = atlas.Allocate(level);
      ASSERT_EQ(place.has_value(), fits) << "step " << step;
    }
    if (place)
    {
      places.push_back(*place);
    }
  }
  EXPECT_GT(compactions, 0);
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
