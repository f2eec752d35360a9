#include "BenchDocument.h"

#include "BenchText.h"

#include <fstream>
#include <stdexcept>

namespace flatblock::benchmarks
{
namespace
{
std::string ToRow(const std::vector<std::string>& cells)
{
  std::string row = "|";
  for (const std::string& cell : cells)
  {
    row += " " + EscapeMarkdown(cell) + " |";
  }
  return row + "\n";
}

std::string ToTable(const Block& block)
{
  std::string table;
  for (const auto& row : block.Rows)
  {
    table += ToRow(row);
    if (&row == &block.Rows.front())
    {
      table += ToRow(std::vector<std::string>(row.size(), "---"));
    }
  }
  return table;
}

std::string ToMarkdown(const Block& block)
{
  switch (block.Kind)
  {
  case Block::Title:
    return "# " + block.Words + "\n";
  case Block::Section:
    return "## " + block.Words + "\n";
  case Block::Code:
    return "```\n" + block.Words + "\n```\n";
  case Block::Table:
    return ToTable(block);
  case Block::Picture:
    return "![" + block.Words + "](" + block.File + ")\n";
  default:
    return block.Words + "\n";
  }
}
} // namespace

void WriteMarkdown(const Document& document, const std::string& file)
{
  std::ofstream stream(file);
  for (const Block& block : document)
  {
    stream << (&block == &document.front() ? "" : "\n") << ToMarkdown(block);
  }
  stream.close();
  if (!stream)
  {
    throw std::runtime_error("Cannot write '" + file + "'.");
  }
}
} // namespace flatblock::benchmarks
