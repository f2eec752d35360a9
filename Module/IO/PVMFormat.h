/// S. Roettger's volume files.
#pragma once

#include "VolumeFormat.h"

#include <cstddef>
#include <vector>

namespace flatblock
{
struct PVMFormat : public VolumeFormat
{
  int Version = 1;
};

/// Bytes in which a header ends, if its comments are not longer than most of them.
constexpr std::size_t MostPVMHeaderBytes = 65536;

/// Lines of text: "PVM", or "PVM2" or "PVM3" where spacings are given; three numbers of samples;
/// three spacings; bytes of a sample, 1 or 2, big end first. Lines that begin with # are skipped.
/// Samples follow, and after those of PVM3 four texts that end with 0. Throws FormatError.
/// @param bytes  from the first one of the file on, as many as are there, or MostPVMHeaderBytes
PVMFormat ParsePVM(const std::uint8_t* bytes, std::size_t count);

/// Throws FormatError where a file of `total` bytes has less or more than the header asks for.
/// @param rest  what follows the samples, if there is something
void CheckPVMSize(
  const PVMFormat& format, std::uintmax_t total, const std::vector<std::uint8_t>& rest);

/// A PVM3 file, without texts.
/// @param samples  CountBytes(format) bytes
std::vector<std::uint8_t> MakePVM(const VolumeFormat& format, const std::uint8_t* samples);
} // namespace flatblock
