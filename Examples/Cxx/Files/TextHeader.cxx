#include "TextHeader.h"

#include "DataSize.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace
{
namespace fs = std::filesystem;

std::string Trim(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  const std::size_t last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

std::uintmax_t ToCount(double number)
{
  constexpr double Most = 1e18;
  return static_cast<std::uintmax_t>(std::min(number, Most));
}
} // namespace

TextHeader::TextHeader(const std::string& file, char sign, const std::string& last) : File(file)
{
  constexpr std::size_t MostBytes = 1 << 21;
  std::string bytes(MostBytes, '\0');
  std::ifstream stream(fs::u8path(file), std::ios::binary);
  stream.read(bytes.data(), MostBytes);
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  while (!this->Complete && this->Size < bytes.size())
  {
    const std::size_t end = std::min(bytes.find('\n', this->Size), bytes.size());
    const std::string line = Trim(bytes.substr(this->Size, end - this->Size));
    this->Size = std::min(end + 1, bytes.size());
    this->Complete = last.empty() && line.empty() && end < bytes.size();
    this->TakeLine(line, sign);
    this->Complete = this->Complete || (!last.empty() && this->Entries.count(last) != 0);
  }
  if (!this->Complete && bytes.size() == MostBytes)
  {
    this->Refuse("its header does not end within " + std::to_string(MostBytes) + " bytes.");
  }
}

void TextHeader::TakeLine(const std::string& line, char sign)
{
  if (this->Entries.empty() && this->FirstLine.empty())
  {
    this->FirstLine = line;
  }
  const std::size_t at = line.find(sign);
  if (at != std::string::npos && line.front() != '#')
  {
    this->Entries[Trim(line.substr(0, at))] = Trim(line.substr(at + 1));
  }
}

void TextHeader::Refuse(const std::string& why) const
{
  throw std::runtime_error("'" + this->File + "' could not be read: " + why);
}

std::string TextHeader::Get(const std::string& key) const
{
  const auto found = this->Entries.find(key);
  return found == this->Entries.end() ? std::string() : found->second;
}

std::vector<std::uintmax_t> TextHeader::GetSizes(const std::string& key, std::size_t axes) const
{
  std::istringstream words(this->Get(key));
  std::vector<std::uintmax_t> sizes;
  long long size = 0;
  while (words >> size && size >= 1 && size <= 1 << 30)
  {
    sizes.push_back(static_cast<std::uintmax_t>(size));
  }
  if (!words.eof() || sizes.size() != axes)
  {
    this->Refuse(key + " is '" + this->Get(key).substr(0, 60) + "', but " + std::to_string(axes) +
                 " numbers above 0 are expected.");
  }
  return sizes;
}

std::string TextHeader::GetDataFile(const std::string& key) const
{
  const std::string data = this->Get(key);
  const fs::path path = fs::u8path(this->File).parent_path() / fs::u8path(data);
  std::error_code problem;
  if (!fs::is_regular_file(path, problem) || !std::ifstream(path, std::ios::binary))
  {
    this->Refuse("its " + key + " '" + data + "' is no file that can be read.");
  }
  return path.u8string();
}

void TextHeader::CheckAmount(const char* unit, double wanted, double present) const
{
  if (wanted != present)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(15);
    text << "it should hold " << wanted << " " << unit << " of samples, but holds "
         << (present > wanted ? "more" : "less") << ".";
    this->Refuse(text.str());
  }
}

void TextHeader::CheckRaw(const std::string& data, std::uintmax_t offset, double bytes) const
{
  this->CheckAmount("bytes", bytes, static_cast<double>(CountBytes(data, offset)));
}

void TextHeader::CheckPacked(const std::string& data, std::uintmax_t offset, double bytes) const
{
  this->CheckAmount(
    "bytes", bytes, static_cast<double>(CountUnpacked(data, offset, ToCount(bytes))));
}

void TextHeader::CheckText(const std::string& data, std::uintmax_t offset, double numbers) const
{
  this->CheckAmount(
    "numbers", numbers, static_cast<double>(CountNumbers(data, offset, ToCount(numbers))));
}
