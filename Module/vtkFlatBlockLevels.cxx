#include "vtkFlatBlockLevels.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkFlatBlockLevels);

namespace
{
vtkTypeInt64 GetBytesPerTexel(const flatblock::BrickSource& source)
{
  return static_cast<vtkTypeInt64>(flatblock::BytesPerTexel(source.GetEncoding().Format));
}

// The largest atlas that leaves room for everything else.
flatblock::AtlasShape::Request MakeShapeRequest(
  const flatblock::BrickSource& source, const vtkFlatBlockLevels::Limits& limits)
{
  const flatblock::BlockGrid& grid = source.GetGrid();
  flatblock::AtlasShape::Request request;
  for (int level = 0; level < grid.GetNumberOfLevels(); ++level)
  {
    request.Sides.push_back(grid.GetBrickSide(level));
  }
  const vtkTypeInt64 bytes = limits.MaxMemoryInBytes - limits.BytesBesideAtlas;
  request.MostTexels = std::max<vtkTypeInt64>(bytes, 0) / GetBytesPerTexel(source);
  request.FinestBricks = grid.GetNumberOfBlocks(); // so that no edit of opacities changes it
  request.LargestTexture = limits.LargestTexture;
  return request;
}
} // namespace

bool vtkFlatBlockLevels::UpdateShape(const flatblock::AtlasShape::Request& request)
{
  if (request == this->ShapeRequest)
  {
    return false;
  }
  this->ShapeRequest = request;
  this->Shape = flatblock::AtlasShape(request);
  return true;
}

bool vtkFlatBlockLevels::UpdateOrder(const flatblock::BlockGrid& grid,
  const std::vector<std::uint8_t>& visible, vtkMTimeType visibleTime,
  const flatblock::VolumeView& view)
{
  const bool areNewRanks = visibleTime != this->VisibleTime || !(view.Region == this->View.Region);
  if (areNewRanks)
  {
    this->Ranks = flatblock::RankBlocks(grid, visible, view.Region);
    this->VisibleTime = visibleTime;
  }
  const bool isNewOrder = areNewRanks || view.PointOfInterest != this->View.PointOfInterest ||
                          view.Spacing != this->View.Spacing;
  if (isNewOrder)
  {
    this->Order.SetToDistance(grid, this->Ranks, view.PointOfInterest, view.Spacing);
    this->View = view;
  }
  return isNewOrder;
}

void vtkFlatBlockLevels::Update(const flatblock::BrickSource& source,
  const std::vector<std::uint8_t>& visible, vtkMTimeType visibleTime,
  const flatblock::VolumeView& view, const Limits& limits)
{
  const bool isNewShape = this->UpdateShape(MakeShapeRequest(source, limits));
  const bool isNewOrder = this->UpdateOrder(source.GetGrid(), visible, visibleTime, view);
  if (!isNewShape && !isNewOrder && this->NumberOfLevels == limits.NumberOfLevels)
  {
    return;
  }
  this->NumberOfLevels = limits.NumberOfLevels;
  if (!this->Selector.Select(this->Order, this->Shape, limits.NumberOfLevels))
  {
    this->ShapeRequest = {};
    throw std::runtime_error(this->DescribeTooLittleMemory(limits,
      std::count_if(visible.begin(), visible.end(), [](std::uint8_t v) { return v != 0; }),
      GetBytesPerTexel(source)));
  }
  this->Modified();
}

vtkTypeInt64 vtkFlatBlockLevels::CountDifferences(const std::vector<std::int8_t>& levels) const
{
  const std::vector<std::int8_t>& wanted = this->GetLevels();
  vtkTypeInt64 different = 0;
  for (std::size_t block = 0; block < wanted.size(); ++block)
  {
    const bool isThere = block < levels.size() && levels[block] == wanted[block];
    different += wanted[block] != flatblock::NoLevel && !isThere ? 1 : 0;
  }
  return different;
}

std::string vtkFlatBlockLevels::DescribeTooLittleMemory(
  const Limits& limits, vtkTypeInt64 blocks, vtkTypeInt64 bytesPerTexel) const
{
  std::vector<std::int64_t> coarsest(this->Shape.GetNumberOfLevels(), 0);
  coarsest.back() = blocks;
  const vtkTypeInt64 layer =
    static_cast<vtkTypeInt64>(this->Shape.GetWidth()) * this->Shape.GetHeight() * bytesPerTexel;
  return "MaxMemoryInBytes is " + std::to_string(limits.MaxMemoryInBytes) + ", but " +
         std::to_string(limits.BytesBesideAtlas + layer * this->Shape.GetDepthOf(coarsest)) +
         " bytes are needed for the " + std::to_string(blocks) +
         " visible blocks at their coarsest level.";
}

void vtkFlatBlockLevels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Atlas: " << this->Shape.GetWidth() << " x " << this->Shape.GetHeight() << " x "
     << this->Shape.GetDepth() << "\n";
}
