/// Differential data streams, which PVM files may be compressed to.
#pragma once

#include "VolumeFormat.h"

#include <cstddef>
#include <vector>

namespace flatblock
{
/// Differential data streams as S. Roettger's V^3 writes them: "DDS v3d" or "DDS v3e" and a line
/// feed, then bits from the highest of each byte on: 2 of skip - 1, 16 of strip - 1, and runs of 7
/// bits that count bytes and 3 bits that say how many bits each of them has: 0, or one more than
/// these. A byte differs by that number, less half of its range, from the one before; from byte
/// strip + 1 on the change between the two a strip before is added, but for strips of one. A run of
/// none ends it. Bytes are sorted by their place among `skip`, in v3e in parts of 2^24 times skip.
bool IsDDS(const std::uint8_t* bytes, std::size_t count);

/// Bytes of a whole stream, once it is decoded; at most 127 in 10 bits.
/// @throws FormatError  where the stream ends early
std::uint64_t CountDDS(const std::uint8_t* bytes, std::size_t count);

/// The first bytes of a whole stream.
/// @param most  bytes that are decoded. Where they are sorted, more are gone through to find them,
///   but not kept.
/// @throws FormatError  where the stream ends early
std::vector<std::uint8_t> DecodeDDS(const std::uint8_t* bytes, std::size_t count, std::size_t most);

/// @param skip   1 to 4: the bytes of a sample
/// @param strip  1 to 65536: bytes of a row
std::vector<std::uint8_t> EncodeDDS(const std::vector<std::uint8_t>& bytes, int skip, int strip);
} // namespace flatblock
