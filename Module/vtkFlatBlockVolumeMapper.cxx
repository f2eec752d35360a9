#include "vtkFlatBlockVolumeMapper.h"

#include "vtkFlatBlockVolumeMapperInternals.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <exception>

vtkStandardNewMacro(vtkFlatBlockVolumeMapper);

vtkFlatBlockVolumeMapper::vtkFlatBlockVolumeMapper() : Internals(std::make_unique<vtkInternals>())
{
}

vtkFlatBlockVolumeMapper::~vtkFlatBlockVolumeMapper() = default;

int vtkFlatBlockVolumeMapper::FillInputPortInformation(int, vtkInformation* info)
{
  // Anything: the pipeline would repeat its error about a wrong type twice a frame.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

void vtkFlatBlockVolumeMapper::SetBlockSize(int samples)
{
  if (samples != 17 && samples != 33 && samples != 65)
  {
    vtkErrorMacro(<< "BlockSize must be 17, 33 or 65 samples, not " << samples << "; it stays "
                  << this->BlockSize << ".");
    return;
  }
  if (this->BlockSize != samples)
  {
    this->BlockSize = samples;
    this->Modified();
  }
}

void vtkFlatBlockVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  in.Statistics.UploadedBytes = 0;
  in.Statistics.MovedBytes = 0;
  in.Memory.ResetPeak();
  if (renderer->GetSelector())
  {
    return; // a volume's colours are no ids of props or cells
  }
  try
  {
    this->DrawFrame(renderer, volume);
    ++in.Frames;
    in.LastError.clear();
    this->ReportProgress();
  }
  catch (const std::exception& problem)
  {
    in.Residency.Clear(); // an upload may have been cut short
    this->ReportOnce(problem.what());
  }
}

// Once, not once a frame.
void vtkFlatBlockVolumeMapper::ReportOnce(const char* error)
{
  std::string& last = this->Internals->LastError;
  if (last != error)
  {
    last = error;
    vtkErrorMacro(<< error);
  }
}

// A renderer leaves out volumes whose bounds are not finite, and Render() could not say why.
double* vtkFlatBlockVolumeMapper::GetBounds()
{
  double* bounds = this->Superclass::GetBounds();
  if (bounds && !std::all_of(bounds, bounds + 6, [](double b) { return std::isfinite(b); }))
  {
    vtkMath::UninitializeBounds(this->Bounds);
  }
  return bounds;
}

bool vtkFlatBlockVolumeMapper::GetConverged() const
{
  const vtkInternals& in = *this->Internals;
  return in.LastError.empty() && in.Residency.GetLevels() == in.Levels->GetLevels();
}

// Once more when it is done, and then no more.
void vtkFlatBlockVolumeMapper::ReportProgress()
{
  vtkInternals& in = *this->Internals;
  const bool isConverged = this->GetConverged();
  if (!isConverged || !in.WasConverged)
  {
    this->UpdateProgress(in.Levels->GetShareReached(in.Residency.GetLevels()));
  }
  in.WasConverged = isConverged;
}

int vtkFlatBlockVolumeMapper::RenderUntilConverged(vtkRenderWindow* window)
{
  const vtkInternals& in = *this->Internals;
  int frames = 0;
  vtkTypeInt64 drawnBefore;
  do
  {
    drawnBefore = in.Frames;
    window->Render();
    ++frames;
  } while (in.Frames > drawnBefore && !this->GetConverged() && in.LastError.empty());
  return frames;
}

