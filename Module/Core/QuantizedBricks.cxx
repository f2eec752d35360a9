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
  for (const TexelRange& range : this->Ranges)
  {
    this->Encoding.Step = std::max(this->Encoding.Step, range.Extent / this->LastValue);
  }
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
} // namespace flatblock
