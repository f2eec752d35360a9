#include "DF3Format.h"

namespace flatblock
{
VolumeFormat ParseDF3(const std::uint8_t* header, std::size_t count, std::uintmax_t fileSize)
{
  if (count < DF3HeaderBytes)
  {
    throw FormatError(
      count, "the file ends within the header of " + std::to_string(DF3HeaderBytes) + " bytes.");
  }
  VolumeFormat format;
  format.Offset = DF3HeaderBytes;
  std::uintmax_t samples = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    format.Samples[axis] = header[2 * axis] * 256 + header[2 * axis + 1];
    samples *= static_cast<std::uintmax_t>(format.Samples[axis]);
    if (format.Samples[axis] == 0)
    {
      throw FormatError(2 * axis, "a number of samples is 0, but 1 or more is expected.");
    }
  }
  for (const int bytes : { 1, 2, 4 })
  {
    if (samples * bytes == fileSize - DF3HeaderBytes)
    {
      format.BytesPerSample = bytes;
      return format;
    }
  }
  throw FormatError(DF3HeaderBytes, "the file has " + std::to_string(fileSize - DF3HeaderBytes) +
                                      " bytes from here on, but " + std::to_string(samples) +
                                      " samples of 1, 2 or 4 bytes are expected.");
}

std::vector<std::uint8_t> MakeDF3Header(const std::array<int, 3>& samples)
{
  constexpr int Most = 65535;
  std::vector<std::uint8_t> header;
  for (const int count : samples)
  {
    if (count < 1 || count > Most)
    {
      throw std::invalid_argument(
        "DF3 has 1 to 65535 samples along an axis, and not " + std::to_string(count) + ".");
    }
    header.push_back(static_cast<std::uint8_t>(count / 256));
    header.push_back(static_cast<std::uint8_t>(count % 256));
  }
  return header;
}
} // namespace flatblock
