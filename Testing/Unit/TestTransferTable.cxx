#include "TransferTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using flatblock::GetExtinction;
using flatblock::TransferTable;

namespace
{
TransferTable MakeTable(double lowest, double highest, const std::vector<float>& opacities)
{
  std::vector<TransferTable::Entry> entries;
  for (float opacity : opacities)
  {
    entries.push_back({ 1.0F, 1.0F, 1.0F, opacity });
  }
  return TransferTable(lowest, highest, entries);
}
} // namespace

TEST(TransferTable, TellsTransparentIntervals)
{
  const TransferTable table = MakeTable(0.0, 10.0, { 0, 0, 0, 0.5F, 0, 0, 0, 0, 0, 1e-30F, 0 });
  EXPECT_TRUE(table.IsTransparent(0.0, 1.9));
  EXPECT_FALSE(table.IsTransparent(0.0, 2.1)); // interpolates towards entry 3
  EXPECT_FALSE(table.IsTransparent(3.5, 3.6));
  EXPECT_TRUE(table.IsTransparent(4.1, 7.9));
  EXPECT_FALSE(table.IsTransparent(4.1, 9.0));
  EXPECT_FALSE(table.IsTransparent(-100.0, 100.0));
}

TEST(TransferTable, ClampsBeyondItsEnds)
{
  const TransferTable table = MakeTable(0.0, 1.0, { 0.0F, 0.0F, 0.0F, 0.7F });
  EXPECT_TRUE(table.IsTransparent(-9.0, -8.0));
  EXPECT_FALSE(table.IsTransparent(8.0, 9.0));
}

TEST(TransferTable, CopesWithASingleValue)
{
  EXPECT_TRUE(MakeTable(5.0, 5.0, { 0.0F, 0.0F }).IsTransparent(5.0, 5.0));
  EXPECT_FALSE(MakeTable(5.0, 5.0, { 0.1F, 0.1F }).IsTransparent(5.0, 5.0));
  EXPECT_TRUE(MakeTable(0.0, 1.0, { 0.1F, 0.1F }).IsTransparent(INFINITY, -INFINITY));
}

TEST(TransferTable, NeverCallsTransparentWhatAValueWouldShow)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  std::vector<float> opacities(1024, 0.0F);
  for (int i = 0; i < 12; ++i)
  {
    opacities[random() % opacities.size()] = 1.0F;
  }
  const TransferTable table = MakeTable(-3.0, 7.0, opacities);
  int transparent = 0;
  for (int trial = 0; trial < 100000; ++trial)
  {
    const double width = std::pow(anywhere(random), 4.0);
    const double lowest = anywhere(random) * (1.0 - width);
    if (!table.IsTransparent(-3.0 + 10.0 * lowest, -3.0 + 10.0 * (lowest + width)))
    {
      continue;
    }
    ++transparent;
    const double position = (lowest + width * anywhere(random)) * 1023.0;
    const auto left = static_cast<std::size_t>(position);
    ASSERT_EQ(opacities[left], 0.0F);
    ASSERT_EQ(opacities[std::min<std::size_t>(left + 1, 1023)], 0.0F);
  }
  EXPECT_GT(transparent, 10000);
}

TEST(Extinction, EqualsTheClosedForm)
{
  for (double opacity : { 1e-7, 1e-3, 0.2, 0.5, 0.999, 0.9999999 })
  {
    for (double distance : { 1e-2, 0.25, 1.0, 3.0, 1e6 })
    {
      const long double expected =
        std::min(-std::log(1.0L - opacity) / distance, 0.0L + flatblock::MostExtinction);
      EXPECT_NEAR(GetExtinction(opacity, distance) / static_cast<double>(expected), 1.0, 1e-9)
        << opacity << " over " << distance;
    }
  }
}

TEST(Extinction, KeepsItsEnds)
{
  EXPECT_EQ(GetExtinction(0.0, 5.0), 0.0);
  EXPECT_EQ(GetExtinction(-0.5, 1.0), 0.0);
  EXPECT_EQ(GetExtinction(1.0, 1e6), flatblock::MostExtinction);
  EXPECT_EQ(GetExtinction(1.5, 1.0), flatblock::MostExtinction);
  EXPECT_EQ(GetExtinction(0.5, 1e-9), flatblock::MostExtinction);
}
