/// Numbers and words as the file formats want them, whatever the locale is.
#pragma once

#include <string>

namespace flatblock::benchmarks
{
/// With so many digits after the point; "–" where it is not finite.
std::string Fixed(double value, int digits);

/// With so many significant digits; "–" where it is not finite.
std::string Significant(double value, int digits);

/// Of 15 digits, or `missing` where it is not finite.
std::string Exact(double value, const std::string& missing);

std::string QuoteJSON(const std::string& text);
std::string QuoteCSV(const std::string& text);
std::string EscapeHTML(const std::string& text);
/// For a cell of a table.
std::string EscapeMarkdown(const std::string& text);
} // namespace flatblock::benchmarks
