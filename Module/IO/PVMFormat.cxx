#include "PVMFormat.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <string_view>

namespace flatblock
{
namespace
{
constexpr int MostSamples = 1 << 24; // along an axis

// The beginning of a line, as text that no terminal obeys.
std::string Quote(const std::string& line)
{
  std::string quoted = line.substr(0, 40);
  std::replace_if(
    quoted.begin(), quoted.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return "'" + quoted + "'";
}

// The lines of a header, one by one.
class Lines
{
public:
  Lines(const std::uint8_t* bytes, std::size_t count) : Bytes(bytes), Count(count) {}

  std::size_t GetOffset() const { return this->Next; }

  std::string Get(const char* expected)
  {
    std::string line;
    do
    {
      this->First = this->Next;
      const auto* begin = this->Bytes + this->Next;
      const auto* end = std::find(begin, this->Bytes + this->Count, '\n');
      if (end == this->Bytes + this->Count)
      {
        throw FormatError(this->First, std::string("the header ends before ") + expected + ".");
      }
      line.assign(begin, end);
      this->Next += line.size() + 1;
    } while (!line.empty() && line.front() == '#');
    return line;
  }

  // Whatever the locale.
  template <typename T, std::size_t N>
  std::array<T, N> GetNumbers(const char* expected)
  {
    const std::string line = this->Get(expected);
    std::istringstream text(line);
    text.imbue(std::locale::classic());
    std::array<T, N> numbers;
    for (T& number : numbers)
    {
      text >> number;
    }
    std::string rest;
    if (!text || text >> rest)
    {
      throw FormatError(this->First, Quote(line) + " is not " + expected + ".");
    }
    return numbers;
  }

  std::size_t GetFirst() const { return this->First; }

private:
  const std::uint8_t* Bytes;
  std::size_t Count;
  std::size_t First = 0; // of the last line
  std::size_t Next = 0;
};

int ReadVersion(Lines& lines)
{
  const std::string magic = lines.Get("a first line of PVM, PVM2 or PVM3");
  constexpr std::string_view Magics[] = { "PVM", "PVM2", "PVM3" };
  for (int i = 0; i < 3; ++i)
  {
    if (magic == Magics[i])
    {
      return i + 1;
    }
  }
  throw FormatError(0, "the file begins with neither PVM, PVM2, PVM3 nor DDS v3d, DDS v3e.");
}
} // namespace

PVMFormat ParsePVM(const std::uint8_t* bytes, std::size_t count)
{
  Lines lines(bytes, count);
  PVMFormat format;
  format.Version = ReadVersion(lines);
  format.Samples = lines.GetNumbers<int, 3>("three numbers of samples");
  for (const int samples : format.Samples)
  {
    if (samples < 1 || samples > MostSamples)
    {
      throw FormatError(lines.GetFirst(), "a number of samples is " + std::to_string(samples) +
                                            ", but 1 to " + std::to_string(MostSamples) +
                                            " is expected.");
    }
  }
  if (format.Version > 1)
  {
    format.Spacing = lines.GetNumbers<double, 3>("three spacings");
    for (const double spacing : format.Spacing)
    {
      if (!(spacing > 0.0) || !std::isfinite(spacing))
      {
        throw FormatError(lines.GetFirst(), "a spacing is not above 0.");
      }
    }
  }
  format.BytesPerSample = lines.GetNumbers<int, 1>("the bytes of a sample")[0];
  if (format.BytesPerSample != 1 && format.BytesPerSample != 2)
  {
    throw FormatError(lines.GetFirst(),
      "a sample has " + std::to_string(format.BytesPerSample) + " bytes, but 1 or 2 are expected.");
  }
  format.Offset = lines.GetOffset();
  CountBytes(format);
  return format;
}

void CheckPVMSize(
  const PVMFormat& format, std::uintmax_t total, const std::vector<std::uint8_t>& rest)
{
  constexpr int Texts = 4;
  const std::uintmax_t end = format.Offset + CountBytes(format);
  if (total < end)
  {
    throw FormatError(total, "the file ends, but " + std::to_string(end) + " bytes are expected.");
  }
  const bool hasTexts = format.Version == 3 && !rest.empty() && rest.back() == 0 &&
                        std::count(rest.begin(), rest.end(), std::uint8_t(0)) == Texts;
  if (total > end && !hasTexts)
  {
    throw FormatError(end, std::to_string(total - end) + " bytes follow the samples, but " +
                             (format.Version == 3 ? "none, or four texts," : "none") +
                             " are expected.");
  }
}

std::vector<std::uint8_t> MakePVM(const VolumeFormat& format, const std::uint8_t* samples)
{
  std::ostringstream header;
  header.imbue(std::locale::classic());
  header.precision(9);
  header << "PVM3\n"
         << format.Samples[0] << " " << format.Samples[1] << " " << format.Samples[2] << "\n"
         << format.Spacing[0] << " " << format.Spacing[1] << " " << format.Spacing[2] << "\n"
         << format.BytesPerSample << "\n";
  const std::string text = header.str();
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  bytes.insert(bytes.end(), samples, samples + CountBytes(format));
  bytes.insert(bytes.end(), 4, 0);
  return bytes;
}
} // namespace flatblock