void vtkFlatBlockVolumeMapper::WarnAboutIgnoredSettings(vtkVolume* volume)
{
  std::string ignored;
  const auto check = [&ignored](bool isSet, const char* name)
  {
    if (isSet)
    {
      ignored += (ignored.empty() ? "" : ", ") + std::string(name);
    }
  };
  vtkVolumeProperty* property = volume->GetProperty();
  check(property->GetShade() != 0, "shading");
  check(
    property->HasGradientOpacity() && !property->GetDisableGradientOpacity(), "gradient opacity");
  check(property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D, "2D transfer functions");
  check(this->Internals->Input.Image->HasAnyBlankPoints(), "blanked points");
  check(this->Cropping != 0, "cropping");
  check(this->ClippingPlanes && this->ClippingPlanes->GetNumberOfItems() > 0, "clipping planes");
  check(this->GetStep() > this->SampleDistance && this->SampleDistance > 0.0,
    "a sample distance below a millionth of the diagonal");
  if (!ignored.empty() && ignored != this->Internals->LastWarning)
  {
    vtkWarningMacro(<< "Not supported and ignored: " << ignored << ".");
  }
  this->Internals->LastWarning = ignored;
}

void vtkFlatBlockVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Atlas->ReleaseGraphicsResources(window);
  this->Internals->RayCaster->ReleaseGraphicsResources(window);
}

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

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetMovedBytes() const
{
  return this->Internals->Statistics.MovedBytes;
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetUploadedBytes() const
{
  return this->Internals->Statistics.UploadedBytes;
}

void vtkFlatBlockVolumeMapper::PrintStatistics(ostream& os)
{
  const vtkInternals& in = *this->Internals;
  const flatblock::AtlasAllocator& atlas = in.Residency.GetAtlas();
  const vtkTypeInt64 texel = atlas.GetTexels() > 0 ? this->GetAtlasBytes() / atlas.GetTexels() : 0;
  const vtkTypeInt64 used = atlas.GetUsedTexels() * texel;
  const vtkTypeInt64 free = atlas.GetFreeTexels() * texel;
  os << "Blocks: " << this->GetNumberOfBlocks() << "\n";
  os << "Visible blocks: " << this->GetNumberOfVisibleBlocks() << "\n";
  os << "Bricks by level:";
  for (int level = 0; level < 7; ++level)
  {
    os << " " << this->GetNumberOfBricks(level);
  }
  os << "\nGraphics memory: " << this->GetMemoryInBytes() << " of " << this->MaxMemoryInBytes
     << " bytes\n";
  os << "Atlas: " << used << " bytes used, " << free << " free, "
     << this->GetAtlasBytes() - used - free << " unusable\n";
  os << "Last frame: " << in.Statistics.UploadedBytes << " bytes uploaded, "
     << in.Statistics.MovedBytes << " moved\n";
  os << "Levels reached: " << 100.0 * in.Levels->GetShareReached(in.Residency.GetLevels())
     << " %\n";
  os << "Frames since the last change: " << in.Statistics.FramesSinceChange << "\n";
  os << "Milliseconds: ranges " << in.Statistics.RangeMilliseconds << ", selection "
     << in.Statistics.SelectionMilliseconds << ", upload " << in.Statistics.UploadMilliseconds
     << ", draw " << in.Statistics.DrawMilliseconds << "\n";
}

void vtkFlatBlockVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BlockSize: " << this->BlockSize << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "MaxMemoryInBytes: " << this->MaxMemoryInBytes << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "PointOfInterest: " << this->PointOfInterest[0] << " " << this->PointOfInterest[1]
     << " " << this->PointOfInterest[2] << "\n";
  os << indent << "UseCameraAsPointOfInterest: " << this->UseCameraAsPointOfInterest << "\n";
  os << indent << "InterblockContinuity: " << this->InterblockContinuity << "\n";
  os << indent << "RefinementFraction: " << this->RefinementFraction << "\n";
  os << indent << "UploadBytesPerFrame: " << this->UploadBytesPerFrame << "\n";
  os << indent << "Converged: " << this->GetConverged() << "\n";
  os << indent << "MemoryInBytes: " << this->GetMemoryInBytes() << "\n";
  os << indent << "NumberOfBlocks: " << this->GetNumberOfBlocks() << "\n";
  os << indent << "NumberOfVisibleBlocks: " << this->GetNumberOfVisibleBlocks() << "\n";
  os << indent << "AtlasBytes: " << this->GetAtlasBytes() << "\n";
  os << indent << "UploadedBytes: " << this->GetUploadedBytes() << "\n";
}
