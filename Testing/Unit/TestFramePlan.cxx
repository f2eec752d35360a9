#include "FramePlan.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using flatblock::AtlasShape;
using flatblock::BlockGrid;
using flatblock::BrickPlace;
using flatblock::BrickUpload;
using flatblock::Continuity;
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
      if (upload.Parts == flatblock::WholeBrick)
      {
        this->Erase(origin, { side, side, side });
        this->Bricks[origin] = upload;
      }
      else
      {
        this->UpdateBorder(this->Bricks.at(origin), upload);
      }
    }
  }

  std::size_t Moves = 0;

  void ExpectHolds(const BlockGrid& grid, const Residency& residency, const Levels& levels,
    Continuity continuity) const
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
      ASSERT_EQ(found->second.Border, flatblock::GetBlockBorder(grid, levels, block, continuity));
    }
  }

private:
  // Only what is sent arrives: a face with its edges, an edge with its corners.
  static void UpdateBorder(BrickUpload& held, const BrickUpload& sent)
  {
    ASSERT_EQ(held.Block, sent.Block);
    ASSERT_EQ(held.Level, sent.Level);
    for (int part = 0; part < 27; ++part)
    {
      for (int whole = 0; whole < 27; ++whole)
      {
        bool isCarried = (sent.Parts >> whole & 1U) != 0;
        for (int p = part, w = whole, axis = 0; axis < 3; ++axis, p /= 3, w /= 3)
        {
          isCarried = isCarried && (w % 3 == 1 || w % 3 == p % 3);
        }
        held.Border[part] = isCarried ? sent.Border[part] : held.Border[part];
      }
    }
  }

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
  const auto still = [&](const Levels& levels)
  { return residency.PlanStill(Row, levels, shape, Continuity::Nested); };
  FramePlan plan = still({ 0, 0, NoLevel, 0, 0 });
  EXPECT_TRUE(plan.NewAtlas);
  EXPECT_EQ(plan.Uploads.size(), 4U);

  EXPECT_TRUE(still({ 0, 0, NoLevel, 0, 0 }).IsEmpty());

  plan = still({ 0, NoLevel, 0, 0, 0 });
  EXPECT_FALSE(plan.NewAtlas);
  EXPECT_TRUE(plan.NewPlaces);
  ASSERT_EQ(plan.Uploads.size(), 1U);
  EXPECT_EQ(plan.Uploads[0].Block, 2);
}

