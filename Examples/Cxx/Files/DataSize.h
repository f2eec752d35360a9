/// How much a file holds, once it is unpacked.
#pragma once

#include <cstdint>
#include <string>

/// What deflate packs into a byte at best: https://zlib.net/zlib_tech.html, maximum compression.
constexpr std::uintmax_t MostTimesUnpacked = 1032;

/// Bytes that are unpacked to be counted, at most.
constexpr std::uintmax_t MostToUnpack = std::uintmax_t(64) << 20;

/// Unpacks what is in a file, gzip or zlib, from an offset on, and counts it. Stops where there are
/// more than `most`, so that no file can make it long.
/// @param most  bytes. Beyond 64 MiB it would take too long, and the file's own bytes answer: that
///   they may hold as much, since deflate packs 1032 bytes into one at best.
/// @return bytes; less than most where the stream is damaged, more than most where it goes on
std::uintmax_t CountUnpacked(const std::string& file, std::uintmax_t offset, std::uintmax_t most);

/// A raw file's bytes from an offset on.
std::uintmax_t CountBytes(const std::string& file, std::uintmax_t offset);

/// Numbers in text from an offset on.
/// @return numbers up to the end, or to the first word that is none; most + 1 where there are more
std::uintmax_t CountNumbers(const std::string& file, std::uintmax_t offset, std::uintmax_t most);
