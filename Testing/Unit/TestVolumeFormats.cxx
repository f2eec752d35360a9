#include "DDSCodec.h"
#include "DF3Format.h"
#include "PVMFormat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>

using namespace flatblock;

namespace
{
std::vector<std::uint8_t> ToBytes(const std::string& text)
{
  return { text.begin(), text.end() };
}

PVMFormat Parse(const std::string& text)
{
  const std::vector<std::uint8_t> bytes = ToBytes(text);
  return ParsePVM(bytes.data(), bytes.size());
}

void ExpectError(const std::function<void()>& action, const std::string& words)
{
  try
  {
    action();
    ADD_FAILURE() << "no error: " << words;
  }
  catch (const FormatError& error)
  {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}
} // namespace

TEST(DDSCodec, DecodesWhatItEncodes)
{
  std::mt19937 random(3);
  for (const int count : { 0, 1, 2, 127, 128, 1000, 5000 })
  {
    for (const int skip : { 1, 2, 3, 4 })
    {
      for (const int strip : { 1, 2, 30, 65536 })
      {
        std::vector<std::uint8_t> bytes(count);
        for (int i = 0; i < count; ++i)
        {
          bytes[i] = static_cast<std::uint8_t>(i % 300 < 200 ? i / 7 : random());
        }
        const std::vector<std::uint8_t> encoded = EncodeDDS(bytes, skip, strip);
        ASSERT_TRUE(IsDDS(encoded.data(), encoded.size()));
        ASSERT_EQ(DecodeDDS(encoded.data(), encoded.size(), bytes.size() + 1), bytes);
      }
    }
  }
}

TEST(DDSCodec, DecodesNoMoreThanIsAskedFor)
{
  std::vector<std::uint8_t> bytes(100001, 7);
  std::fill_n(bytes.begin(), 50000, std::uint8_t(3));
  for (const int skip : { 1, 2, 3 })
  {
    const std::vector<std::uint8_t> encoded = EncodeDDS(bytes, skip, 1);
    EXPECT_LT(encoded.size(), 1100U);
    EXPECT_EQ(CountDDS(encoded.data(), encoded.size()), bytes.size());
    for (const std::size_t most : { 0, 1, 1000, 50001, 100001, 200000 })
    {
      const std::vector<std::uint8_t> first(
        bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(most, bytes.size())));
      EXPECT_EQ(DecodeDDS(encoded.data(), encoded.size(), most), first);
    }
  }
}

TEST(DDSCodec, TellsWhereAStreamEnds)
{
  std::vector<std::uint8_t> encoded = EncodeDDS(std::vector<std::uint8_t>(1000, 3), 1, 1);
  for (std::size_t count = 8; count + 1 < encoded.size(); ++count)
  {
    ExpectError(
      [&] { DecodeDDS(encoded.data(), count, 2000); }, "the compressed stream ends early");
  }
  EXPECT_FALSE(IsDDS(encoded.data(), 7));
}

TEST(PVMFormat, ReadsHeaders)
{
  EXPECT_EQ(Parse("PVM\n1 2 3\n2\n").Offset, 12U);
  const PVMFormat format = Parse("PVM3\n#a\n1 2 3\n0.5 1 2e1\n2\nrest");
  EXPECT_EQ(format.Samples, (std::array<int, 3>{ 1, 2, 3 }));
  EXPECT_EQ(format.Spacing, (std::array<double, 3>{ 0.5, 1.0, 20.0 }));
  EXPECT_EQ(format.BytesPerSample, 2);
  EXPECT_EQ(format.Version, 3);
  EXPECT_EQ(CountBytes(format), 12U);
}

TEST(PVMFormat, TellsWhatIsWrong)
{
  ExpectError([] { Parse(""); }, "at byte 0: the header ends before a first line");
  ExpectError([] { Parse("P5\n"); }, "begins with neither");
  ExpectError([] { Parse("PVM\n1 2\n1\n"); }, "at byte 4: '1 2' is not three numbers");
  ExpectError([] { Parse("PVM\n1 2 3 4\n1\n"); }, "is not three numbers");
  ExpectError([] { Parse("PVM\n0 2 3\n1\n"); }, "a number of samples is 0");
  ExpectError([] { Parse("PVM2\n1 2 3\n1 -1 1\n1\n"); }, "a spacing is not above 0");
  ExpectError([] { Parse("PVM\n1 2 3\n4\n"); }, "a sample has 4 bytes");
  ExpectError([] { Parse("PVM\n16777216 16777216 16777216\n1\n"); }, "asks for");
  PVMFormat format = Parse("PVM\n2 2 2\n1\n");
  CheckPVMSize(format, 20, {});
  ExpectError([&] { CheckPVMSize(format, 19, {}); }, "20 bytes are expected");
  ExpectError([&] { CheckPVMSize(format, 21, { 0 }); }, "1 bytes follow the samples, but none are");
  format.Version = 3;
  CheckPVMSize(format, 24, { 0, 0, 0, 0 });
  ExpectError([&] { CheckPVMSize(format, 22, { 0, 0 }); }, "but none, or four texts");
}

TEST(PVMFormat, ReadsWhatItMakes)
{
  VolumeFormat format;
  format.Samples = { 3, 2, 1 };
  format.Spacing = { 0.1, 1e-7, 123456.789 };
  const std::vector<std::uint8_t> samples = { 1, 2, 3, 4, 5, 6 };
  const std::vector<std::uint8_t> file = MakePVM(format, samples.data());
  const PVMFormat found = ParsePVM(file.data(), file.size());
  EXPECT_EQ(found.Samples, format.Samples);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(found.Spacing[axis] / format.Spacing[axis], 1.0, 1e-8);
  }
  EXPECT_TRUE(std::equal(samples.begin(), samples.end(), file.begin() + found.Offset));
}

TEST(DF3Format, FollowsFromHeaderAndSize)
{
  const std::vector<std::uint8_t> header = MakeDF3Header({ 300, 2, 5 });
  EXPECT_EQ(header, (std::vector<std::uint8_t>{ 1, 44, 0, 2, 0, 5 }));
  for (const int bytes : { 1, 2, 4 })
  {
    const VolumeFormat format = ParseDF3(header.data(), header.size(), 6 + 3000 * bytes);
    EXPECT_EQ(format.Samples, (std::array<int, 3>{ 300, 2, 5 }));
    EXPECT_EQ(format.BytesPerSample, bytes);
    EXPECT_EQ(format.Offset, 6U);
  }
  ExpectError([&] { ParseDF3(header.data(), 6, 6 + 9000); }, "9000 bytes from here on");
  ExpectError([&] { ParseDF3(header.data(), 5, 5); }, "at byte 5: the file ends within the header");
  const std::uint8_t none[6] = { 0, 1, 0, 0, 0, 1 };
  ExpectError([&] { ParseDF3(none, 6, 7); }, "at byte 2: a number of samples is 0");
  EXPECT_THROW(MakeDF3Header({ 65536, 1, 1 }), std::invalid_argument);
  EXPECT_THROW(MakeDF3Header({ 0, 1, 1 }), std::invalid_argument);
}
