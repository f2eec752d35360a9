#include "vtkFlatBlockStatus.h"

#include "vtkFlatBlockPiecesMapper.h"
#include "vtkFlatBlockVolumeMapper.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>

vtkStandardNewMacro(vtkFlatBlockStatus);
vtkFlatBlockStatus::vtkFlatBlockStatus() = default;
vtkFlatBlockStatus::~vtkFlatBlockStatus() = default;

namespace
{
constexpr int MostLevels = 16;
constexpr double Mebibyte = 1048576.0;

struct Sums
{
  double Bytes = 0.0;
  double MostBytes = 0.0;
  double Milliseconds = 0.0;
  double Distortion = 0.0;   ///< the largest mean,
  bool HasDistortion = true; ///< where all know it
  vtkTypeInt64 Visible = 0;
  std::array<vtkTypeInt64, MostLevels> Bricks = {};
};

void Add(vtkFlatBlockVolumeMapper* mapper, Sums& sums)
{
  sums.Bytes += static_cast<double>(mapper->GetMemoryInBytes());
  sums.MostBytes += static_cast<double>(mapper->GetMaxMemoryInBytes());
  sums.Visible += mapper->GetNumberOfVisibleBlocks();
  sums.Milliseconds += std::max(mapper->GetGPUMilliseconds(), 0.0) +
                       mapper->GetRangeMilliseconds() + mapper->GetDistortionMilliseconds() +
                       mapper->GetSelectionMilliseconds() + mapper->GetUploadMilliseconds() +
                       mapper->GetDrawMilliseconds();
  for (int level = 0; level < MostLevels; ++level)
  {
    sums.Bricks[level] += mapper->GetNumberOfBricks(level);
  }
  // By distance it is not computed, and would take long.
  sums.HasDistortion = sums.HasDistortion && mapper->GetDistortionComplete() &&
                       mapper->GetSelectionCriterion() != vtkFlatBlockVolumeMapper::DISTANCE;
  if (sums.HasDistortion)
  {
    sums.Distortion = std::max(sums.Distortion, mapper->GetMeanDistortionOfUnrefinedBlocks());
  }
}
} // namespace

void vtkFlatBlockStatus::SetPieces(vtkFlatBlockPiecesMapper* pieces)
{
  this->Pieces = pieces;
}

int vtkFlatBlockStatus::GetConverged()
{
  if (!this->Pieces)
  {
    return 1;
  }
  const auto& mappers = this->Pieces->GetMappers();
  // What failed does so again, and leaves out what would have been drawn after it.
  const bool hasFailed = std::any_of(mappers.begin(), mappers.end(),
    [](vtkFlatBlockVolumeMapper* mapper) { return mapper->GetFailed(); });
  const bool isDone = std::all_of(mappers.begin(), mappers.end(),
    [](vtkFlatBlockVolumeMapper* mapper)
    {
      return mapper->GetConverged() ||
             (!mapper->GetInterrupted() && mapper->GetNumberOfPendingChanges() == 0);
    });
  return hasFailed || isDone ? 1 : 0;
}

int vtkFlatBlockStatus::GetProgress()
{
  if (this->GetConverged() != 0)
  {
    return 100;
  }
  vtkTypeInt64 visible = 0;
  vtkTypeInt64 pending = 0;
  for (vtkFlatBlockVolumeMapper* mapper : this->Pieces->GetMappers())
  {
    visible += mapper->GetNumberOfVisibleBlocks();
    pending += mapper->GetNumberOfPendingChanges();
  }
  return static_cast<int>(100 * (visible - pending) / std::max<vtkTypeInt64>(visible, 1));
}

const char* vtkFlatBlockStatus::GetText()
{
  Sums sums;
  if (this->Pieces)
  {
    for (vtkFlatBlockVolumeMapper* mapper : this->Pieces->GetMappers())
    {
      Add(mapper, sums);
    }
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "Memory: " << sums.Bytes / Mebibyte << " of "
       << sums.MostBytes / Mebibyte << " MiB\nVisible blocks: " << sums.Visible
       << "\nBlocks at levels:";
  for (int level = 0; level < MostLevels; ++level)
  {
    if (sums.Bricks[level] > 0)
    {
      text << "  " << level << ": " << sums.Bricks[level];
    }
  }
  if (sums.HasDistortion && sums.Visible > 0)
  {
    text << "\nMean distortion: " << std::setprecision(3) << sums.Distortion
         << std::setprecision(1);
  }
  text << "\nLast frame: " << sums.Milliseconds << " ms";
  this->Text = text.str();
  return this->Text.c_str();
}

void vtkFlatBlockStatus::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Converged: " << this->GetConverged() << "\n";
}
