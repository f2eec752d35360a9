#include "BenchText.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace flatblock::benchmarks
{
namespace
{
constexpr const char* None = "–";

template <typename... Manipulators>
std::string Write(double value, Manipulators... manipulators)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  (stream << ... << manipulators) << value;
  return stream.str();
}

template <typename Escape>
std::string Replace(const std::string& text, Escape escape)
{
  std::string out;
  for (char c : text)
  {
    out += escape(c);
  }
  return out;
}
} // namespace

std::string Fixed(double value, int digits)
{
  return std::isfinite(value) ? Write(value, std::fixed, std::setprecision(digits)) : None;
}

std::string Significant(double value, int digits)
{
  return std::isfinite(value) ? Write(value, std::setprecision(digits)) : None;
}

std::string Exact(double value, const std::string& missing)
{
  return std::isfinite(value) ? Write(value, std::setprecision(15)) : missing;
}

std::string QuoteJSON(const std::string& text)
{
  const auto escape = [](char c) -> std::string
  {
    if (c == '"' || c == '\\')
    {
      return std::string("\\") + c;
    }
    if (static_cast<unsigned char>(c) < 0x20)
    {
      std::ostringstream stream;
      stream << "\\u" << std::hex << std::setw(4) << std::setfill('0') << int(c);
      return stream.str();
    }
    return std::string(1, c);
  };
  return "\"" + Replace(text, escape) + "\"";
}

std::string QuoteCSV(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
  {
    return text;
  }
  return "\"" + Replace(text, [](char c) { return std::string(c == '"' ? 2 : 1, c); }) + "\"";
}

std::string EscapeHTML(const std::string& text)
{
  return Replace(text,
    [](char c) -> std::string {
      return c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
    });
}

std::string EscapeMarkdown(const std::string& text)
{
  return Replace(text,
    [](char c) { return c == '|' ? std::string("\\|") : std::string(1, c == '\n' ? ' ' : c); });
}
} // namespace flatblock::benchmarks
