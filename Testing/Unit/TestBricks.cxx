#include "InterleavedBricks.h"
#include "QuantizedBricks.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace flatblock;

namespace
{
const Index3 Samples = { 9, 9, 9 };

// Texels that rise by steps from a first one, of any format.
template <typename T>
class Ramp : public BrickSource
{
public:
  Ramp(TexelFormat format, T first, T step) : First(first), Step(step)
  {
    this->Encoding.Format = format;
    this->Encoding.Offset = 5.0;
  }

  const BlockGrid& GetGrid() const override { return this->Grid; }
  const TexelEncoding& GetEncoding() const override { return this->Encoding; }
  Continuity GetContinuity() const override { return Continuity::Nested; }
  void ReadBrick(std::int64_t, int level, const BlockBorder& border, void* texels) const override
  {
    const int side = this->Grid.GetTexelSide(level);
    auto* out = static_cast<T*>(texels);
    for (int i = 0; i < side * side * side; ++i)
    {
      out[i] = static_cast<T>(this->First + this->Step * (i % side));
    }
    this->HasBorder = border != BlockBorder{};
  }

  mutable bool HasBorder = false;

private:
  BlockGrid Grid = BlockGrid(Samples, 9);
  TexelEncoding Encoding;
  T First;
  T Step;
};

template <typename T>
std::vector<T> Read(const BrickSource& source, int components, const BlockBorder& border = {})
{
  std::vector<T> texels(static_cast<std::size_t>(9 * 9 * 9) * components);
  source.ReadBrick(0, 0, border, texels.data());
  return texels;
}

BlockBorder MakeBorder()
{
  BlockBorder border = {};
  border[0] = 1;
  return border;
}
} // namespace

TEST(QuantizedBricks, RoundToTheRangeOfTheirBlock)
{
  const Ramp<std::uint8_t> bytes(TexelFormat::Unsigned8, 100, 10);
  const Ramp<std::uint16_t> words(TexelFormat::Unsigned16, 10000, 1000);
  const Ramp<float> floats(TexelFormat::Float32, 0.25F, 0.05F);
  const auto check = [](const BrickSource& source, double first, double step)
  {
    for (const int bits : { 1, 4, 8 })
    {
      const TexelRange range = { static_cast<float>(first), static_cast<float>(8.0 * step) };
      const QuantizedBricks bricks(source, { range }, bits);
      EXPECT_EQ(bricks.GetEncoding().Format, TexelFormat::Unsigned8);
      EXPECT_EQ(bricks.GetContinuity(), Continuity::Nested);
      ASSERT_EQ(bricks.GetRanges().size(), 1U);
      const double last = (1 << bits) - 1;
      EXPECT_NEAR(bricks.GetEncoding().Step, 8.0 * step / last, 1e-6);
      const std::vector<std::uint8_t> texels = Read<std::uint8_t>(bricks, 1);
      for (int i = 0; i < 9; ++i)
      {
        const double value = range.Lowest + range.Extent * texels[i] / 255.0;
        EXPECT_NEAR(value, first + step * i, 0.5 * range.Extent / last + 1e-6);
      }
    }
  };
  check(bytes, 100.0 / 255.0, 10.0 / 255.0);
  check(words, 10000.0 / 65535.0, 1000.0 / 65535.0);
  check(floats, 0.25, 0.05);
}

TEST(QuantizedBricks, OfOneValueAreThatValue)
{
  const Ramp<std::uint8_t> bytes(TexelFormat::Unsigned8, 7, 0);
  const QuantizedBricks bricks(bytes, { { 7.0F / 255.0F, 0.0F } }, 4);
  EXPECT_EQ(Read<std::uint8_t>(bricks, 1), std::vector<std::uint8_t>(729, 0));
}

TEST(InterleavedBricks, AreOfTheWidestFormat)
{
  const Ramp<std::uint8_t> bytes(TexelFormat::Unsigned8, 1, 2);
  const Ramp<std::uint16_t> words(TexelFormat::Unsigned16, 100, 200);
  const Ramp<float> floats(TexelFormat::Float32, 0.5F, 0.01F);

  const InterleavedBricks same({ &bytes, &bytes }, false);
  EXPECT_EQ(same.GetEncoding().Components, 2);
  EXPECT_EQ(same.GetEncoding().Offset, 5.0);
  const auto two = Read<std::uint8_t>(same, 2);
  EXPECT_EQ(two[2], 3);
  EXPECT_EQ(two[3], 3);

  const InterleavedBricks mixed({ &bytes, &words, &words }, false);
  EXPECT_EQ(mixed.GetEncoding().Format, TexelFormat::Unsigned16);
  const auto three = Read<std::uint16_t>(mixed, 4);
  EXPECT_EQ(three[4], 3 * 257); // as much of the whole
  EXPECT_EQ(three[5], 300);
  EXPECT_EQ(three[6], 300);
  EXPECT_EQ(three[7], 0);

  const InterleavedBricks all({ &bytes, &words, &floats, &bytes }, false);
  EXPECT_EQ(all.GetEncoding().Format, TexelFormat::Float32);
  const auto four = Read<float>(all, 4);
  EXPECT_FLOAT_EQ(four[4], 3.0F / 255.0F);
  EXPECT_FLOAT_EQ(four[5], 300.0F / 65535.0F);
  EXPECT_FLOAT_EQ(four[6], 0.51F);
}

TEST(InterleavedBricks, LeaveTheBorderOfAMask)
{
  const Ramp<std::uint8_t> bytes(TexelFormat::Unsigned8, 1, 2);
  const Ramp<std::uint8_t> mask(TexelFormat::Unsigned8, 0, 1);
  const std::vector<const BrickSource*> sources = { &bytes, &mask };
  const InterleavedBricks masked(sources, true);
  Read<std::uint8_t>(masked, 2, MakeBorder());
  EXPECT_TRUE(bytes.HasBorder);
  EXPECT_FALSE(mask.HasBorder);
  const InterleavedBricks mixed(sources, false);
  Read<std::uint8_t>(mixed, 2, MakeBorder());
  EXPECT_TRUE(mask.HasBorder);
}
