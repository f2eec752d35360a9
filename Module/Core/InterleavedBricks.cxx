#include "InterleavedBricks.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

namespace flatblock
{
namespace
{
template <typename To, typename From>
To Convert(From texel)
{
  if constexpr (std::is_same_v<To, From>)
  {
    return texel;
  }
  else if constexpr (std::is_integral_v<To>)
  {
    return static_cast<To>(
      texel * (std::numeric_limits<To>::max() / std::numeric_limits<From>::max()));
  }
  else
  {
    return static_cast<To>(texel) / std::numeric_limits<From>::max();
  }
}

template <typename From, typename To>
void CopyTo(const void* from, std::size_t count, int stride, To* to)
{
  const auto* texels = static_cast<const From*>(from);
  for (std::size_t i = 0; i < count; ++i)
  {
    to[i * stride] = Convert<To>(texels[i]);
  }
}

// Never to a narrower format.
template <typename To>
void Interleave(TexelFormat format, const void* from, std::size_t count, int stride, To* to)
{
  if (format == TexelFormat::Unsigned8)
  {
    return CopyTo<std::uint8_t>(from, count, stride, to);
  }
  if constexpr (!std::is_same_v<To, std::uint8_t>)
  {
    if (format == TexelFormat::Unsigned16)
    {
      return CopyTo<std::uint16_t>(from, count, stride, to);
    }
    if constexpr (std::is_same_v<To, float>)
    {
      CopyTo<float>(from, count, stride, to);
    }
  }
}
} // namespace

InterleavedBricks::InterleavedBricks(std::vector<const BrickSource*> sources, bool isMask)
  : Sources(std::move(sources)), IsMask(isMask), Encoding(this->Sources.front()->GetEncoding())
{
  for (const BrickSource* source : this->Sources)
  {
    this->Encoding.Format = std::max(this->Encoding.Format, source->GetEncoding().Format);
  }
  this->Encoding.Components = this->Sources.size() == 2 ? 2 : 4;
}

void InterleavedBricks::ReadBrick(
  std::int64_t block, int level, const BlockBorder& border, void* texels) const
{
  const auto side = static_cast<std::size_t>(this->GetGrid().GetTexelSide(level));
  const std::size_t count = side * side * side;
  const int stride = this->Encoding.Components;
  std::fill_n(
    static_cast<std::uint8_t*>(texels), count * BytesPerTexel(this->Encoding), std::uint8_t(0));
  std::vector<std::uint8_t> brick;
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    const TexelFormat format = this->Sources[i]->GetEncoding().Format;
    brick.resize(count * BytesPerTexel(this->Sources[i]->GetEncoding()));
    const bool isLast = i + 1 == this->Sources.size();
    this->Sources[i]->ReadBrick(
      block, level, this->IsMask && isLast ? BlockBorder{} : border, brick.data());
    switch (this->Encoding.Format)
    {
    case TexelFormat::Unsigned8:
      Interleave(format, brick.data(), count, stride, static_cast<std::uint8_t*>(texels) + i);
      break;
    case TexelFormat::Unsigned16:
      Interleave(format, brick.data(), count, stride, static_cast<std::uint16_t*>(texels) + i);
      break;
    case TexelFormat::Float32:
      Interleave(format, brick.data(), count, stride, static_cast<float*>(texels) + i);
      break;
    }
  }
}
} // namespace flatblock
