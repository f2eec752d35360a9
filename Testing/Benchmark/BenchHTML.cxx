#include "BenchDocument.h"

#include "BenchText.h"

#include "vtkBase64Utilities.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace flatblock::benchmarks
{
namespace
{
constexpr const char* Head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>flatblock-bench</title>
<style>
body { font: 15px/1.45 sans-serif; max-width: 64em; margin: 2em auto; padding: 0 1em; }
table { border-collapse: collapse; font-size: 13px; display: block; overflow-x: auto; }
th, td { border: 1px solid #ccc; padding: 0.2em 0.6em; text-align: left; }
th { background: #f0f0f0; }
td { font-variant-numeric: tabular-nums; }
img { max-width: 100%; }
pre { background: #f6f6f6; padding: 0.6em; overflow-x: auto; }
</style>
</head>
<body>
)";

std::string Enclose(const std::string& tag, const std::string& text)
{
  return "<" + tag + ">" + text + "</" + tag + ">";
}

std::string ToTable(const Block& block)
{
  std::string table = "<table>\n";
  for (const auto& row : block.Rows)
  {
    std::string cells;
    for (const std::string& cell : row)
    {
      cells += Enclose(&row == &block.Rows.front() ? "th" : "td", EscapeHTML(cell));
    }
    table += Enclose("tr", cells) + "\n";
  }
  return table + "</table>";
}

std::string Encode(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(stream), {} };
  if (bytes.empty())
  {
    throw std::runtime_error("Cannot read '" + file + "'.");
  }
  std::string text(4 * ((bytes.size() + 2) / 3), '\0');
  vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
    static_cast<unsigned long>(bytes.size()), reinterpret_cast<unsigned char*>(text.data()));
  return text;
}

std::string ToHTML(const Block& block, const std::string& folder)
{
  switch (block.Kind)
  {
  case Block::Title:
    return Enclose("h1", EscapeHTML(block.Words));
  case Block::Section:
    return Enclose("h2", EscapeHTML(block.Words));
  case Block::Code:
    return Enclose("pre", EscapeHTML(block.Words));
  case Block::Table:
    return ToTable(block);
  case Block::Picture:
    return "<p><img alt=\"" + EscapeHTML(block.Words) + "\" src=\"data:image/png;base64," +
           Encode(folder + "/" + block.File) + "\"></p>";
  default:
    return Enclose("p", EscapeHTML(block.Words));
  }
}
} // namespace

void WriteHTML(const Document& document, const std::string& file)
{
  const std::string folder = std::filesystem::path(file).parent_path().string();
  std::ofstream stream(file);
  stream << Head;
  for (const Block& block : document)
  {
    stream << ToHTML(block, folder.empty() ? "." : folder) << "\n";
  }
  stream << "</body>\n</html>\n";
  stream.close();
  if (!stream)
  {
    throw std::runtime_error("Cannot write '" + file + "'.");
  }
}
} // namespace flatblock::benchmarks
