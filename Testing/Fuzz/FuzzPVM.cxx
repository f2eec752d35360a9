// Headers of PVM files, and streams: whatever comes in, a format or an error comes out; and what
// was encoded is decoded again.
#include "DDSCodec.h"
#include "FuzzBytes.h"
#include "PVMFormat.h"

#include <algorithm>

using namespace flatblock;

namespace
{
void Parse(const std::uint8_t* bytes, std::size_t count)
{
  const PVMFormat format = ParsePVM(bytes, count);
  for (int axis = 0; axis < 3; ++axis)
  {
    Require(format.Samples[axis] > 0 && format.Spacing[axis] > 0.0);
  }
  Require(format.Offset <= count);
  const std::uintmax_t end = format.Offset + CountBytes(format);
  const std::size_t rest = end < count ? static_cast<std::size_t>(end) : count;
  CheckPVMSize(format, count, { bytes + rest, bytes + count });
  Require(end <= count);
}

void CheckRoundTrip(const std::uint8_t* bytes, std::size_t count)
{
  FuzzBytes head(bytes, count);
  const int skip = 1 + head.TakeUpTo(3);
  const int strip = 1 + head.TakeUpTo(65535);
  const std::vector<std::uint8_t> whole(bytes, bytes + count);
  const std::vector<std::uint8_t> encoded = EncodeDDS(whole, skip, strip);
  Require(IsDDS(encoded.data(), encoded.size()));
  Require(DecodeDDS(encoded.data(), encoded.size(), whole.size() + 1) == whole);
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
  constexpr std::size_t Most = std::size_t(1) << 20;
  CheckRoundTrip(bytes, count);
  try
  {
    if (!IsDDS(bytes, count))
    {
      Parse(bytes, count);
      return 0;
    }
    const std::vector<std::uint8_t> decoded = DecodeDDS(bytes, count, Most);
    Parse(decoded.data(), decoded.size());
  }
  catch (const FormatError&)
  {
  }
  return 0;
}
