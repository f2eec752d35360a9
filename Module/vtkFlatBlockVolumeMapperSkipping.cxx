#include "vtkFlatBlockVolumeMapperInternals.h"

#include <algorithm>
#include <stdexcept>

// What rays of vtkFlatBlockVolumeMapper leap over.

vtkTypeInt64 vtkFlatBlockVolumeMapper::vtkInternals::GetSkipMapBytes() const
{
  return this->Sampling.CellsPerCube > 0
           ? vtkFlatBlockSkipMap::GetBytes(this->GetSource().GetGrid(), this->Sampling.CellsPerCube)
           : 0;
}

void vtkFlatBlockVolumeMapper::vtkInternals::ChooseCubes(int skipping, vtkTypeInt64 memory)
{
  constexpr int FewestCells = 4;
  constexpr vtkTypeInt64 ShareOfMemory = 64;
  const flatblock::BlockGrid& grid = this->GetSource().GetGrid();
  const int fewest =
    skipping == vtkFlatBlockVolumeMapper::SKIP_CELLS ? FewestCells : grid.GetCellsPerBlock();
  this->Sampling.CellsPerCube =
    skipping == vtkFlatBlockVolumeMapper::SKIP_NOTHING
      ? 0
      : vtkFlatBlockSkipMap::ChooseCells(grid, fewest, memory / ShareOfMemory,
          vtkOpenGLFlatBlockAtlas::GetLargestTexture(this->Window));
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateSkipMap(vtkFlatBlockSkipMap::Settings settings)
{
  if (this->Sampling.CellsPerCube == 0)
  {
    return;
  }
  {
    flatblock::StageTimer timer(this->Statistics.RangeMilliseconds);
    const auto& levels = this->Residency.GetLevels();
    const int coarsest = levels.empty() ? 0 : *std::max_element(levels.begin(), levels.end());
    settings.Cells = this->Sampling.CellsPerCube;
    settings.Coarsest = std::max(coarsest, 0);
    std::vector<vtkFlatBlockSkipMap::Part> parts;
    for (const auto& channel : this->Channels)
    {
      if (this->Sampling.AreIndependent ? channel->Weight > 0.0 : channel->Builder == this->Builder)
      {
        parts.push_back({ channel->Builder, channel->TransferFunction });
      }
    }
    for (std::size_t i = 0; this->Mask && i < this->Mask->Labels.size(); ++i)
    {
      parts.push_back({ this->Builder, this->Mask->Labels[i]->TransferFunction });
    }
    if (parts.empty()) // none has any weight
    {
      parts.push_back({ this->Builder, this->TransferFunction });
    }
    this->SkipMap->Update(parts, this->VisibleBlocks, this->VisibleBlocksTime.GetMTime(), settings);
  }
  if (!this->RayCaster->GetLookups().HasSkipMap() ||
      this->SkipMap->GetMTime() > this->SkipTextureTime)
  {
    flatblock::StageTimer timer(this->Statistics.UploadMilliseconds);
    if (!this->RayCaster->GetLookups().SetSkipMap(
          this->Window, this->SkipMap->Get(), this->Sampling))
    {
      this->Sampling.CellsPerCube = 0;
      return;
    }
    this->SkipTextureTime.Modified();
  }
}
