#include "AtlasAllocator.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace flatblock
{
std::optional<Index3> AtlasAllocator::FindShape(std::int64_t bricks, int side, int largestTexture)
{
  const std::int64_t most = largestTexture / side;
  const std::int64_t wanted = std::max<std::int64_t>(bricks, 1);
  std::optional<Index3> best;
  std::int64_t fewest = std::numeric_limits<std::int64_t>::max();
  int thinnest = 0;
  for (std::int64_t z = 1; z <= most; ++z)
  {
    for (std::int64_t y = 1; y <= z; ++y)
    {
      const std::int64_t x = (wanted + y * z - 1) / (y * z);
      if (x > most)
      {
        continue;
      }
      // Few places left over first; among those, the shape nearest to a cube.
      const std::int64_t places = x * y * z;
      const int thickness = static_cast<int>(std::min({ x, y, z }));
      if (places < fewest || (places == fewest && thickness > thinnest))
      {
        fewest = places;
        thinnest = thickness;
        best = Index3{ static_cast<int>(x), static_cast<int>(y), static_cast<int>(z) };
      }
    }
  }
  return best;
}

AtlasAllocator::AtlasAllocator(const Index3& shape, int side)
  : Shape(shape), Side(side), FreePlaces(static_cast<std::size_t>(shape[0]) * shape[1] * shape[2])
{
  std::iota(this->FreePlaces.rbegin(), this->FreePlaces.rend(), 0);
}

std::int64_t AtlasAllocator::GetCapacity() const
{
  return static_cast<std::int64_t>(this->Shape[0]) * this->Shape[1] * this->Shape[2];
}

std::int64_t AtlasAllocator::GetNumberOfFreePlaces() const
{
  return static_cast<std::int64_t>(this->FreePlaces.size());
}

Index3 AtlasAllocator::GetTextureSize() const
{
  return { this->Shape[0] * this->Side, this->Shape[1] * this->Side, this->Shape[2] * this->Side };
}

int AtlasAllocator::Allocate()
{
  const int place = this->FreePlaces.back();
  this->FreePlaces.pop_back();
  return place;
}

void AtlasAllocator::Free(int place)
{
  this->FreePlaces.push_back(place);
}

Index3 AtlasAllocator::GetOrigin(int place) const
{
  const int row = place / this->Shape[0];
  return { place % this->Shape[0] * this->Side, row % this->Shape[1] * this->Side,
    row / this->Shape[1] * this->Side };
}
} // namespace flatblock
