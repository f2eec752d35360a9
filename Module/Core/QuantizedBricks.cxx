#include "QuantizedBricks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace flatblock
{
namespace
{
template <typename T>
void Quantize(const void* texels, std::size_t count, const TexelRange& range, double last,
  std::uint8_t* quantized)
{
  const double whole =
    std::is_integral_v<T> ? static_cast<double>(std::numeric_limits<T>::max()) : 1.0;
  const double scale = range.Extent > 0.0F ? last / range.Extent : 0.0;
  const auto* source = static_cast<const T*>(texels);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double number = (static_cast<double>(source[i]) / whole - range.Lowest) * scale;
    const double rounded = std::round(std::clamp(number, 0.0, last));
    quantized[i] = static_cast<std::uint8_t>(std::lround(rounded * (255.0 / last)));
  }
}
} // namespace

QuantizedBricks::QuantizedBricks(
  const BrickSource& source, std::vector<TexelRange> ranges, int bits)
  : Source(source), Ranges(std::move(ranges)), Encoding(source.GetEncoding()),
    LastValue((1 << bits) - 1)
{
  this->Encoding.Format = TexelFormat::Unsigned8;
}

void QuantizedBricks::ReadBrick(
  std::int64_t block, int level, const BlockBorder& border, void* texels) const
{
  const auto side = static_cast<std::size_t>(this->GetGrid().GetTexelSide(level));
  const std::size_t count = side * side * side;
  const TexelFormat format = this->Source.GetEncoding().Format;
  std::vector<std::uint8_t> whole(count * BytesPerTexel(format));
  this->Source.ReadBrick(block, level, border, whole.data());
  const TexelRange& range = this->Ranges[static_cast<std::size_t>(block)];
  auto* quantized = static_cast<std::uint8_t*>(texels);
  switch (format)
  {
  case TexelFormat::Unsigned8:
    return Quantize<std::uint8_t>(whole.data(), count, range, this->LastValue, quantized);
  case TexelFormat::Unsigned16:
    return Quantize<std::uint16_t>(whole.data(), count, range, this->LastValue, quantized);
  case TexelFormat::Float32:
    return Quantize<float>(whole.data(), count, range, this->LastValue, quantized);
  }
}

std::vector<TexelRange> WidenRanges(const Index3& blocks, const std::vector<TexelRange>& ranges)
{
  std::vector<TexelRange> wide = ranges;
  const auto blockAt = [&blocks](int x, int y, int z)
  { return (static_cast<std::size_t>(z) * blocks[1] + y) * blocks[0] + x; };
  for (int i = 0; i < 27 * static_cast<int>(ranges.size()); ++i)
  {
    const int number = i / 27;
    const int x = number % blocks[0] + i % 3 - 1;
    const int y = number / blocks[0] % blocks[1] + i / 3 % 3 - 1;
    const int z = number / (blocks[0] * blocks[1]) + i / 9 % 3 - 1;
    if (x >= 0 && x < blocks[0] && y >= 0 && y < blocks[1] && z >= 0 && z < blocks[2])
    {
      TexelRange& range = wide[static_cast<std::size_t>(number)];
      const TexelRange& other = ranges[blockAt(x, y, z)];
      const float highest = std::max(range.Lowest + range.Extent, other.Lowest + other.Extent);
      range.Lowest = std::min(range.Lowest, other.Lowest);
      range.Extent = highest - range.Lowest;
    }
  }
  return wide;
}
} // namespace flatblock
