// Headers of DF3 files: a format that fits the file, or an error.
#include "DF3Format.h"
#include "FuzzBytes.h"

#include <algorithm>

using namespace flatblock;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
  FuzzBytes head(bytes, count);
  const auto claimed = head.Take<std::uint64_t>();
  for (const std::uintmax_t size : { std::uintmax_t(count), std::uintmax_t(claimed) })
  {
    try
    {
      const VolumeFormat format = ParseDF3(bytes, count, size < count ? count : size);
      Require(DF3HeaderBytes + CountBytes(format) == (size < count ? count : size));
      const std::vector<std::uint8_t> header = MakeDF3Header(format.Samples);
      Require(std::equal(header.begin(), header.end(), bytes));
    }
    catch (const FormatError&)
    {
    }
  }
  return 0;
}
