#include "vtkFlatBlockVolumeMapperInternals.h"
#include "vtkOpenGLFlatBlockBrickRanges.h"

#include <stdexcept>

// Ranges of bricks in vtkFlatBlockVolumeMapper: for those of few bits, on scales of their own, and
// for extremes.

vtkTypeInt64 vtkFlatBlockVolumeMapper::vtkInternals::GetBrickRangeBytes() const
{
  const bool hasRanges =
    this->Sampling.Blending.IsExtreme() || !this->Builder->GetSource().GetRanges().empty();
  return hasRanges ? vtkOpenGLFlatBlockBrickRanges::GetBytes(
                       this->Builder->GetSource().GetGrid().GetNumberOfBlocks())
                   : 0;
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateBrickRanges()
{
  this->Sampling.HasBrickRanges = !this->Builder->GetSource().GetRanges().empty();
  const bool isUsed = this->Sampling.UsesRanges();
  if (this->AreBrickRangesCurrent && this->RayCaster->HasBrickRanges() == isUsed)
  {
    return;
  }
  flatblock::StageTimer timer(this->Statistics.UploadMilliseconds);
  if (!this->RayCaster->SetBrickRanges(this->Window,
        isUsed ? this->Builder->GetTexelRanges() : std::vector<flatblock::TexelRange>()))
  {
    throw std::runtime_error("The graphics card has no memory for the ranges of the bricks.");
  }
  this->AreBrickRangesCurrent = true;
}
