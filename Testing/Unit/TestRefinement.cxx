#include "LodSelector.h"
#include "Refinement.h"

#include <gtest/gtest.h>

#include <random>

using flatblock::AtlasShape;
using flatblock::BlockGrid;
using flatblock::NoLevel;
using flatblock::RefinementBudget;
using flatblock::StepTowards;

namespace
{
using Levels = std::vector<std::int8_t>;
const BlockGrid Grid({ 161, 161, 161 }, 17); // 10^3 blocks
const std::vector<std::uint8_t> AllVisible(1000, 1);

AtlasShape MakeShape(std::int64_t texels)
{
  return AtlasShape({ { 17, 9, 5, 3, 2 }, texels, 1000, 2048 });
}

bool Fits(const AtlasShape& shape, const Levels& levels)
{
  std::vector<std::int64_t> bricks(5, 0);
  for (std::int8_t level : levels)
  {
    bricks[level == NoLevel ? 0 : level] += level == NoLevel ? 0 : 1;
  }
  return shape.GetDepthOf(bricks) <= shape.GetDepth();
}

Levels Select(const AtlasShape& shape, double x)
{
  flatblock::LodCriteria criteria;
  criteria.PointOfInterest = { x, 80.0, 80.0 };
  return *flatblock::SelectLevels(Grid, shape, AllVisible, criteria);
}
} // namespace

TEST(Refinement, ReachesTheTargetWithinBudgetAndShape)
{
  std::mt19937 random(2);
  for (std::int64_t texels : { 150'000, 600'000, 2'000'000, 20'000'000 })
  {
    const AtlasShape shape = MakeShape(texels);
    const RefinementBudget budget{ 50, 40'000 };
    Levels levels;
    for (double x : { -50.0, 200.0, 80.0 })
    {
      const Levels target = Select(shape, x);
      const bool isThere = levels == target;
      int steps = 0;
      int large = 0;
      while (levels != target)
      {
        ASSERT_LT(steps++, 2000);
        const Levels next = StepTowards(Grid, shape, levels, target, budget);
        ASSERT_TRUE(Fits(shape, next));
        int changes = 0;
        for (std::size_t block = 0; block < levels.size(); ++block)
        {
          changes += levels[block] != next[block] ? 1 : 0;
        }
        ASSERT_TRUE(changes > 0 || levels.empty());
        large += !levels.empty() && changes > budget.Blocks ? 1 : 0;
        levels = next;
      }
      EXPECT_TRUE(isThere || steps > 2);
      EXPECT_LE(large, 1) << texels << " " << x; // where only all changes together fit
    }
  }
}

TEST(Refinement, NewBlocksComeAtOnceAndHiddenOnesGo)
{
  const AtlasShape shape = MakeShape(20'000'000);
  Levels current(1000, 0);
  current[3] = NoLevel;
  Levels target(1000, 0);
  target[7] = NoLevel;
  const Levels next = StepTowards(Grid, shape, current, target, { 0, 0 });
  EXPECT_EQ(next[7], NoLevel);
  EXPECT_NE(next[3], NoLevel);
}
