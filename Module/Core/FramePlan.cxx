#include "FramePlan.h"

#include <algorithm>

namespace flatblock
{
void Residency::Clear()
{
  this->Atlas = AtlasAllocator();
  this->Places.clear();
}

std::optional<FramePlan> Residency::Plan(
  const std::vector<std::uint8_t>& wanted, int brickSide, int largestTexture)
{
  FramePlan plan;
  const std::int64_t bricks =
    std::count_if(wanted.begin(), wanted.end(), [](std::uint8_t w) { return w != 0; });
  const std::int64_t capacity = this->Atlas.GetCapacity();
  if (capacity == 0 || bricks > capacity || capacity > 2 * std::max<std::int64_t>(bricks, 1))
  {
    const auto shape = AtlasAllocator::FindShape(bricks, brickSide, largestTexture);
    if (!shape)
    {
      return {};
    }
    this->Atlas = AtlasAllocator(*shape, brickSide);
    this->Places.assign(wanted.size(), NotResident);
    plan.NewAtlas = true;
    plan.NewPlaces = true;
  }

  for (std::size_t block = 0; block < wanted.size(); ++block)
  {
    if (!wanted[block] && this->Places[block] != NotResident)
    {
      this->Atlas.Free(this->Places[block]);
      this->Places[block] = NotResident;
      plan.NewPlaces = true;
    }
  }
  for (std::size_t block = 0; block < wanted.size(); ++block)
  {
    if (wanted[block] && this->Places[block] == NotResident)
    {
      this->Places[block] = this->Atlas.Allocate();
      plan.Uploads.push_back({ static_cast<std::int64_t>(block), this->Places[block] });
      plan.NewPlaces = true;
    }
  }
  return plan;
}
} // namespace flatblock
