#include "OneLine.h"

#include <numeric>
#include <vector>

namespace
{
// Bytes of the character at a place; 0 where there is none that can be shown.
std::size_t GetLength(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i)
  { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U; };
  const unsigned int first = byte(0);
  const bool isControl = first < 0x20 || first == 0x7f || (first == 0xc2 && byte(1) < 0xa0);
  if (isControl || (first >= 0x80 && first < 0xc2) || first > 0xf4)
  {
    return 0;
  }
  const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(i) & 0xc0) != 0x80)
    {
      return 0;
    }
  }
  return length;
}
} // namespace

std::string ToOneLine(const std::string& text)
{
  constexpr std::ptrdiff_t Half = 500;
  std::vector<std::string> characters;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = GetLength(text, at);
    characters.push_back(length > 0 ? text.substr(at, length) : (text[at] == '\n' ? " " : "?"));
    at += length > 0 ? length : 1;
  }
  if (characters.size() > 2 * Half)
  {
    characters.erase(characters.begin() + Half, characters.end() - Half);
    characters.insert(characters.begin() + Half, " ... ");
  }
  return std::accumulate(characters.begin(), characters.end(), std::string());
}
