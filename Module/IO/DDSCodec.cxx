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

  void Skip(int width)
  {
    this->Check(width);
    this->Next += static_cast<std::uint64_t>(width);
  }

  int Read(int width)
  {
    this->Check(width);
    int value = 0;
    for (int i = 0; i < width; ++i, ++this->Next)
    {
      value = value << 1 | (this->Bytes[this->Next / 8] >> (7 - this->Next % 8) & 1);
    }
    return value;
  }

private:
  void Check(int width) const
  {
    if (this->Next + static_cast<std::uint64_t>(width) > this->Bits)
    {
      throw FormatError(this->Bits / 8, "the compressed stream ends early.");
    }
  }

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

// What byte i is expected to be, where former(n) is the one n before it.
template <typename Former>
int PredictByte(std::uint64_t i, std::uint64_t strip, const Former& former)
{
  const int before = i > 0 ? former(1) : 0;
  return strip == 1 || i <= strip ? before : before + former(strip) - former(strip + 1);
}

// What a stream begins with, and its runs.
class RunReader
{
public:
  RunReader(const std::uint8_t* bytes, std::size_t count) : Bits(bytes, count, WholeMagic.size())
  {
    this->Skip = static_cast<std::uint64_t>(this->Bits.Read(2)) + 1;
    this->Strip = static_cast<std::uint64_t>(this->Bits.Read(16)) + 1;
  }

  std::uint64_t GetSkip() const { return this->Skip; }
  std::uint64_t GetStrip() const { return this->Strip; }

  // Whether there is another one, whose differences are to be read or passed over next.
  bool Next()
  {
    this->Count = this->Bits.Read(CountBits);
    this->Width = this->Count > 0 ? WidthOf(this->Bits.Read(WidthBits)) : 0;
    return this->Count > 0;
  }
  int GetCount() const { return this->Count; }
  int ReadDifference() { return this->Bits.Read(this->Width) - (1 << this->Width) / 2; }
  void PassOver() { this->Bits.Skip(this->Count * this->Width); }

private:
  BitReader Bits;
  std::uint64_t Skip = 1;
  std::uint64_t Strip = 1;
  int Count = 0; // bytes
  int Width = 0; // bits of each
};

// The bytes of a stream, as they are sorted there. Knows no more of them than the next one needs.
class ByteReader
{
public:
  ByteReader(const std::uint8_t* bytes, std::size_t count) : Runs(bytes, count)
  {
    std::size_t window = 4;
    while (window < this->Runs.GetStrip() + 2)
    {
      window *= 2;
    }
    this->Former.resize(window);
  }

  std::uint64_t GetSkip() const { return this->Runs.GetSkip(); }

  // The next one; to be asked no more often than there are bytes.
  std::uint8_t Read()
  {
    if (this->Left == 0 && this->Runs.Next())
    {
      this->Left = this->Runs.GetCount();
    }
    --this->Left;
    const std::uint64_t mask = this->Former.size() - 1;
    const int predicted = PredictByte(this->Next, this->Runs.GetStrip(),
      [this, mask](std::uint64_t back) { return this->Former[(this->Next - back) & mask]; });
    const auto byte = static_cast<std::uint8_t>(predicted + this->Runs.ReadDifference());
    this->Former[this->Next++ & mask] = byte;
    return byte;
  }

private:
  RunReader Runs;
  std::vector<std::uint8_t> Former;
  std::uint64_t Next = 0; // byte
  int Left = 0;           // of the run
};

// Bytes that are sorted together.
std::uint64_t GetPart(bool hasParts, std::uint64_t skip, std::uint64_t total)
{
  return skip == 1 ? 1 : hasParts ? skip * Part : std::max<std::uint64_t>(total, 1);
}

// Calls move(sorted place, place) for all bytes, in the order of sorted places.
template <typename Move>
void ForPlaces(std::uint64_t count, std::uint64_t skip, std::uint64_t part, const Move& move)
{
  for (std::uint64_t first = 0; first < count; first += part)
  {
    const std::uint64_t end = std::min(count, first + part);
    std::uint64_t sorted = first;
    for (std::uint64_t i = 0; i < skip; ++i)
    {
      for (std::uint64_t place = first + i; place < end; place += skip)
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

std::uint64_t CountDDS(const std::uint8_t* bytes, std::size_t count)
{
  RunReader runs(bytes, count);
  std::uint64_t total = 0;
  while (runs.Next())
  {
    total += runs.GetCount();
    runs.PassOver();
  }
  return total;
}

std::vector<std::uint8_t> DecodeDDS(const std::uint8_t* bytes, std::size_t count, std::size_t most)
{
  const std::uint64_t total = CountDDS(bytes, count);
  ByteReader reader(bytes, count);
  const std::uint64_t skip = reader.GetSkip();
  const std::uint64_t part = GetPart(StartsWith(bytes, count, PartsMagic), skip, total);
  const std::uint64_t wanted = std::min<std::uint64_t>(most, total);
  std::vector<std::uint8_t> decoded(wanted);
  // Parts after the last that is wanted are left.
  ForPlaces(std::min(total, (wanted + part - 1) / part * part), skip, part,
    [&](std::uint64_t, std::uint64_t place)
    {
      const std::uint8_t byte = reader.Read();
      if (place < wanted)
      {
        decoded[place] = byte;
      }
    });
  return decoded;
}

std::vector<std::uint8_t> EncodeDDS(const std::vector<std::uint8_t>& bytes, int skip, int strip)
{
  const bool hasParts = bytes.size() > Part;
  const auto step = static_cast<std::size_t>(skip);
  std::vector<std::uint8_t> sorted(bytes.size());
  ForPlaces(bytes.size(), step, GetPart(hasParts, step, bytes.size()),
    [&](std::uint64_t to, std::uint64_t from) { sorted[to] = bytes[from]; });
  const std::string_view magic = hasParts ? PartsMagic : WholeMagic;
  std::vector<std::uint8_t> encoded(magic.begin(), magic.end());
  BitWriter bits(encoded);
  bits.Write(skip - 1, 2);
  bits.Write(strip - 1, 16);

  std::vector<std::int8_t> differences(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    differences[i] =
      static_cast<std::int8_t>(sorted[i] - PredictByte(i, static_cast<std::uint64_t>(strip),
                                             [&](std::uint64_t back) { return sorted[i - back]; }));
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
