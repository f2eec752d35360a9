#include "DataSize.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <locale>
#include <vector>

namespace
{
namespace fs = std::filesystem;

constexpr int AnyHeader = 15 + 32; // for inflateInit2: zlib's or gzip's

class Inflation
{
public:
  Inflation() { this->Good = inflateInit2(&this->Stream, AnyHeader) == Z_OK; }
  ~Inflation() { inflateEnd(&this->Stream); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  // Bytes unpacked of these.
  std::uintmax_t Count(std::vector<char>& packed, std::uintmax_t most)
  {
    std::vector<char> plain(1 << 16);
    std::uintmax_t count = 0;
    this->Stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    this->Stream.avail_in = static_cast<uInt>(packed.size());
    do
    {
      if (this->Ended && !this->BeginMember())
      {
        return count;
      }
      this->Stream.next_out = reinterpret_cast<Bytef*>(plain.data());
      this->Stream.avail_out = static_cast<uInt>(plain.size());
      const int status = inflate(&this->Stream, Z_NO_FLUSH);
      count += plain.size() - this->Stream.avail_out;
      this->Ended = status == Z_STREAM_END;
      this->Good =
        status == Z_OK || this->Ended || (status == Z_BUF_ERROR && this->Stream.avail_in == 0);
    } while (
      this->Good && count <= most && (this->Stream.avail_in > 0 || this->Stream.avail_out == 0));
    return count;
  }

  bool IsGood() const { return this->Good; }
  bool HasEnded() const { return this->Ended; }

private:
  // Another one of the file, or zeros up to its end, as tapes have them.
  bool BeginMember()
  {
    const Bytef* next = this->Stream.next_in;
    const Bytef* end = next + this->Stream.avail_in;
    this->Padded = this->Padded || (next < end && *next == 0);
    if (this->Padded)
    {
      this->Good = std::all_of(next, end, [](Bytef byte) { return byte == 0; });
    }
    if (this->Padded || next == end)
    {
      return false;
    }
    this->Ended = false;
    this->Good = inflateReset(&this->Stream) == Z_OK;
    return this->Good;
  }

  z_stream Stream = {};
  bool Good = false;
  bool Ended = false;
  bool Padded = false;
};
} // namespace

std::uintmax_t CountBytes(const std::string& file, std::uintmax_t offset)
{
  const std::uintmax_t size = fs::file_size(fs::u8path(file));
  return size > offset ? size - offset : 0;
}

std::uintmax_t CountUnpacked(const std::string& file, std::uintmax_t offset, std::uintmax_t most)
{
  if (most > MostToUnpack)
  {
    const std::uintmax_t bytes = CountBytes(file, offset);
    return bytes < most / MostTimesUnpacked ? bytes * MostTimesUnpacked : most;
  }
  std::ifstream stream(fs::u8path(file), std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(offset));
  Inflation inflation;
  std::uintmax_t count = 0;
  while (inflation.IsGood() && count <= most && stream)
  {
    std::vector<char> packed(1 << 16);
    stream.read(packed.data(), static_cast<std::streamsize>(packed.size()));
    packed.resize(static_cast<std::size_t>(stream.gcount()));
    count += inflation.Count(packed, most - count);
  }
  // Without its end a stream may lack bytes, and a sum that vouches for them.
  const bool isWhole = count > most || (inflation.IsGood() && inflation.HasEnded());
  return isWhole || most == 0 ? count : std::min(count, most - 1);
}

std::uintmax_t CountNumbers(const std::string& file, std::uintmax_t offset, std::uintmax_t most)
{
  std::ifstream stream(fs::u8path(file), std::ios::binary);
  stream.imbue(std::locale::classic());
  stream.seekg(static_cast<std::streamoff>(offset));
  std::uintmax_t count = 0;
  for (double number = 0.0; count <= most && stream >> number;)
  {
    ++count;
  }
  return count;
}
