// Any order of places given out, taken back and moved: none overlaps another or leaves the texture.
#include "AtlasAllocator.h"
#include "FuzzBytes.h"

#include <iterator>
#include <map>

using namespace flatblock;

namespace
{
struct Box
{
  Index3 First;
  int Side;

  bool Overlaps(const Box& other) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->First[axis] + this->Side <= other.First[axis] ||
          other.First[axis] + other.Side <= this->First[axis])
      {
        return false;
      }
    }
    return true;
  }
};

// It tries many widths, and so is kept.
const AtlasShape& GetShape(const AtlasShape::Request& request)
{
  static std::map<std::vector<std::int64_t>, AtlasShape> shapes;
  std::vector<std::int64_t> key(request.Sides.begin(), request.Sides.end());
  key.push_back(request.MostTexels);
  key.push_back(request.FinestBricks);
  const auto found = shapes.find(key);
  return found != shapes.end() ? found->second
                               : shapes.emplace(key, AtlasShape(request)).first->second;
}

void CheckPlaces(
  const AtlasAllocator& atlas, const BlockGrid& grid, const std::map<BrickPlace, int>& places)
{
  std::vector<Box> boxes;
  const Index3 size = atlas.GetTextureSize();
  for (const auto& [place, level] : places)
  {
    Require(atlas.GetLevel(place) == level);
    const Box box = { atlas.GetOrigin(place), grid.GetTexelSide(level) };
    for (int axis = 0; axis < 3; ++axis)
    {
      Require(box.First[axis] >= 0 && box.First[axis] + box.Side <= size[axis]);
    }
    for (const Box& other : boxes)
    {
      Require(!box.Overlaps(other));
    }
    boxes.push_back(box);
  }
}

void Compact(AtlasAllocator& atlas, std::int64_t texels, std::map<BrickPlace, int>& places)
{
  const Compaction compaction = atlas.Compact(texels);
  for (const auto& [from, to] : compaction.NewPlaces) // in order: a brick may move on
  {
    const auto brick = places.find(from);
    Require(brick != places.end());
    const int level = brick->second;
    places.erase(brick);
    Require(places.emplace(to, level).second);
  }
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
  FuzzBytes numbers(bytes, count);
  const int side = (1 << (1 + numbers.TakeUpTo(3))) + 1;
  const BlockGrid grid(
    { 1 + numbers.TakeUpTo(60), 1 + numbers.TakeUpTo(60), 1 + numbers.TakeUpTo(60) }, side,
    numbers.TakeUpTo(1));
  std::int64_t blocks = 0;
  for (std::int64_t block = 0; block < grid.GetNumberOfBlocks(); ++block)
  {
    Require(grid.GetBlock(grid.GetPosition(block)) == block);
    for (int axis = 0; axis < 3; ++axis)
    {
      Require(grid.GetFirstSample(block)[axis] < grid.GetSamples()[axis]);
    }
    ++blocks;
  }
  Require(blocks == grid.GetNumberOfBlocks());
  std::vector<int> sides;
  for (int level = 0; level < grid.GetNumberOfLevels(); ++level)
  {
    sides.push_back(grid.GetTexelSide(level));
  }
  const AtlasShape& shape =
    GetShape({ sides, 5000 + 15000 * numbers.TakeUpTo(3), 2 + 8 * numbers.TakeUpTo(3), 256 });
  AtlasAllocator atlas(shape, shape.GetDepth());
  std::map<BrickPlace, int> places;
  for (int i = 0; i < 60 && !numbers.IsEmpty(); ++i)
  {
    const int what = numbers.TakeUpTo(7);
    if (what == 0)
    {
      Compact(atlas, 1 + numbers.TakeUpTo(20000), places);
    }
    else if (what < 3 && !places.empty())
    {
      auto place = places.begin();
      std::advance(place, numbers.TakeUpTo(static_cast<int>(places.size()) - 1));
      atlas.Free(place->first);
      places.erase(place);
    }
    else
    {
      const int level = numbers.TakeUpTo(grid.GetNumberOfLevels() - 1);
      if (const auto place = atlas.Allocate(level))
      {
        Require(places.emplace(*place, level).second);
      }
    }
    CheckPlaces(atlas, grid, places);
    Require(atlas.GetUsedTexels() <= atlas.GetTexels());
  }
  return 0;
}
