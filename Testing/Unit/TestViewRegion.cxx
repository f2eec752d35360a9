#include "ViewRegion.h"

#include <gtest/gtest.h>

#include <algorithm>

using flatblock::BlockGrid;
using flatblock::BlockRank;
using flatblock::CroppingRegions;
using flatblock::RankBlocks;
using flatblock::ViewRegion;

namespace
{
const BlockGrid Grid({ 161, 161, 161 }, 17); // 10^3 blocks of 16 cells

// How many blocks are in view of those that are visible.
std::int64_t CountInView(const ViewRegion& region)
{
  std::vector<std::uint8_t> visible(1000, 1);
  visible[0] = 0;
  const auto ranks = RankBlocks(Grid, visible, region);
  EXPECT_EQ(ranks[0], BlockRank::Transparent);
  EXPECT_EQ(std::count(ranks.begin(), ranks.end(), BlockRank::Transparent), 1);
  return std::count(ranks.begin(), ranks.end(), BlockRank::InView);
}

// The middle region from 40 to 100 along each axis, in a data set of spacing 2 whose x runs down.
ViewRegion MakeCropping(int flags)
{
  ViewRegion region;
  region.Clipping.Cropping = CroppingRegions{ { -200.0, -80.0, 80.0, 200.0, 80.0, 200.0 }, flags,
    { { { -2.0, 0.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0, 0.0 }, { 0.0, 0.0, 2.0, 0.0 } } } };
  return region;
}
} // namespace

TEST(ViewRegion, EverythingIsInViewWithoutLimits)
{
  EXPECT_EQ(CountInView({}), 999);
}

TEST(ViewRegion, PlanesCutOffWhatLiesWhollyBeyond)
{
  ViewRegion region;
  region.Clipping.Planes = { { 1.0, 0.0, 0.0, -85.0 } }; // x >= 85, in the sixth block
  EXPECT_EQ(CountInView(region), 500);
  region.Frustum.push_back({ 0.0, -2.0, 0.0, 30.0 }); // y <= 15, in the first block
  EXPECT_EQ(CountInView(region), 50);
  region.Frustum.clear();
  region.Clipping.Planes = { { -1.0, -1.0, -1.0,
    17.0 } }; // a corner: the first block and its neighbours
  EXPECT_EQ(CountInView(region), 3);
}

TEST(ViewRegion, CroppingRegionsThatAreNotShownAreOutOfView)
{
  constexpr int SubVolume = 0x2000;
  EXPECT_EQ(CountInView(MakeCropping(SubVolume)), 5 * 5 * 5); // blocks 2 to 6
  EXPECT_EQ(CountInView(MakeCropping(0x7ffffff)), 999);
  EXPECT_EQ(CountInView(MakeCropping(0)), 0);
  // All but the middle: hidden are the blocks that lie wholly in it, 3 to 5.
  EXPECT_EQ(CountInView(MakeCropping(0x7ffffff & ~SubVolume)), 999 - 3 * 3 * 3);
}
