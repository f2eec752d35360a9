#include "TransferIntegrals.h"

#include <gtest/gtest.h>

#include <random>

using namespace flatblock;

namespace
{
TransferTable MakeTable(int entries)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  std::vector<TransferTable::Entry> all(entries);
  for (auto& entry : all)
  {
    entry = { share(random), share(random), share(random), 100.0F * share(random) };
  }
  return TransferTable(0.0, 1.0, all);
}
} // namespace

TEST(TransferIntegrals, AreThoseOfLinearEntries)
{
  constexpr int Steps = 2000;
  const TransferTable table = MakeTable(20);
  const auto& entries = table.GetEntries();
  const auto texels = IntegrateTransferTable(table);
  ASSERT_EQ(texels.size(), TransferTexels * entries.size());
  std::array<double, 4> sum = { 0.0, 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    EXPECT_EQ(texels[TransferTexels * i], entries[i]);
    for (int c = 0; c < 4; ++c)
    {
      const double integral =
        double(texels[TransferTexels * i + 1][c]) + texels[TransferTexels * i + 2][c];
      EXPECT_NEAR(integral, sum[c], 1e-5 * (1.0 + sum[c]));
    }
    for (int step = 0; step < Steps && i + 1 < entries.size(); ++step)
    {
      const double share = (step + 0.5) / Steps;
      std::array<double, 4> entry;
      for (int c = 0; c < 4; ++c)
      {
        entry[c] = (1.0 - share) * entries[i][c] + share * entries[i + 1][c];
      }
      for (int c = 0; c < 4; ++c)
      {
        sum[c] += (c < 3 ? entry[c] * entry[3] : entry[3]) / Steps;
      }
    }
  }
}

TEST(TransferIntegrals, HaveWhatFloatsLeaveOut)
{
  std::vector<TransferTable::Entry> entries(4096, { 1.0F, 1.0F, 1.0F, 1.0F / 3.0F });
  const auto texels = IntegrateTransferTable(TransferTable(0.0, 1.0, entries));
  const auto& rounded = texels[TransferTexels * 4095 + 1];
  const auto& rest = texels[TransferTexels * 4095 + 2];
  EXPECT_NEAR(double(rounded[3]) + rest[3], 4095.0 * double(1.0F / 3.0F), 1e-9);
  EXPECT_NE(rest[3], 0.0F);
}

TEST(TransferIntegrals, TellHowMuchEntriesChange)
{
  // Straight, but for a bend of 2 in the colour and of 3 in the extinction at the second entry.
  const TransferTable table(0.0, 1.0,
    { { 0.0F, 0.0F, 0.0F, 0.0F }, { 1.0F, 0.5F, 0.0F, 1.0F }, { 0.0F, 0.0F, 0.0F, 5.0F } });
  const auto texels = IntegrateTransferTable(table);
  const auto& first = texels[3];
  const auto& second = texels[TransferTexels + 3];
  EXPECT_EQ(first, (TransferTable::Entry{ 0.0F, 0.0F, 1.0F, 0.0F }));
  EXPECT_EQ(second, (TransferTable::Entry{ 2.0F, 3.0F, 2.0F, 1.0F }));
}
