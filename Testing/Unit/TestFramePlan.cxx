#include "FramePlan.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using flatblock::FramePlan;
using flatblock::Residency;

namespace
{
using Wanted = std::vector<std::uint8_t>;

void ExpectResident(const Residency& residency, const Wanted& wanted)
{
  std::set<int> places;
  ASSERT_EQ(residency.GetPlaces().size(), wanted.size());
  for (std::size_t block = 0; block < wanted.size(); ++block)
  {
    const int place = residency.GetPlaces()[block];
    EXPECT_EQ(place != Residency::NotResident, wanted[block] != 0);
    if (place != Residency::NotResident)
    {
      EXPECT_TRUE(places.insert(place).second) << "two bricks at place " << place;
      EXPECT_LT(place, residency.GetAtlas().GetCapacity());
    }
  }
  EXPECT_EQ(residency.GetAtlas().GetNumberOfFreePlaces() + std::int64_t(places.size()),
    residency.GetAtlas().GetCapacity());
}
} // namespace

TEST(FramePlan, UploadsOnlyWhatIsNew)
{
  Residency residency;
  auto plan = residency.Plan({ 1, 1, 0, 1, 1 }, 33, 2048);
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->NewAtlas);
  EXPECT_EQ(plan->Uploads.size(), 4U);

  plan = residency.Plan({ 1, 1, 0, 1, 1 }, 33, 2048);
  EXPECT_FALSE(plan->NewAtlas);
  EXPECT_FALSE(plan->NewPlaces);
  EXPECT_TRUE(plan->Uploads.empty());

  plan = residency.Plan({ 1, 0, 1, 1, 1 }, 33, 2048);
  EXPECT_FALSE(plan->NewAtlas);
  EXPECT_TRUE(plan->NewPlaces);
  ASSERT_EQ(plan->Uploads.size(), 1U);
  EXPECT_EQ(plan->Uploads[0].Block, 2);
  ExpectResident(residency, { 1, 0, 1, 1, 1 });
}

TEST(FramePlan, ChangesNothingWhereNoTextureIsLargeEnough)
{
  Residency residency;
  ASSERT_TRUE(residency.Plan({ 1, 0 }, 33, 33));
  EXPECT_FALSE(residency.Plan({ 1, 1 }, 33, 33));
  ExpectResident(residency, { 1, 0 });
}

TEST(FramePlan, CopesWithNoBlockAtAll)
{
  Residency residency;
  auto plan = residency.Plan({ 0, 0, 0 }, 17, 2048);
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->NewAtlas); // one place, so that there is a texture to bind
  EXPECT_TRUE(plan->Uploads.empty());
  ExpectResident(residency, { 0, 0, 0 });
}

TEST(FramePlan, HoldsUnderRandomEdits)
{
  std::mt19937 random(11);
  Residency residency;
  Wanted wanted(300, 0);
  std::vector<std::int64_t> atlas; // what the GPU would hold: block at each place
  for (int edit = 0; edit < 2000; ++edit)
  {
    const double share = std::uniform_real_distribution<double>(0.0, 1.0)(random);
    const int changes = std::uniform_int_distribution<int>(0, 60)(random);
    for (int i = 0; i < changes; ++i)
    {
      wanted[random() % wanted.size()] = std::bernoulli_distribution(share)(random) ? 1 : 0;
    }
    const auto plan = residency.Plan(wanted, 17, 2048);
    ASSERT_TRUE(plan);
    if (plan->NewAtlas)
    {
      atlas.assign(residency.GetAtlas().GetCapacity(), -1);
    }
    for (const auto& upload : plan->Uploads)
    {
      atlas[upload.Place] = upload.Block;
    }
    ExpectResident(residency, wanted);
    for (std::size_t block = 0; block < wanted.size(); ++block)
    {
      if (wanted[block])
      {
        ASSERT_EQ(atlas[residency.GetPlaces()[block]], std::int64_t(block));
      }
    }
  }
}
