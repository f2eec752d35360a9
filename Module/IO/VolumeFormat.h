/// What headers of volume files say.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace flatblock
{
struct VolumeFormat
{
  std::array<int, 3> Samples = { 0, 0, 0 };
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };
  int BytesPerSample = 1;    ///< of unsigned integers, big end first
  std::uintmax_t Offset = 0; ///< of the first sample
};

/// What is wrong with a file, and where.
class FormatError : public std::runtime_error
{
public:
  FormatError(std::uintmax_t offset, const std::string& what)
    : std::runtime_error("at byte " + std::to_string(offset) + ": " + what)
  {
  }
};

/// Bytes of all samples. Throws where they are more than a file may have.
inline std::uintmax_t CountBytes(const VolumeFormat& format)
{
  constexpr double Most = 1e18;
  double bytes = format.BytesPerSample;
  for (const int samples : format.Samples)
  {
    bytes *= samples;
  }
  if (!(bytes < Most))
  {
    throw FormatError(0, "the header asks for " + std::to_string(bytes) + " bytes of samples.");
  }
  return static_cast<std::uintmax_t>(format.Samples[0]) * format.Samples[1] * format.Samples[2] *
         format.BytesPerSample;
}
} // namespace flatblock
