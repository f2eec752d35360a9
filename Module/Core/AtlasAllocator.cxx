#include "AtlasAllocator.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace flatblock
{
AtlasAllocator::AtlasAllocator(const AtlasShape& shape, int depth)
  : Shape(shape), Depth(depth), OpenSlabs(shape.GetNumberOfLevels())
{
}

Index3 AtlasAllocator::GetTextureSize() const
{
  return { this->Shape.GetWidth(), this->Shape.GetHeight(), this->Depth };
}

std::optional<BrickPlace> AtlasAllocator::Allocate(int level)
{
  auto& open = this->OpenSlabs[level];
  if (open.empty())
  {
    const std::optional<int> gap = this->FindGap(this->Shape.GetSide(level));
    if (!gap)
    {
      return {};
    }
    open.emplace(*gap, this->AddSlab(level, *gap));
  }
  BrickPlace place;
  place.Slab = open.begin()->second;
  std::vector<int>& bricks = this->Slabs[place.Slab].FreeBricks;
  place.Brick = bricks.back();
  bricks.pop_back();
  if (bricks.empty())
  {
    open.erase(open.begin());
  }
  return place;
}

std::optional<int> AtlasAllocator::FindGap(int thickness) const
{
  std::vector<std::pair<int, int>> taken; // first layer, and the one after the last
  for (const Slab& slab : this->Slabs)
  {
    if (slab.Level >= 0)
    {
      taken.emplace_back(slab.FirstLayer, slab.FirstLayer + this->Shape.GetSide(slab.Level));
    }
  }
  std::sort(taken.begin(), taken.end());
  int layer = 0;
  for (const auto& [first, end] : taken)
  {
    if (first - layer >= thickness)
    {
      return layer;
    }
    layer = end;
  }
  return this->Depth - layer >= thickness ? std::optional<int>(layer) : std::nullopt;
}

int AtlasAllocator::AddSlab(int level, int firstLayer)
{
  const auto unused = std::find_if(
    this->Slabs.begin(), this->Slabs.end(), [](const Slab& slab) { return slab.Level < 0; });
  const auto number = static_cast<int>(unused - this->Slabs.begin());
  if (unused == this->Slabs.end())
  {
    this->Slabs.emplace_back();
  }
  Slab& slab = this->Slabs[number];
  slab.Level = level;
  slab.FirstLayer = firstLayer;
  slab.FreeBricks.resize(static_cast<std::size_t>(this->Shape.GetBricksPerSlab(level)));
  std::iota(slab.FreeBricks.rbegin(), slab.FreeBricks.rend(), 0);
  return number;
}

void AtlasAllocator::Free(const BrickPlace& place)
{
  Slab& slab = this->Slabs[place.Slab];
  slab.FreeBricks.push_back(place.Brick);
  auto& open = this->OpenSlabs[slab.Level];
  open.emplace(slab.FirstLayer, place.Slab);
  const auto free = static_cast<std::int64_t>(slab.FreeBricks.size());
  if (free == this->Shape.GetBricksPerSlab(slab.Level))
  {
    open.erase({ slab.FirstLayer, place.Slab });
    slab = Slab();
  }
}

namespace
{
// Whether there is still a move to spend.
bool Spend(const Index3& size, std::int64_t mostTexels, Compaction& compaction)
{
  const std::int64_t texels = static_cast<std::int64_t>(size[0]) * size[1] * size[2];
  if (compaction.Texels > 0 && compaction.Texels + texels > mostTexels)
  {
    return false;
  }
  compaction.Texels += texels;
  return true;
}
} // namespace

Compaction AtlasAllocator::Compact(std::int64_t mostTexels)
{
  Compaction compaction;
  bool isDone = true;
  for (int level = 0; isDone && level < this->Shape.GetNumberOfLevels(); ++level)
  {
    isDone = this->MergeSlabs(level, mostTexels, compaction);
  }
  if (isDone)
  {
    this->CloseGaps(mostTexels, compaction);
  }
  return compaction;
}

int AtlasAllocator::FindEmptiest(int level) const
{
  const auto& open = this->OpenSlabs[level];
  return std::max_element(open.begin(), open.end(),
    [this](const auto& a, const auto& b)
    { return this->Slabs[a.second].FreeBricks.size() < this->Slabs[b.second].FreeBricks.size(); })
    ->second;
}

// Whether no more than one slab has room left.
bool AtlasAllocator::MergeSlabs(int level, std::int64_t mostTexels, Compaction& compaction)
{
  auto& open = this->OpenSlabs[level];
  const int side = this->Shape.GetSide(level);
  const Index3 size = { side, side, side };
  while (open.size() > 1)
  {
    const int source = this->FindEmptiest(level);
    const std::pair<int, int> key = { this->Slabs[source].FirstLayer, source };
    std::vector<bool> isFree(this->Shape.GetBricksPerSlab(level), false);
    for (const int brick : this->Slabs[source].FreeBricks)
    {
      isFree[brick] = true;
    }
    open.erase(key); // not to be filled
    for (int brick = 0; brick < static_cast<int>(isFree.size()) && !open.empty(); ++brick)
    {
      if (isFree[brick])
      {
        continue;
      }
      if (!Spend(size, mostTexels, compaction))
      {
        open.insert(key);
        return false;
      }
      const BrickPlace from{ source, brick };
      const BrickPlace to = *this->Allocate(level);
      compaction.NewPlaces.emplace_back(from, to);
      compaction.Moves.push_back({ this->GetOrigin(from), this->GetOrigin(to), size });
      this->Slabs[source].FreeBricks.push_back(brick);
    }
    if (this->Slabs[source].FreeBricks.size() == isFree.size())
    {
      this->Slabs[source] = Slab();
    }
    else
    {
      open.insert(key);
    }
  }
  return true;
}

void AtlasAllocator::CloseGaps(std::int64_t mostTexels, Compaction& compaction)
{
  std::vector<int> order;
  for (int slab = 0; slab < this->GetNumberOfSlabs(); ++slab)
  {
    if (this->Slabs[slab].Level >= 0)
    {
      order.push_back(slab);
    }
  }
  std::sort(order.begin(), order.end(),
    [this](int a, int b) { return this->Slabs[a].FirstLayer < this->Slabs[b].FirstLayer; });
  int layer = 0;
  for (const int number : order)
  {
    Slab& slab = this->Slabs[number];
    const int thickness = this->Shape.GetSide(slab.Level);
    if (slab.FirstLayer > layer)
    {
      const Index3 size = { this->Shape.GetWidth(), this->Shape.GetHeight(), thickness };
      if (!Spend(size, mostTexels, compaction))
      {
        return;
      }
      compaction.Moves.push_back({ { 0, 0, slab.FirstLayer }, { 0, 0, layer }, size });
      if (this->OpenSlabs[slab.Level].erase({ slab.FirstLayer, number }) > 0)
      {
        this->OpenSlabs[slab.Level].emplace(layer, number);
      }
      slab.FirstLayer = layer;
    }
    layer += thickness;
  }
}

Index3 AtlasAllocator::GetOrigin(const BrickPlace& place) const
{
  const Slab& slab = this->Slabs[place.Slab];
  const int side = this->Shape.GetSide(slab.Level);
  const int perRow = this->Shape.GetWidth() / side;
  return { place.Brick % perRow * side, place.Brick / perRow * side, slab.FirstLayer };
}

std::vector<BrickPlace> AtlasAllocator::FindPlaces(const Index3& first, const Index3& size) const
{
  std::vector<BrickPlace> places;
  for (int number = 0; number < this->GetNumberOfSlabs(); ++number)
  {
    const Slab& slab = this->Slabs[number];
    if (slab.Level < 0)
    {
      continue;
    }
    const int side = this->Shape.GetSide(slab.Level);
    if (slab.FirstLayer >= first[2] + size[2] || slab.FirstLayer + side <= first[2])
    {
      continue;
    }
    const int columns = this->Shape.GetWidth() / side;
    const int rows = this->Shape.GetHeight() / side;
    const int lastColumn = std::min((first[0] + size[0] - 1) / side, columns - 1);
    const int lastRow = std::min((first[1] + size[1] - 1) / side, rows - 1);
    for (int row = first[1] / side; row <= lastRow; ++row)
    {
      for (int column = first[0] / side; column <= lastColumn; ++column)
      {
        places.push_back({ number, row * columns + column });
      }
    }
  }
  return places;
}

std::int64_t AtlasAllocator::GetUsedTexels() const
{
  std::int64_t texels = 0;
  for (const Slab& slab : this->Slabs)
  {
    if (slab.Level >= 0)
    {
      const std::int64_t side = this->Shape.GetSide(slab.Level);
      const std::int64_t bricks = this->Shape.GetBricksPerSlab(slab.Level) -
                                  static_cast<std::int64_t>(slab.FreeBricks.size());
      texels += bricks * side * side * side;
    }
  }
  return texels;
}

std::int64_t AtlasAllocator::GetFreeTexels(const std::vector<bool>& wanted) const
{
  std::int64_t texels = 0;
  std::int64_t layers = this->Depth;
  for (const Slab& slab : this->Slabs)
  {
    if (slab.Level >= 0)
    {
      const std::int64_t side = this->Shape.GetSide(slab.Level);
      layers -= side;
      texels += wanted[slab.Level]
                  ? static_cast<std::int64_t>(slab.FreeBricks.size()) * side * side * side
                  : 0;
    }
  }
  for (int level = 0; level < this->Shape.GetNumberOfLevels(); ++level)
  {
    if (wanted[level] && this->Shape.GetSide(level) <= layers)
    {
      return texels + layers * this->Shape.GetWidth() * this->Shape.GetHeight();
    }
  }
  return texels;
}

std::int64_t AtlasAllocator::GetTexels() const
{
  const Index3 size = this->GetTextureSize();
  return static_cast<std::int64_t>(size[0]) * size[1] * size[2];
}
} // namespace flatblock
