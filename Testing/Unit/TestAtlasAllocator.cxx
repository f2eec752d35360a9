#include "AtlasAllocator.h"

#include <gtest/gtest.h>

#include <set>

using flatblock::AtlasAllocator;
using flatblock::Index3;

TEST(AtlasAllocator, FindsAShapeThatFitsWithLittleLeftOver)
{
  for (int side : { 17, 33, 65 })
  {
    for (std::int64_t bricks : { 0, 1, 2, 7, 61, 100, 997, 1200, 9973 })
    {
      const auto shape = AtlasAllocator::FindShape(bricks, side, 2048);
      ASSERT_TRUE(shape) << bricks << " bricks of " << side;
      const Index3 n = *shape;
      const std::int64_t places = std::int64_t(n[0]) * n[1] * n[2];
      EXPECT_GE(places, bricks);
      EXPECT_LE(places, std::max<std::int64_t>(bricks, 1) * 103 / 100) << bricks << " bricks";
      for (int texels : { n[0] * side, n[1] * side, n[2] * side })
      {
        EXPECT_LE(texels, 2048);
      }
    }
  }
}

TEST(AtlasAllocator, SaysWhenNoTextureIsLargeEnough)
{
  EXPECT_TRUE(AtlasAllocator::FindShape(27, 17, 51));
  EXPECT_FALSE(AtlasAllocator::FindShape(28, 17, 51));
  EXPECT_FALSE(AtlasAllocator::FindShape(1, 65, 64));
}

TEST(AtlasAllocator, PlacesDoNotOverlap)
{
  AtlasAllocator atlas({ 3, 4, 5 }, 17);
  EXPECT_EQ(atlas.GetTextureSize(), (Index3{ 51, 68, 85 }));
  std::set<Index3> origins;
  while (atlas.GetNumberOfFreePlaces() > 0)
  {
    const Index3 origin = atlas.GetOrigin(atlas.Allocate());
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(origin[axis] % 17, 0);
      EXPECT_LE(origin[axis] + 17, atlas.GetTextureSize()[axis]);
    }
    EXPECT_TRUE(origins.insert(origin).second);
  }
  EXPECT_EQ(origins.size(), 60U);
  EXPECT_EQ(atlas.GetCapacity(), 60);
}

TEST(AtlasAllocator, HandsOutFreedPlacesAgain)
{
  AtlasAllocator atlas({ 2, 1, 1 }, 17);
  const int first = atlas.Allocate();
  atlas.Allocate();
  EXPECT_EQ(atlas.GetNumberOfFreePlaces(), 0);
  atlas.Free(first);
  EXPECT_EQ(atlas.Allocate(), first);
}
