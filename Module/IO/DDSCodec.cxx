#include "DDSCodec.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace flatblock
{
namespace
{
constexpr std::string_view WholeMagic = "DDS v3d\n";
constexpr std::string_view PartsMagic = "DDS v3e\n";
constexpr std::size_t Part = std::size_t(1) << 24; // times skip, where bytes are sorted in parts
constexpr int CountBits = 7;
constexpr int WidthBits = 3;
constexpr int LongestRun = (1 << CountBits) - 1;

bool StartsWith(const std::uint8_t* bytes, std::size_t count, std::string_view magic)
{
  return count >= magic.size() && std::memcmp(bytes, magic.data(), magic.size()) == 0;
}

int WidthOf(int code)
{
  return code == 0 ? 0 : code + 1;
}

int CodeOf(int width)
{
  return width <= 1 ? width : width - 1;
}

class BitReader
{
public:
  BitReader(const std::uint8_t* bytes, std::size_t count, std::size_t first)
    : Bytes(bytes), Bits(8 * static_cast<std::uint64_t>(count)),
      Next(8 * static_cast<std::uint64_t>(first))
  {
  }

  int Read(int width)
  {
    if (this->Next + static_cast<std::uint64_t>(width) > this->Bits)
    {
      throw FormatError(this->Bits / 8, "the compressed stream ends early.");
    }
    int value = 0;
    for (int i = 0; i < width; ++i, ++this->Next)
    {
      value = value << 1 | (this->Bytes[this->Next / 8] >> (7 - this->Next % 8) & 1);
    }
    return value;
  }

private:
  const std::uint8_t* Bytes;
  std::uint64_t Bits;
  std::uint64_t Next;
};

class BitWriter
{
public:
  explicit BitWriter(std::vector<std::uint8_t>& bytes) : Bytes(bytes) {}

  void Write(int value, int width)
  {
    for (int i = width - 1; i >= 0; --i)
    {
      if (this->Used == 0)
      {
        this->Bytes.push_back(0);
      }
      this->Bytes.back() |= static_cast<std::uint8_t>((value >> i & 1) << (7 - this->Used));
      this->Used = (this->Used + 1) % 8;
    }
  }

private:
  std::vector<std::uint8_t>& Bytes;
  int Used = 0; // bits of the last byte
};

// What a byte is expected to be, by those before it.
int PredictByte(const std::vector<std::uint8_t>& bytes, std::size_t i, std::size_t strip)
{
  const int before = i > 0 ? bytes[i - 1] : 0;
  return strip == 1 || i <= strip ? before : before + bytes[i - strip] - bytes[i - strip - 1];
}

// Calls move(sorted place, place) for all bytes.
template <typename Move>
void ForPlaces(std::size_t count, std::size_t skip, std::size_t part, const Move& move)
{
  for (std::size_t first = 0; first < count; first += part)
  {
    const std::size_t end = std::min(count, first + part);
    std::size_t sorted = first;
    for (std::size_t i = 0; i < skip; ++i)
    {
      for (std::size_t place = first + i; place < end; place += skip)
      {
        move(sorted++, place);
      }
    }
  }
}

// A difference as a number of so many bits, from -2^(width - 1) on.
int GetWidth(int difference)
{
  int width = 0;
  while (difference < -((1 << width) / 2) || difference >= ((1 << width) + 1) / 2)
  {
    ++width;
  }
  return WidthOf(CodeOf(width));
}
} // namespace

bool IsDDS(const std::uint8_t* bytes, std::size_t count)
{
  return StartsWith(bytes, count, WholeMagic) || StartsWith(bytes, count, PartsMagic);
}

std::vector<std::uint8_t> DecodeDDS(const std::uint8_t* bytes, std::size_t count, std::size_t most)
{
  BitReader bits(bytes, count, WholeMagic.size());
  const auto skip = static_cast<std::size_t>(bits.Read(2)) + 1;
  const auto strip = static_cast<std::size_t>(bits.Read(16)) + 1;
  std::vector<std::uint8_t> decoded;
  while (skip > 1 || decoded.size() < most)
  {
    const int run = bits.Read(CountBits);
    if (run == 0)
    {
      break;
    }
    const int width = WidthOf(bits.Read(WidthBits));
    for (int i = 0; i < run; ++i)
    {
      const int difference = bits.Read(width) - (1 << width) / 2;
      decoded.push_back(
        static_cast<std::uint8_t>(PredictByte(decoded, decoded.size(), strip) + difference));
    }
  }
  if (skip == 1)
  {
    return decoded;
  }
  std::vector<std::uint8_t> unsorted(decoded.size());
  const bool hasParts = StartsWith(bytes, count, PartsMagic);
  ForPlaces(decoded.size(), skip, hasParts ? skip * Part : std::max<std::size_t>(decoded.size(), 1),
    [&](std::size_t from, std::size_t to) { unsorted[to] = decoded[from]; });
  return unsorted;
}

std::vector<std::uint8_t> EncodeDDS(const std::vector<std::uint8_t>& bytes, int skip, int strip)
{
  const bool hasParts = bytes.size() > Part;
  const auto step = static_cast<std::size_t>(skip);
  std::vector<std::uint8_t> sorted(bytes.size());
  ForPlaces(bytes.size(), step, hasParts ? step * Part : std::max<std::size_t>(bytes.size(), 1),
    [&](std::size_t to, std::size_t from) { sorted[to] = bytes[from]; });
  const std::string_view magic = hasParts ? PartsMagic : WholeMagic;
  std::vector<std::uint8_t> encoded(magic.begin(), magic.end());
  BitWriter bits(encoded);
  bits.Write(skip - 1, 2);
  bits.Write(strip - 1, 16);

  std::vector<std::int8_t> differences(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    differences[i] =
      static_cast<std::int8_t>(sorted[i] - PredictByte(sorted, i, static_cast<std::size_t>(strip)));
  }
  for (std::size_t first = 0; first < differences.size();)
  {
    const int width = GetWidth(differences[first]);
    std::size_t end = first + 1;
    while (
      end < differences.size() && end - first < LongestRun && GetWidth(differences[end]) == width)
    {
      ++end;
    }
    bits.Write(static_cast<int>(end - first), CountBits);
    bits.Write(CodeOf(width), WidthBits);
    for (; first < end; ++first)
    {
      bits.Write(differences[first] + (1 << width) / 2, width);
    }
  }
  bits.Write(0, CountBits);
  return encoded;
}
} // namespace flatblock
