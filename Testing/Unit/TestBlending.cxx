#include "Blending.h"

#include <gtest/gtest.h>

#include <string>

using namespace flatblock;

namespace
{
// Seen at the values 3 and 6 of 0 to 9.
TransferTable MakeTable()
{
  std::vector<TransferTable::Entry> entries(10, { 1.0F, 1.0F, 1.0F, 0.0F });
  entries[3][3] = 1.0F;
  entries[6][3] = 1.0F;
  return TransferTable(0.0, 9.0, entries);
}

std::string Show(const TransferTable& table)
{
  std::string shown;
  for (const auto& entry : table.GetEntries())
  {
    shown += entry[3] > 0.0F ? 'x' : '.';
  }
  return shown;
}

Blending Make(BlendMode mode)
{
  Blending blending;
  blending.Mode = mode;
  return blending;
}
} // namespace

TEST(Blending, TellsWhichValuesDecideAPicture)
{
  const TransferTable table = MakeTable();
  EXPECT_EQ(Show(GetDecisiveValues(table, Make(BlendMode::Composite))), "...x..x...");
  EXPECT_EQ(Show(GetDecisiveValues(table, Make(BlendMode::Additive))), "...x..x...");
  EXPECT_EQ(Show(GetDecisiveValues(table, Make(BlendMode::Slice))), "...x..x...");
  EXPECT_EQ(Show(GetDecisiveValues(table, Make(BlendMode::Maximum))), "...xxxxxxx");
  EXPECT_EQ(Show(GetDecisiveValues(table, Make(BlendMode::Minimum))), "xxxxxxx...");
  Blending average = Make(BlendMode::Average);
  average.AverageRange = { 1.5, 4.0 };
  EXPECT_EQ(Show(GetDecisiveValues(table, average)), ".xxxx.....");
  average.AverageRange = { 20.0, 30.0 };
  EXPECT_EQ(Show(GetDecisiveValues(table, average)), "..........");
  Blending surfaces = Make(BlendMode::Isosurface);
  surfaces.IsoValues = { 2.5, 8.0, 100.0 };
  EXPECT_EQ(Show(GetDecisiveValues(table, surfaces)), "..xx...xxx");
}

TEST(Blending, IsCompared)
{
  Blending a = Make(BlendMode::Isosurface);
  Blending b = a;
  EXPECT_TRUE(a == b);
  b.IsoValues = { 1.0 };
  EXPECT_FALSE(a == b);
  EXPECT_TRUE(a.HasSurfaces());
  EXPECT_FALSE(a.IsComposite());
  EXPECT_TRUE(Make(BlendMode::Minimum).IsExtreme());
}
