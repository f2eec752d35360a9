#include "vtkFlatBlockLevels.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkFlatBlockLevels);

namespace
{
vtkTypeInt64 GetBytesPerTexel(const flatblock::BrickSource& source)
{
  return static_cast<vtkTypeInt64>(flatblock::BytesPerTexel(source.GetEncoding()));
}

vtkTypeInt64 CountVisible(const std::vector<std::uint8_t>& visible)
{
  return std::count_if(visible.begin(), visible.end(), [](std::uint8_t v) { return v != 0; });
}

// The largest atlas that leaves room for everything else.
flatblock::AtlasShape::Request MakeShapeRequest(
  const flatblock::BrickSource& source, const vtkFlatBlockLevels::Limits& limits)
{
  const flatblock::BlockGrid& grid = source.GetGrid();
  flatblock::AtlasShape::Request request;
  for (int level = 0; level < grid.GetNumberOfLevels(); ++level)
  {
    request.Sides.push_back(grid.GetTexelSide(level));
  }
  const vtkTypeInt64 bytes =
    std::min(limits.MaxMemoryInBytes - limits.BytesBesideAtlas, limits.MaxAtlasBytes);
  request.MostTexels = std::max<vtkTypeInt64>(bytes, 0) / GetBytesPerTexel(source);
  request.FinestBricks = grid.GetNumberOfBlocks(); // so that no edit of opacities changes it
  request.LargestTexture = limits.LargestTexture;
  return request;
}
} // namespace

bool vtkFlatBlockLevels::UpdateShape(const flatblock::BrickSource& source,
  const std::vector<std::uint8_t>& visible, const Limits& limits)
{
  const auto request = MakeShapeRequest(source, limits);
  if (!(request == this->ShapeRequest))
  {
    this->Shape = flatblock::AtlasShape(request);
    this->ShapeRequest = request;
    this->IsNewShape = true;
  }
  return this->Shape.GetDepthOf({ CountVisible(visible) }) > this->Shape.GetDepth();
}

bool vtkFlatBlockLevels::UpdateOrder(const flatblock::BlockGrid& grid, const Blocks& blocks,
  Criterion criterion, const flatblock::VolumeView& view)
{
  const bool areNewRanks = blocks.VisibleTime != this->Ordered.VisibleTime ||
                           !(view.Region == this->View.Region) || this->Ranks.empty();
  if (areNewRanks)
  {
    this->Ranks = flatblock::RankBlocks(grid, *blocks.Visible, view.Region);
  }
  const bool usesDistance = criterion != Criterion::Distortion;
  const bool usesDistortion = criterion != Criterion::Distance;
  const bool isNew =
    areNewRanks || criterion != this->OrderCriterion ||
    (usesDistance &&
      (view.PointOfInterest != this->View.PointOfInterest || view.Spacing != this->View.Spacing)) ||
    (usesDistortion && (blocks.DistortionTime != this->Ordered.DistortionTime ||
                         blocks.Distortion.PerByte != this->Ordered.Distortion.PerByte)) ||
    blocks.WeightsTime != this->Ordered.WeightsTime;
  if (!isNew)
  {
    return false;
  }
  switch (criterion)
  {
  case Criterion::Distance:
    if (!blocks.Distortion.Weights)
    {
      this->Order.SetToDistance(grid, this->Ranks, view.PointOfInterest, view.Spacing);
      break;
    }
    this->Order.SetToDistortionAndDistance(grid, this->Ranks,
      { nullptr, grid.GetNumberOfLevels() - 1, false, blocks.Distortion.Weights },
      view.PointOfInterest, view.Spacing);
    break;
  case Criterion::Distortion:
    this->Order.SetToDistortion(grid, this->Ranks, blocks.Distortion);
    break;
  default:
    this->Order.SetToDistortionAndDistance(
      grid, this->Ranks, blocks.Distortion, view.PointOfInterest, view.Spacing);
  }
  this->View = view;
  this->Ordered = blocks;
  this->OrderCriterion = criterion;
  return true;
}

void vtkFlatBlockLevels::Update(const flatblock::BrickSource& source, const Blocks& blocks,
  Criterion criterion, const flatblock::VolumeView& view, const Limits& limits)
{
  const bool isNewOrder = this->UpdateOrder(source.GetGrid(), blocks, criterion, view);
  if (!this->IsNewShape && !isNewOrder && this->NumberOfLevels == limits.NumberOfLevels)
  {
    return;
  }
  this->IsNewShape = true; // to be tried again, unless all goes well
  if (this->Shape.GetDepth() == 0 ||
      !this->Selector.Select(this->Order, this->Shape, limits.NumberOfLevels))
  {
    throw std::runtime_error(this->DescribeTooLittleMemory(
      limits, CountVisible(*blocks.Visible), GetBytesPerTexel(source)));
  }
  this->IsNewShape = false;
  this->NumberOfLevels = limits.NumberOfLevels;
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
  const std::string limit = limits.MaxAtlasBytes < limits.MaxMemoryInBytes - limits.BytesBesideAtlas
                              ? "The graphics card has " +
                                  std::to_string(limits.BytesBesideAtlas + limits.MaxAtlasBytes) +
                                  " bytes"
                              : "MaxMemoryInBytes is " + std::to_string(limits.MaxMemoryInBytes);
  return limit + ", but " +
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
