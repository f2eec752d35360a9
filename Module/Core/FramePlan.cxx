#include "FramePlan.h"

#include <algorithm>
#include <map>

namespace flatblock
{
namespace
{
std::vector<std::int64_t> CountBricks(const std::vector<std::int8_t>& levels, int numberOfLevels)
{
  std::vector<std::int64_t> bricks(numberOfLevels, 0);
  for (const std::int8_t level : levels)
  {
    if (level != NoLevel)
    {
      ++bricks[level];
    }
  }
  return bricks;
}

// Above what bricks of any level and border can be.
constexpr std::int8_t NotUploaded = 100;

// As deep as it may be where it holds coarse bricks, since they are to be refined one day.
std::int64_t GetWantedDepth(const std::vector<std::int64_t>& bricks, const AtlasShape& shape)
{
  const bool isFinest =
    std::all_of(bricks.begin() + 1, bricks.end(), [](std::int64_t count) { return count == 0; });
  const std::int64_t depth = std::max<std::int64_t>(shape.GetDepthOf(bricks), shape.GetSide(0));
  return std::min<std::int64_t>(isFinest ? depth : shape.GetDepth(), shape.GetDepth());
}
} // namespace

void Residency::Clear()
{
  *this = Residency();
}

bool Residency::CanKeepAtlas(const std::vector<std::int64_t>& bricks, const AtlasShape& shape) const
{
  const AtlasShape& current = this->Atlas.GetShape();
  if (current.GetNumberOfLevels() != shape.GetNumberOfLevels())
  {
    return false;
  }
  const std::int64_t depth = this->Atlas.GetTextureSize()[2];
  return current.GetDepthOf(bricks) <= depth && depth <= 2 * GetWantedDepth(bricks, current) &&
         this->Atlas.GetTexels() <= shape.GetMostTexels();
}

void Residency::StartAnew(std::size_t blocks, const std::vector<std::int64_t>& bricks,
  const AtlasShape& shape, FramePlan& plan)
{
  this->Atlas = AtlasAllocator(shape, static_cast<int>(GetWantedDepth(bricks, shape)));
  this->Levels.assign(blocks, NoLevel);
  this->Borders.assign(blocks, BlockBorder{ NotUploaded });
  this->Places.assign(blocks, BrickPlace());
  plan.NewAtlas = true;
  plan.NewPlaces = true;
}

// Gives every brick its place.
void Residency::Place(const std::vector<std::int8_t>& levels, FramePlan& plan)
{
  for (std::size_t block = 0; block < levels.size(); ++block)
  {
    if (levels[block] != this->Levels[block] && this->Places[block].IsResident())
    {
      this->Atlas.Free(this->Places[block]);
      this->Places[block] = BrickPlace();
    }
  }
  for (std::size_t block = 0; block < levels.size(); ++block)
  {
    if (levels[block] != NoLevel && !this->Places[block].IsResident())
    {
      auto place = this->Atlas.Allocate(levels[block]);
      if (!place)
      {
        this->Compact(plan);
        place = this->Atlas.Allocate(levels[block]);
      }
      this->Places[block] = place.value();
      this->Borders[block][0] = NotUploaded;
    }
  }
  this->Levels = levels;
}

void Residency::Compact(FramePlan& plan)
{
  const Compaction compaction = this->Atlas.Compact();
  std::map<BrickPlace, BrickPlace> moved(compaction.NewPlaces.begin(), compaction.NewPlaces.end());
  for (BrickPlace& place : this->Places)
  {
    // A brick may go on from where it came to.
    for (auto next = moved.find(place); next != moved.end(); next = moved.find(place))
    {
      place = next->second;
      moved.erase(next);
    }
  }
  plan.Moves.insert(plan.Moves.end(), compaction.Moves.begin(), compaction.Moves.end());
}

FramePlan Residency::Plan(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
  const AtlasShape& shape, bool continuity)
{
  FramePlan plan;
  const auto bricks = CountBricks(levels, shape.GetNumberOfLevels());
  if (!this->CanKeepAtlas(bricks, shape))
  {
    this->StartAnew(levels.size(), bricks, shape, plan);
  }
  else if (this->Levels == levels && this->Continuity == continuity)
  {
    return plan;
  }
  this->Continuity = continuity;
  plan.NewPlaces = plan.NewPlaces || this->Levels != levels;
  this->Place(levels, plan);
  for (std::size_t block = 0; block < levels.size(); ++block)
  {
    if (levels[block] == NoLevel)
    {
      continue;
    }
    const auto number = static_cast<std::int64_t>(block);
    const BlockBorder border = continuity ? GetBlockBorder(grid, levels, number) : BlockBorder{};
    if (border != this->Borders[block])
    {
      this->Borders[block] = border;
      plan.Uploads.push_back({ number, levels[block], border, this->Places[block] });
    }
  }
  return plan;
}
} // namespace flatblock
