#include "vtkFlatBlockVolumeMapperInternals.h"
#include "vtkOpenGLFlatBlockBrickRanges.h"

#include <stdexcept>

// Bricks of few bits in vtkFlatBlockVolumeMapper, on scales of their own.

vtkTypeInt64 vtkFlatBlockVolumeMapper::vtkInternals::GetBrickRangeBytes() const
{
  const auto& ranges = this->Builder->GetSource().GetRanges();
  return ranges.empty()
           ? 0
           : vtkOpenGLFlatBlockBrickRanges::GetBytes(static_cast<vtkTypeInt64>(ranges.size()));
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateBrickRanges()
{
  const auto& ranges = this->Builder->GetSource().GetRanges();
  this->Sampling.HasBrickRanges = !ranges.empty();
  if (this->AreBrickRangesCurrent && this->RayCaster->HasBrickRanges() == !ranges.empty())
  {
    return;
  }
  flatblock::StageTimer timer(this->Statistics.UploadMilliseconds);
  if (!this->RayCaster->SetBrickRanges(this->Window, ranges))
  {
    throw std::runtime_error("The graphics card has no memory for the scales of the bricks.");
  }
  this->AreBrickRangesCurrent = true;
}
