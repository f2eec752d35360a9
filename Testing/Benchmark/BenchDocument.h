/// A report, whatever it is written as.
#pragma once

#include <string>
#include <vector>

namespace flatblock::benchmarks
{
struct Block
{
  enum Kinds
  {
    Title,
    Section,
    Text,
    Code,
    Table,
    Picture
  };
  Kinds Kind;
  std::string Words;                               ///< a picture's: what it shows
  std::vector<std::vector<std::string>> Rows = {}; ///< the first is the table's head
  std::string File = {};                           ///< a picture's, in the report's folder
};

using Document = std::vector<Block>;

/// @throws std::runtime_error that names the file which cannot be written or read
void WriteMarkdown(const Document& document, const std::string& file);
/// One file that holds its pictures.
void WriteHTML(const Document& document, const std::string& file);
} // namespace flatblock::benchmarks
