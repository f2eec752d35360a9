#include "vtkFlatBlockLevels.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkFlatBlockLevels);

namespace
{
vtkTypeInt64 GetBytesPerTexel(const flatblock::BrickSource& source)
{
  return static_cast<vtkTypeInt64>(flatblock::BytesPerTexel(source.GetEncoding().Format));
}

// The largest atlas that leaves room for everything else.
flatblock::AtlasShape::Request MakeShapeRequest(const flatblock::BrickSource& source,
  const std::vector<std::uint8_t>& visible, const vtkFlatBlockLevels::Limits& limits)
{
  const flatblock::BlockGrid& grid = source.GetGrid();
  flatblock::AtlasShape::Request request;
  for (int level = 0; level < grid.GetNumberOfLevels(); ++level)
  {
    request.Sides.push_back(grid.GetBrickSide(level));
  }
  const vtkTypeInt64 bytes = limits.MaxMemoryInBytes - limits.BytesBesideAtlas;
  request.MostTexels = std::max<vtkTypeInt64>(bytes, 0) / GetBytesPerTexel(source);
  request.FinestBricks =
    std::count_if(visible.begin(), visible.end(), [](std::uint8_t v) { return v != 0; });
  request.LargestTexture = limits.LargestTexture;
  return request;
}

flatblock::LodCriteria MakeCriteria(const vtkFlatBlockLevels::Limits& limits)
{
  flatblock::LodCriteria criteria;
  criteria.NumberOfLevels = limits.NumberOfLevels;
  vtkMatrix4x4* matrix = limits.SampleToWorld;
  for (int axis = 0; axis < 3; ++axis)
  {
    criteria.Spacing[axis] = std::hypot(
      matrix->GetElement(0, axis), matrix->GetElement(1, axis), matrix->GetElement(2, axis));
  }
  vtkNew<vtkMatrix4x4> worldToSample;
  vtkMatrix4x4::Invert(matrix, worldToSample);
  const double* point = limits.PointOfInterest;
  const double world[4] = { point[0], point[1], point[2], 1.0 };
  double samples[4];
  worldToSample->MultiplyPoint(world, samples);
  std::copy(samples, samples + 3, criteria.PointOfInterest.begin());

  // A plane is a row: it goes from world to samples by the matrix from samples to world.
  for (int plane = 0; plane < 6; ++plane)
  {
    std::array<double, 4> row = { 0.0, 0.0, 0.0, 0.0 };
    for (int column = 0; column < 4; ++column)
    {
      for (int i = 0; i < 4; ++i)
      {
        row[column] += limits.ViewPlanes[4 * plane + i] * matrix->GetElement(i, column);
      }
    }
    criteria.ViewPlanes.push_back(row);
  }
  return criteria;
}
} // namespace

void vtkFlatBlockLevels::Update(const flatblock::BrickSource& source,
  const std::vector<std::uint8_t>& visible, vtkMTimeType visibleTime, const Limits& limits)
{
  const auto request = MakeShapeRequest(source, visible, limits);
  const auto criteria = MakeCriteria(limits);
  const bool isNewShape = !(request == this->ShapeRequest);
  if (!isNewShape && criteria == this->Criteria && visibleTime == this->VisibleTime)
  {
    return;
  }
  if (isNewShape)
  {
    this->ShapeRequest = request;
    this->Shape = flatblock::AtlasShape(request);
  }
  const auto levels = flatblock::SelectLevels(source.GetGrid(), this->Shape, visible, criteria);
  if (!levels)
  {
    this->ShapeRequest = {};
    throw std::runtime_error(
      this->DescribeTooLittleMemory(limits, request.FinestBricks, GetBytesPerTexel(source)));
  }
  this->Levels = *levels;
  this->Criteria = criteria;
  this->VisibleTime = visibleTime;
  this->Modified();
}

double vtkFlatBlockLevels::GetShareReached(const std::vector<std::int8_t>& levels) const
{
  vtkTypeInt64 visible = 0;
  vtkTypeInt64 there = 0;
  for (std::size_t block = 0; block < this->Levels.size(); ++block)
  {
    if (this->Levels[block] != flatblock::NoLevel)
    {
      ++visible;
      there += levels[block] == this->Levels[block] ? 1 : 0;
    }
  }
  return visible > 0 ? static_cast<double>(there) / static_cast<double>(visible) : 1.0;
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
