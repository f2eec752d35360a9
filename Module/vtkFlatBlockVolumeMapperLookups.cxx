#include "vtkFlatBlockVolumeMapperInternals.h"
#include "vtkOpenGLFlatBlockBrickRanges.h"
#include "vtkOpenGLFlatBlockGradientTexture.h"

#include <stdexcept>

// What rays of vtkFlatBlockVolumeMapper look up beside bricks and colours: ranges of bricks, for
// those of few bits, on scales of their own, and for extremes; and what depends on gradients.

vtkTypeInt64 vtkFlatBlockVolumeMapper::vtkInternals::GetBrickRangeBytes() const
{
  const bool hasRanges =
    this->Sampling.HasExtremeRanges() || !this->GetSource().GetRanges().empty();
  return hasRanges ? vtkOpenGLFlatBlockBrickRanges::GetBytes(
                       this->GetSource().GetGrid().GetNumberOfBlocks())
                   : 0;
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateBrickRanges()
{
  this->Sampling.HasBrickRanges = !this->GetSource().GetRanges().empty();
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

vtkTypeInt64 vtkFlatBlockVolumeMapper::vtkInternals::GetGradientTableBytes() const
{
  return this->Sampling.HasGradientTable()
           ? vtkOpenGLFlatBlockGradientTexture::GetBytes(this->GradientFunction->GetTable())
           : 0;
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateGradientTable()
{
  const bool isUsed = this->Sampling.HasGradientTable();
  if (this->RayCaster->HasGradientTable() == isUsed &&
      this->GradientFunction->GetMTime() <= this->GradientTextureTime)
  {
    return;
  }
  flatblock::StageTimer timer(this->Statistics.UploadMilliseconds);
  if (!this->RayCaster->SetGradientTable(
        this->Window, isUsed ? this->GradientFunction->GetTable() : flatblock::GradientTable()))
  {
    throw std::runtime_error("The graphics card has no memory for the function of gradients.");
  }
  this->GradientTextureTime.Modified();
}
