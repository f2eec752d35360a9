#include "FramePlan.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using flatblock::AtlasShape;
using flatblock::BlockGrid;
using flatblock::FramePlan;
using flatblock::NoLevel;
using flatblock::Residency;

namespace
{
using Levels = std::vector<std::int8_t>;
const std::vector<int> Sides = { 17, 9, 5, 3, 2 };

AtlasShape MakeShape(std::int64_t texels, std::int64_t finestBricks)
{
  return AtlasShape({ Sides, texels, finestBricks, 2048 });
}

// A row of five blocks.
const BlockGrid Row({ 81, 17, 17 }, 17);

// What the GPU holds: the brick that begins at each texel. Whatever a move or an upload touches and
// does not bring along is gone.
class Atlas
{
public:
  void Execute(const Residency& residency, const FramePlan& plan)
  {
    if (plan.NewAtlas)
    {
      this->Bricks.clear();
    }
    for (const auto& move : plan.Moves)
    {
      this->Move(move);
    }
    this->Moves += plan.Moves.size();
    for (const auto& upload : plan.Uploads)
    {
      const auto origin = residency.GetAtlas().GetOrigin(upload.Place);
      const int side = Sides[upload.Level];
      this->Erase(origin, { side, side, side });
      this->Bricks[origin] = upload;
    }
  }

  std::size_t Moves = 0;

  void ExpectHolds(
    const BlockGrid& grid, const Residency& residency, const Levels& levels, bool continuity) const
  {
    ASSERT_EQ(residency.GetLevels(), levels);
    for (std::size_t block = 0; block < levels.size(); ++block)
    {
      ASSERT_EQ(residency.GetPlaces()[block].IsResident(), levels[block] != NoLevel);
      if (levels[block] == NoLevel)
      {
        continue;
      }
      const auto found =
        this->Bricks.find(residency.GetAtlas().GetOrigin(residency.GetPlaces()[block]));
      ASSERT_NE(found, this->Bricks.end());
      ASSERT_EQ(found->second.Block, std::int64_t(block));
      ASSERT_EQ(found->second.Level, levels[block]);
      const auto border =
        continuity ? flatblock::GetBlockBorder(grid, levels, block) : flatblock::BlockBorder{};
      ASSERT_EQ(found->second.Border, border);
    }
  }

private:
  using Held = std::map<flatblock::Index3, flatblock::BrickUpload>;

  static bool Overlap(const flatblock::Index3& a, const flatblock::Index3& sizeA,
    const flatblock::Index3& b, const flatblock::Index3& sizeB)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (a[axis] >= b[axis] + sizeB[axis] || b[axis] >= a[axis] + sizeA[axis])
      {
        return false;
      }
    }
    return true;
  }

  void Erase(const flatblock::Index3& origin, const flatblock::Index3& size)
  {
    for (auto held = this->Bricks.begin(); held != this->Bricks.end();)
    {
      const int side = Sides[held->second.Level];
      held = Overlap(origin, size, held->first, { side, side, side }) ? this->Bricks.erase(held)
                                                                      : std::next(held);
    }
  }

  void Move(const flatblock::BoxMove& move)
  {
    Held moved;
    for (const auto& [origin, brick] : this->Bricks)
    {
      const int side = Sides[brick.Level];
      if (Overlap(move.From, move.Size, origin, { side, side, side }))
      {
        flatblock::Index3 to;
        for (int axis = 0; axis < 3; ++axis)
        {
          to[axis] = origin[axis] - move.From[axis] + move.To[axis];
        }
        moved[to] = brick;
      }
    }
    this->Erase(move.To, move.Size);
    this->Bricks.insert(moved.begin(), moved.end());
  }

  Held Bricks;
};
} // namespace

TEST(FramePlan, UploadsOnlyWhatIsNew)
{
  Residency residency;
  const AtlasShape shape = MakeShape(1'000'000, 4);
  FramePlan plan = residency.Plan(Row, { 0, 0, NoLevel, 0, 0 }, shape, true);
  EXPECT_TRUE(plan.NewAtlas);
  EXPECT_EQ(plan.Uploads.size(), 4U);

  plan = residency.Plan(Row, { 0, 0, NoLevel, 0, 0 }, shape, true);
  EXPECT_FALSE(plan.NewAtlas);
  EXPECT_FALSE(plan.NewPlaces);
  EXPECT_TRUE(plan.Uploads.empty());

  plan = residency.Plan(Row, { 0, NoLevel, 0, 0, 0 }, shape, true);
  EXPECT_FALSE(plan.NewAtlas);
  EXPECT_TRUE(plan.NewPlaces);
  ASSERT_EQ(plan.Uploads.size(), 1U);
  EXPECT_EQ(plan.Uploads[0].Block, 2);
}

TEST(FramePlan, CoarserNeighboursChangeBorders)
{
  Residency residency;
  const AtlasShape shape = MakeShape(100'000, 50); // deep enough to stay
  residency.Plan(Row, { 0, 0, 0, 0, 1 }, shape, true);
  const FramePlan plan = residency.Plan(Row, { 0, 0, 0, 1, 1 }, shape, true);
  EXPECT_FALSE(plan.NewAtlas);
  ASSERT_EQ(plan.Uploads.size(), 2U); // the block itself, and the one before it
  EXPECT_EQ(plan.Uploads[0].Block, 2);
  EXPECT_EQ(plan.Uploads[0].Level, 0);
  EXPECT_EQ(plan.Uploads[1].Block, 3);
  EXPECT_EQ(plan.Uploads[1].Level, 1);
}

TEST(FramePlan, CopesWithNoBlockAtAll)
{
  Residency residency;
  const FramePlan plan = residency.Plan(Row, Levels(5, NoLevel), MakeShape(1'000'000, 0), true);
  EXPECT_TRUE(plan.NewAtlas); // so that there is a texture to bind
  EXPECT_GT(residency.GetAtlas().GetTexels(), 0);
  EXPECT_TRUE(plan.Uploads.empty());
}

TEST(FramePlan, HoldsUnderRandomLevels)
{
  std::mt19937 random(11);
  const BlockGrid grid({ 100, 90, 80 }, 17);
  const auto blocks = static_cast<std::size_t>(grid.GetNumberOfBlocks());
  const AtlasShape shape = MakeShape(250'000, 1000);
  Residency residency;
  Atlas atlas;
  Levels levels(blocks, 3);
  int newAtlases = 0;
  for (int edit = 0; edit < 1000; ++edit)
  {
    const bool continuity = edit % 7 != 0;
    for (int change = static_cast<int>(random() % 30); change > 0; --change)
    {
      Levels changed = levels;
      changed[random() % blocks] = static_cast<std::int8_t>(int(random() % 6) - 1);
      std::vector<std::int64_t> bricks(5, 0);
      for (std::int8_t level : changed)
      {
        bricks[level == NoLevel ? 4 : level] += level == NoLevel ? 0 : 1;
      }
      levels = shape.GetDepthOf(bricks) <= shape.GetDepth() ? changed : levels;
    }
    const FramePlan plan = residency.Plan(grid, levels, shape, continuity);
    newAtlases += plan.NewAtlas ? 1 : 0;
    atlas.Execute(residency, plan);
    ASSERT_NO_FATAL_FAILURE(atlas.ExpectHolds(grid, residency, levels, continuity));
  }
  EXPECT_EQ(newAtlases, 1);
  EXPECT_GT(atlas.Moves, 100U);
}