TEST(FramePlan, CoarserNeighboursChangeBordersOnly)
{
  Residency residency;
  const AtlasShape shape = MakeShape(100'000, 50); // deep enough to stay
  residency.PlanStill(Row, { 0, 0, 0, 0, 1 }, shape, Continuity::Nested);
  const FramePlan plan = residency.PlanStill(Row, { 0, 0, 0, 1, 1 }, shape, Continuity::Nested);
  EXPECT_FALSE(plan.NewAtlas);
  ASSERT_EQ(plan.Uploads.size(), 2U); // the block itself, and the face of the one before it
  EXPECT_EQ(plan.Uploads[0].Block, 2);
  EXPECT_EQ(plan.Uploads[0].Level, 0);
  EXPECT_EQ(flatblock::CountTexels(plan.Uploads[0].Parts, 17), 17 * 17);
  EXPECT_EQ(plan.Uploads[1].Block, 3);
  EXPECT_EQ(plan.Uploads[1].Level, 1);
  EXPECT_EQ(plan.Uploads[1].Parts, flatblock::WholeBrick);
}

TEST(FramePlan, CopesWithNoBlockAtAll)
{
  Residency residency;
  const FramePlan plan =
    residency.PlanStill(Row, Levels(5, NoLevel), MakeShape(1'000'000, 0), Continuity::Nested);
  EXPECT_TRUE(plan.NewAtlas); // so that there is a texture to bind
  EXPECT_GT(residency.GetAtlas().GetTexels(), 0);
  EXPECT_TRUE(plan.Uploads.empty());
}

namespace
{
constexpr std::int64_t StepTexels = 20'000;
const BlockGrid Walked({ 100, 90, 80 }, 17);
const auto WalkedBlocks = static_cast<std::size_t>(Walked.GetNumberOfBlocks());

// Changes some levels of some blocks, as far as they fit.
void Change(Levels& levels, const AtlasShape& shape, std::mt19937& random)
{
  for (int change = static_cast<int>(random() % 30); change > 0; --change)
  {
    Levels changed = levels;
    changed[random() % WalkedBlocks] = static_cast<std::int8_t>(int(random() % 6) - 1);
    const bool fits = shape.GetDepthOf(flatblock::CountBricks(changed, shape)) <= shape.GetDepth();
    levels = fits ? changed : levels;
  }
}

std::int64_t CountMovedTexels(const FramePlan& plan)
{
  std::int64_t texels = 0;
  for (const auto& move : plan.Moves)
  {
    texels += std::int64_t(move.Size[0]) * move.Size[1] * move.Size[2];
  }
  return texels;
}
} // namespace

TEST(FramePlan, StillsForgetTheirHistory)
{
  std::mt19937 random(11);
  const AtlasShape shape = MakeShape(250'000, 1000);
  const std::vector<std::uint16_t> order(WalkedBlocks, 0);
  Residency residency;
  Atlas atlas;
  Levels levels(WalkedBlocks, 3);
  for (int edit = 0; edit < 1000; ++edit)
  {
    const Continuity continuity = edit % 7 != 0 ? Continuity::Nested : Continuity::Off;
    Change(levels, shape, random);
    if (edit % 3 != 0)
    {
      atlas.Execute(
        residency, residency.PlanStep(Walked, levels, order, shape, continuity, { 5, StepTexels }));
      ASSERT_NO_FATAL_FAILURE(
        atlas.ExpectHolds(Walked, residency, residency.GetLevels(), continuity));
      continue;
    }
    const FramePlan plan = residency.PlanStill(Walked, levels, shape, continuity);
    atlas.Execute(residency, plan);
    ASSERT_NO_FATAL_FAILURE(atlas.ExpectHolds(Walked, residency, levels, continuity));
    Residency fresh;
    fresh.PlanStill(Walked, levels, shape, continuity);
    ASSERT_EQ(fresh.GetPlaces(), residency.GetPlaces()) << edit;
    ASSERT_EQ(fresh.GetAtlas().GetTextureSize(), residency.GetAtlas().GetTextureSize());
    for (std::size_t block = 0; block < WalkedBlocks; ++block)
    {
      ASSERT_TRUE(
        levels[block] == NoLevel || fresh.GetAtlas().GetOrigin(fresh.GetPlaces()[block]) ==
                                      residency.GetAtlas().GetOrigin(residency.GetPlaces()[block]));
    }
  }
  EXPECT_GT(atlas.Moves, 1000U);
}

TEST(FramePlan, StepsKeepTheirBudgetAndArrive)
{
  std::mt19937 random(12);
  const AtlasShape shape = MakeShape(150'000, 1000);
  const std::vector<std::uint16_t> order(WalkedBlocks, 0);
  Residency residency;
  Atlas atlas;
  Levels levels(WalkedBlocks, 3);
  std::int64_t frames = 0;
  std::int64_t large = 0;
  for (int edit = 0; edit < 1500; ++edit)
  {
    Change(levels, shape, random);
    for (int left = 500; residency.GetLevels() != levels; --left)
    {
      ASSERT_GT(left, 0) << "never arrives";
      const FramePlan plan =
        residency.PlanStep(Walked, levels, order, shape, Continuity::Nested, { 5, StepTexels });
      ASSERT_FALSE(plan.IsEmpty());
      std::int64_t texels = 0;
      for (const BrickUpload& upload : plan.Uploads)
      {
        texels += flatblock::CountTexels(upload.Parts, Sides[upload.Level]);
      }
      ++frames;
      large += std::max(texels, CountMovedTexels(plan)) > StepTexels ? 1 : 0;
      atlas.Execute(residency, plan);
      ASSERT_NO_FATAL_FAILURE(
        atlas.ExpectHolds(Walked, residency, residency.GetLevels(), Continuity::Nested));
    }
  }
  std::cout << frames << " frames, " << large << " of them beyond their budget, " << atlas.Moves
            << " moves\n";
  EXPECT_LE(large, frames / 50);
  EXPECT_GT(atlas.Moves, 50U);
}
