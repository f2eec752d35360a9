#include "CheckMetaImage.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace
{
namespace fs = std::filesystem;

class Header
{
public:
  explicit Header(const std::string& file) : File(file)
  {
    constexpr int MostLines = 1000;
    std::ifstream stream(fs::u8path(file), std::ios::binary);
    std::string line;
    for (int i = 0; i < MostLines && this->Entries.count("ElementDataFile") == 0; ++i)
    {
      if (!std::getline(stream, line))
      {
        this->Refuse("its header ends before ElementDataFile.");
      }
      const std::size_t sign = line.find('=');
      if (sign != std::string::npos)
      {
        this->Entries[Trim(line.substr(0, sign))] = Trim(line.substr(sign + 1));
      }
    }
    const std::streamoff end = stream.tellg();
    this->Rest = fs::file_size(fs::u8path(file)) - static_cast<std::uintmax_t>(end < 0 ? 0 : end);
  }

  [[noreturn]] void Refuse(const std::string& why) const
  {
    throw std::runtime_error("'" + this->File + "' could not be read: " + why);
  }

  std::string Get(const std::string& key) const
  {
    const auto found = this->Entries.find(key);
    return found == this->Entries.end() ? std::string() : found->second;
  }

  std::uintmax_t GetRest() const { return this->Rest; }

private:
  static std::string Trim(const std::string& text)
  {
    const std::size_t first = text.find_first_not_of(" \t\r");
    const std::size_t last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
  }

  std::string File;
  std::map<std::string, std::string> Entries;
  std::uintmax_t Rest = 0; // bytes after the header
};

int GetSize(const Header& header)
{
  static const std::map<std::string, int> sizes = { { "MET_CHAR", 1 }, { "MET_UCHAR", 1 },
    { "MET_SHORT", 2 }, { "MET_USHORT", 2 }, { "MET_INT", 4 }, { "MET_UINT", 4 }, { "MET_LONG", 4 },
    { "MET_ULONG", 4 }, { "MET_LONG_LONG", 8 }, { "MET_ULONG_LONG", 8 }, { "MET_FLOAT", 4 },
    { "MET_DOUBLE", 8 } };
  const auto found = sizes.find(header.Get("ElementType"));
  if (found == sizes.end())
  {
    header.Refuse("ElementType is '" + header.Get("ElementType") + "', which is none of VTK's.");
  }
  return found->second;
}

double CountSamples(const Header& header)
{
  std::istringstream sizes(header.Get("DimSize"));
  double samples = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    long long size = 0;
    sizes >> size;
    if (!sizes || size < 1 || size > (1 << 30))
    {
      header.Refuse("DimSize is '" + header.Get("DimSize") + "', but three numbers are expected.");
    }
    samples *= static_cast<double>(size);
  }
  return samples;
}
} // namespace

void CheckMetaImage(const std::string& file)
{
  const Header header(file);
  if (header.Get("NDims") != "3")
  {
    header.Refuse("NDims is '" + header.Get("NDims") + "', but 3 is expected.");
  }
  const double bytes = CountSamples(header) * GetSize(header);
  const std::string data = header.Get("ElementDataFile");
  const bool isLocal = data == "LOCAL" || data == "Local" || data == "local";
  const bool isMany = data.rfind("LIST", 0) == 0 || data.find('%') != std::string::npos;
  std::error_code problem;
  std::uintmax_t present = header.GetRest();
  if (!isLocal && !isMany)
  {
    const fs::path path = fs::u8path(file).parent_path() / fs::u8path(data);
    present = fs::file_size(path, problem);
    if (problem)
    {
      header.Refuse("its ElementDataFile '" + data + "' cannot be read.");
    }
  }
  const bool isCompressed = header.Get("CompressedData") == "True";
  constexpr double MostTimes = 1040.0; // that deflate makes less
  if (!isMany && bytes > static_cast<double>(present) * (isCompressed ? MostTimes : 1.0))
  {
    header.Refuse("DimSize asks for " + std::to_string(bytes) + " bytes of samples, more than " +
                  std::to_string(present) + " bytes of file hold.");
  }
}
