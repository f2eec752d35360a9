#include "ClassifiedTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using flatblock::ClassifiedColor;
using flatblock::ClassifiedTable;
using flatblock::FindDifference;
using flatblock::ToClassifiedColor;

namespace
{
void ExpectColor(const ClassifiedColor& color, double l, double u, double v, double opacity)
{
  EXPECT_NEAR(color[0], l, 0.01);
  EXPECT_NEAR(color[1], u, 0.01);
  EXPECT_NEAR(color[2], v, 0.01);
  EXPECT_NEAR(color[3], opacity, 1e-4);
}

float GetDistance(const ClassifiedColor& a, const ClassifiedColor& b)
{
  const ClassifiedColor apart = a - b;
  const ClassifiedColor squares = apart * apart;
  return std::sqrt(squares[0] + squares[1] + squares[2] + squares[3]);
}

std::vector<ClassifiedColor> MakeRamp(int entries)
{
  std::vector<ClassifiedColor> colors;
  for (int i = 0; i < entries; ++i)
  {
    const double t = i / (entries - 1.0);
    colors.push_back(ToClassifiedColor(t, 1.0 - t, 0.5, t));
  }
  return colors;
}
} // namespace

// Published values of the sRGB primaries.
TEST(ClassifiedTable, KnowsCIELUV)
{
  ExpectColor(ToClassifiedColor(1.0, 1.0, 1.0, 1.0), 100.0, 0.0, 0.0, 100.0);
  ExpectColor(ToClassifiedColor(0.0, 0.0, 0.0, 1.0), 0.0, 0.0, 0.0, 100.0);
  ExpectColor(ToClassifiedColor(1.0, 0.0, 0.0, 1.0), 53.2408, 175.0151, 37.7564, 100.0);
  ExpectColor(ToClassifiedColor(0.0, 1.0, 0.0, 1.0), 87.7347, -83.0776, 107.3985, 100.0);
  ExpectColor(ToClassifiedColor(0.0, 0.0, 1.0, 1.0), 32.2970, -9.4054, -130.3423, 100.0);
  ExpectColor(ToClassifiedColor(0.7, 0.2, 0.9, 0.0), 0.0, 0.0, 0.0, 0.0);
  ExpectColor(ToClassifiedColor(1.0, 1.0, 1.0, 0.5), 53.3890, 0.0, 0.0, 50.0);
}

TEST(ClassifiedTable, KnowsWhatIsConstant)
{
  std::vector<ClassifiedColor> colors(11, ToClassifiedColor(0.2, 0.3, 0.4, 0.5));
  colors[7] = ToClassifiedColor(1.0, 0.3, 0.4, 0.5);
  const ClassifiedTable table(0.0, 20.0, colors);
  EXPECT_TRUE(table.IsConstant(0.0, 12.0));
  EXPECT_FALSE(table.IsConstant(0.0, 12.5));
  EXPECT_FALSE(table.IsConstant(14.0, 15.0));
  EXPECT_TRUE(table.IsConstant(16.0, 100.0));
  EXPECT_TRUE(table.IsConstant(-5.0, -1.0));
  EXPECT_TRUE(table.IsConstant(3.0, 2.0));
}

TEST(ClassifiedTable, BoundsDifferences)
{
  std::mt19937 random(2);
  const ClassifiedTable table(0.0, 200.0, MakeRamp(201));
  for (int trial = 0; trial < 1000; ++trial)
  {
    const int a = int(random() % 201);
    const int b = a + int(random() % (201 - a));
    float largest = 0.0F;
    for (int i = a; i <= b; ++i)
    {
      for (int j = a; j < i; ++j)
      {
        largest = std::max(largest, GetDistance(table.GetColors()[i], table.GetColors()[j]));
      }
    }
    const float bound = table.GetLargestDifference(a, b);
    ASSERT_GE(bound, largest * 0.99999F);
    ASSERT_LE(bound, largest * 2.0F + 1e-3F);
    trial += b - a > 50 ? 20 : 0;
  }
}

TEST(ClassifiedTable, FindsWhatAnEditChanged)
{
  const auto ramp = MakeRamp(101);
  const ClassifiedTable before(0.0, 100.0, ramp);
  EXPECT_GT(FindDifference(before, before).first, FindDifference(before, before).second);
  auto edited = ramp;
  edited[40] = edited[43] = ToClassifiedColor(1.0, 1.0, 1.0, 1.0);
  const auto difference = FindDifference(before, ClassifiedTable(0.0, 100.0, edited));
  EXPECT_EQ(difference.first, 39.0);
  EXPECT_EQ(difference.second, 44.0);
  const auto all = FindDifference(before, ClassifiedTable(0.0, 90.0, ramp));
  EXPECT_LT(all.first, -1e300);
  EXPECT_GT(all.second, 1e300);
}
