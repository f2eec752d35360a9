#include "vtkFlatBlockVolumeMapperInternals.h"

#include <algorithm>

// What vtkFlatBlockVolumeMapper tells of its last frame.

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetNumberOfBlocks() const
{
  return static_cast<vtkTypeInt64>(this->Internals->Builder->GetBlockRanges().size());
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetNumberOfVisibleBlocks() const
{
  const auto& visible = this->Internals->VisibleBlocks;
  return std::count_if(visible.begin(), visible.end(), [](std::uint8_t v) { return v != 0; });
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetNumberOfBricks(int level) const
{
  const auto& levels = this->Internals->Residency.GetLevels();
  return std::count(levels.begin(), levels.end(), static_cast<std::int8_t>(level));
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetMemoryInBytes() const
{
  return this->Internals->Memory.GetBytes();
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetPeakMemoryInBytes() const
{
  return this->Internals->Memory.GetPeak();
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetAtlasBytes() const
{
  return this->Internals->Atlas->GetBytes();
}

namespace
{
// Bytes of so many texels of the atlas.
vtkTypeInt64 ToBytes(
  std::int64_t texels, const flatblock::AtlasAllocator& atlas, vtkTypeInt64 atlasBytes)
{
  return atlas.GetTexels() > 0 ? texels * (atlasBytes / atlas.GetTexels()) : 0;
}
} // namespace

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetUsedAtlasBytes() const
{
  const flatblock::AtlasAllocator& atlas = this->Internals->Residency.GetAtlas();
  return ToBytes(atlas.GetUsedTexels(), atlas, this->GetAtlasBytes());
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetFreeAtlasBytes() const
{
  const flatblock::AtlasAllocator& atlas = this->Internals->Residency.GetAtlas();
  std::vector<bool> wanted(atlas.GetShape().GetNumberOfLevels(), false);
  for (int level = 1; level < atlas.GetShape().GetNumberOfLevels(); ++level)
  {
    wanted[level - 1] = this->GetNumberOfBricks(level) > 0;
  }
  return ToBytes(atlas.GetFreeTexels(wanted), atlas, this->GetAtlasBytes());
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetUnusableAtlasBytes() const
{
  return this->GetAtlasBytes() - this->GetUsedAtlasBytes() - this->GetFreeAtlasBytes();
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetUploadedBytes() const
{
  return this->Internals->Statistics.UploadedBytes;
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetMovedBytes() const
{
  return this->Internals->Statistics.MovedBytes;
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetNumberOfPendingChanges() const
{
  return this->Internals->Levels->CountDifferences(this->Internals->Residency.GetLevels());
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetFramesSinceLastChange() const
{
  return this->Internals->Statistics.FramesSinceChange;
}

double vtkFlatBlockVolumeMapper::GetRangeMilliseconds() const
{
  return this->Internals->Statistics.RangeMilliseconds;
}

double vtkFlatBlockVolumeMapper::GetDistortionMilliseconds() const
{
  return this->Internals->Statistics.DistortionMilliseconds;
}

double vtkFlatBlockVolumeMapper::GetSelectionMilliseconds() const
{
  return this->Internals->Statistics.SelectionMilliseconds;
}

double vtkFlatBlockVolumeMapper::GetUploadMilliseconds() const
{
  return this->Internals->Statistics.UploadMilliseconds;
}

double vtkFlatBlockVolumeMapper::GetDrawMilliseconds() const
{
  return this->Internals->Statistics.DrawMilliseconds;
}

void vtkFlatBlockVolumeMapper::PrintStatistics(ostream& os)
{
  os << "Blocks: " << this->GetNumberOfBlocks() << "\n";
  os << "Visible blocks: " << this->GetNumberOfVisibleBlocks() << "\n";
  os << "Bricks by level:";
  for (int level = 0; level < 7; ++level)
  {
    os << " " << this->GetNumberOfBricks(level);
  }
  os << "\nGraphics memory: " << this->GetMemoryInBytes() << " of " << this->MaxMemoryInBytes
     << " bytes\n";
  os << "Atlas: " << this->GetUsedAtlasBytes() << " bytes used, " << this->GetFreeAtlasBytes()
     << " free, " << this->GetUnusableAtlasBytes() << " unusable\n";
  os << "Last frame: " << this->GetUploadedBytes() << " bytes uploaded, " << this->GetMovedBytes()
     << " moved\n";
  os << "Rays: one for " << this->GetUsedImageSampleDistance() << " pixels along both axes, "
     << this->GetNumberOfRaysCutOff() << " cut off\n";
  os << "Changes pending: " << this->GetNumberOfPendingChanges() << "\n";
  os << "Frames since the last change: " << this->GetFramesSinceLastChange() << "\n";
  os << "Milliseconds: ranges " << this->GetRangeMilliseconds() << ", distortion "
     << this->GetDistortionMilliseconds() << ", selection " << this->GetSelectionMilliseconds()
     << ", upload " << this->GetUploadMilliseconds() << ", draw " << this->GetDrawMilliseconds()
     << ", graphics card " << this->GPUMilliseconds << "\n";
  os << "Per ray: " << this->SamplesPerRay << " samples, " << this->FetchesPerRay << " fetches\n";
}
