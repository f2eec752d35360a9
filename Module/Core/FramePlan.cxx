#include "FramePlan.h"

#include "Relocation.h"

#include <algorithm>
#include <limits>
#include <map>

namespace flatblock
{
namespace
{
// As deep as it may be where it holds coarse bricks, since they are to be refined one day; else a
// power of two of slabs, so that it seldom changes, and one of each level on the way to the finest.
int GetCanonicalDepth(const std::vector<std::int8_t>& levels, const AtlasShape& shape)
{
  std::vector<std::int64_t> bricks = CountBricks(levels, shape);
  if (std::any_of(bricks.begin() + 1, bricks.end(), [](std::int64_t count) { return count > 0; }))
  {
    return shape.GetDepth();
  }
  const std::int64_t perSlab = shape.GetBricksPerSlab(0);
  std::int64_t slabs = 1;
  while (slabs * perSlab < bricks[0])
  {
    slabs *= 2;
  }
  const std::int64_t depth = slabs * shape.GetSide(0) + shape.GetDepthOnTheWay();
  return static_cast<int>(std::min<std::int64_t>(depth, shape.GetDepth()));
}
} // namespace

void Residency::Clear()
{
  *this = Residency();
}

void Residency::StartAnew(std::size_t blocks, int depth, const AtlasShape& shape, FramePlan& plan)
{
  this->Atlas = AtlasAllocator(shape, depth);
  this->Levels.assign(blocks, NoLevel);
  this->Places.assign(blocks, BrickPlace());
  this->IsCanonical = false;
  plan.NewAtlas = true;
  plan.NewPlaces = true;
}

FramePlan Residency::PlanStill(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
  const AtlasShape& shape, Continuity continuity)
{
  FramePlan plan;
  const int depth = GetCanonicalDepth(levels, shape);
  if (!this->Atlas.GetShape().IsSameGrid(shape) || this->Atlas.GetTextureSize()[2] != depth)
  {
    this->StartAnew(levels.size(), depth, shape, plan);
  }
  if (this->Levels != levels || !this->IsCanonical)
  {
    this->TakeCanonicalPlaces(levels, plan);
    plan.NewPlaces = true;
  }
  this->PlanUploads(grid, levels, continuity, plan);
  return plan;
}

// Those that an empty atlas would give them.
void Residency::TakeCanonicalPlaces(const std::vector<std::int8_t>& levels, FramePlan& plan)
{
  AtlasAllocator atlas(this->Atlas.GetShape(), this->Atlas.GetTextureSize()[2]);
  std::vector<BrickPlace> places(levels.size());
  std::vector<std::uint8_t> stays(levels.size(), 0);
  for (std::size_t block = 0; block < levels.size(); ++block)
  {
    if (levels[block] != NoLevel)
    {
      places[block] = atlas.Allocate(levels[block]).value();
      stays[block] = levels[block] == this->Levels[block] ? 1 : 0;
    }
  }
  Relocation relocation = Relocate(this->Atlas, this->Places, atlas, places, stays);
  plan.Moves = std::move(relocation.Moves);
  this->Dropped = std::move(relocation.Dropped);
  this->Atlas = std::move(atlas);
  this->Places = std::move(places);
  this->IsCanonical = true;
}

FramePlan Residency::PlanStep(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
  const std::vector<std::uint16_t>& order, const AtlasShape& shape, Continuity continuity,
  const RefinementBudget& budget)
{
  FramePlan plan;
  const int depth = this->Atlas.GetTextureSize()[2];
  if (!this->Atlas.GetShape().IsSameGrid(shape) || depth > shape.GetDepth() ||
      shape.GetDepthOf(CountBricks(levels, shape)) > depth)
  {
    this->StartAnew(levels.size(), GetCanonicalDepth(levels, shape), shape, plan);
  }
  const auto step = [&](const RefinementBudget& most)
  {
    const Refiner refiner(grid, shape, this->Atlas.GetTextureSize()[2], continuity);
    return refiner.StepTowards(levels, this->Levels, order, most);
  };
  std::vector<std::int8_t> next = step(budget);
  if (next != this->Levels)
  {
    const Residency before = *this;
    const bool isNew = plan.NewAtlas;
    if (!this->TakePlaces(next, budget.Texels, plan))
    {
      *this = before;
      plan = { isNew, true, {}, {} };
      this->Compact(budget.Texels, plan);
      if (!plan.Moves.empty())
      {
        return plan;
      }
      // What is there lies close together, but the change itself opens a gap.
      next = step({ 1, 1 });
      if (!this->TakePlaces(next, std::numeric_limits<std::int64_t>::max(), plan))
      {
        *this = before;
        plan = this->PlanStill(grid, levels, shape, continuity);
        plan.NewAtlas = plan.NewAtlas || isNew;
        return plan;
      }
    }
    plan.NewPlaces = true;
  }
  this->PlanUploads(grid, next, continuity, plan);
  return plan;
}

// Gives every brick its place; false where that takes more moves than allowed.
bool Residency::TakePlaces(
  const std::vector<std::int8_t>& levels, std::int64_t mostTexelsToMove, FramePlan& plan)
{
  this->IsCanonical = false;
  for (std::size_t block = 0; block < levels.size(); ++block)
  {
    if (levels[block] != this->Levels[block] && this->Places[block].IsResident())
    {
      this->Atlas.Free(this->Places[block]);
      this->Places[block] = BrickPlace();
    }
  }
  bool isCompact = false;
  for (std::size_t block = 0; block < levels.size(); ++block)
  {
    if (levels[block] == NoLevel || this->Places[block].IsResident())
    {
      continue;
    }
    auto place = this->Atlas.Allocate(levels[block]);
    if (!place && !isCompact)
    {
      this->Compact(mostTexelsToMove, plan);
      isCompact = true;
      place = this->Atlas.Allocate(levels[block]);
    }
    if (!place)
    {
      return false;
    }
    this->Places[block] = *place;
  }
  return true;
}

void Residency::Compact(std::int64_t mostTexels, FramePlan& plan)
{
  const Compaction compaction = this->Atlas.Compact(mostTexels);
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
  this->IsCanonical = this->IsCanonical && compaction.Moves.empty();
  plan.Moves.insert(plan.Moves.end(), compaction.Moves.begin(), compaction.Moves.end());
}

// Bricks that are new come whole; those whose border changes, in part.
void Residency::PlanUploads(const BlockGrid& grid, const std::vector<std::int8_t>& levels,
  Continuity continuity, FramePlan& plan)
{
  std::vector<std::uint8_t> touched;
  if (this->Borders != continuity)
  {
    touched.assign(levels.size(), 1);
  }
  else if (this->Levels != levels || !this->Dropped.empty())
  {
    touched = FindTouched(grid, this->Levels, levels);
  }
  for (const std::int64_t block : this->Dropped)
  {
    touched[block] = 2;
  }
  for (std::size_t i = 0; i < touched.size(); ++i)
  {
    if (!touched[i] || levels[i] == NoLevel)
    {
      continue;
    }
    const auto block = static_cast<std::int64_t>(i);
    const BlockBorder border = GetBlockBorder(grid, levels, block, continuity);
    const bool isWhole = touched[i] == 2 || levels[i] != this->Levels[i];
    const BrickParts parts =
      isWhole ? WholeBrick
              : GetChangedParts(GetBlockBorder(grid, this->Levels, block, this->Borders), border);
    if (parts != 0)
    {
      plan.Uploads.push_back({ block, levels[i], border, this->Places[i], parts });
    }
  }
  this->Dropped.clear();
  this->Levels = levels;
  this->Borders = continuity;
}
} // namespace flatblock
