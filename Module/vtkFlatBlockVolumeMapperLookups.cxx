#include "FlatBlockCurvature.h"
#include "vtkFlatBlockVolumeMapperInternals.h"
#include "vtkOpenGLFlatBlockBrickRanges.h"
#include "vtkOpenGLFlatBlockFunctionTexture.h"

#include <stdexcept>

// What rays of vtkFlatBlockVolumeMapper look up beside bricks and colours: ranges of bricks, for
// those of few bits, on scales of their own, and for extremes; and what depends on gradients
// and on curvature.

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
  if (this->AreBrickRangesCurrent && this->RayCaster->GetLookups().HasBrickRanges() == isUsed)
  {
    return;
  }
  flatblock::StageTimer timer(this->Statistics.UploadMilliseconds);
  if (!this->RayCaster->GetLookups().SetBrickRanges(this->Window,
        isUsed ? this->Builder->GetTexelRanges() : std::vector<flatblock::TexelRange>()))
  {
    throw std::runtime_error("The graphics card has no memory for the ranges of the bricks.");
  }
  this->AreBrickRangesCurrent = true;
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::vtkInternals::GetGradientTableBytes() const
{
  return this->Sampling.HasGradientTable()
           ? vtkOpenGLFlatBlockFunctionTexture::GetBytes(this->GradientFunction->GetTable())
           : 0;
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateGradientTable()
{
  const bool isUsed = this->Sampling.HasGradientTable();
  if (this->RayCaster->GetLookups().HasFunction(flatblock::RayLookups::OF_GRADIENTS) == isUsed &&
      this->GradientFunction->GetMTime() <= this->GradientTextureTime)
  {
    return;
  }
  flatblock::StageTimer timer(this->Statistics.UploadMilliseconds);
  if (!this->RayCaster->GetLookups().SetFunction(this->Window, flatblock::RayLookups::OF_GRADIENTS,
        isUsed ? this->GradientFunction->GetTable() : flatblock::FunctionTable()))
  {
    throw std::runtime_error("The graphics card has no memory for the function of gradients.");
  }
  this->GradientTextureTime.Modified();
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::vtkInternals::GetCurvatureTableBytes() const
{
  return this->Sampling.Curvature != flatblock::CurvatureFunction::None
           ? flatblock::GetCurvatureTableBytes()
           : 0;
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateCurvatureTable(
  vtkFlatBlockCurvatureMapper* mapper)
{
  const bool isUsed = this->Sampling.Curvature != flatblock::CurvatureFunction::None;
  if (this->RayCaster->GetLookups().HasFunction(flatblock::RayLookups::OF_CURVATURE) == isUsed &&
      (!isUsed || mapper->GetMTime() <= this->CurvatureTextureTime))
  {
    return;
  }
  flatblock::StageTimer timer(this->Statistics.UploadMilliseconds);
  if (!this->RayCaster->GetLookups().SetFunction(this->Window, flatblock::RayLookups::OF_CURVATURE,
        isUsed ? flatblock::MakeCurvatureTable(this->Sampling.Curvature,
                   mapper->GetCurvatureColor(), mapper->GetCurvatureOpacity())
               : flatblock::FunctionTable()))
  {
    throw std::runtime_error("The graphics card has no memory for the colours of curvature.");
  }
  this->CurvatureTextureTime.Modified();
}
