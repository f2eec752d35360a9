/// POV-Ray's density files.
#pragma once

#include "VolumeFormat.h"

#include <cstddef>
#include <vector>

namespace flatblock
{
constexpr std::size_t DF3HeaderBytes = 6;

/// Three numbers of 16 bit, big end first; samples of 8, 16 or 32 bit follow, and their width is
/// what the file's size leaves for each. Throws FormatError.
VolumeFormat ParseDF3(const std::uint8_t* header, std::size_t count, std::uintmax_t fileSize);

/// Throws std::invalid_argument where the format has no room for the numbers.
std::vector<std::uint8_t> MakeDF3Header(const std::array<int, 3>& samples);
} // namespace flatblock
