/// What is told of files, which may hold anything.
#pragma once

#include <string>

/// Text as one line that no terminal obeys: ends of lines are spaces, and controls and what is not
/// UTF-8 are question marks. Of more than 1000 characters the middle is left out.
std::string ToOneLine(const std::string& text);
