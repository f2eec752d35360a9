#include "vtkFlatBlockVolumeMapper.h"

#include "vtkFlatBlockVolumeMapperInternals.h"

#include "Interruption.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
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
#include <new>

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

namespace
{
// Asked between the parts of what takes long. vtkRenderWindow::CheckAbortStatus() would let
// observers answer five times a second, which is not often enough.
bool IsToAbort(vtkAlgorithm* mapper, vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  window->InvokeEvent(vtkCommand::AbortCheckEvent, nullptr);
  mapper->UpdateProgress(mapper->GetProgress());
  flatblock::MakeCurrent(window);
  return window->GetAbortRender() != 0 || mapper->GetAbortExecute() != 0;
}
} // namespace

void vtkFlatBlockVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  if (in.IsDrawing)
  {
    return; // called by an observer of a frame in another window, which needs all that is here
  }
  const flatblock::FlagScope drawing(in.IsDrawing);
  in.Statistics.UploadedBytes = 0;
  in.Statistics.MovedBytes = 0;
  in.Memory.ResetPeak();
  in.WasInterrupted = false;
  in.WasLeftOut = renderer->GetRenderWindow()->GetAbortRender() != 0; // as by another volume
  if (in.WasLeftOut)
  {
    in.KeepFormerPicture(renderer);
    return;
  }
  this->TryFrame(renderer, volume);
  if (in.IsToRelease)
  {
    in.Release(in.Window);
  }
  flatblock::MakeCurrent(renderer->GetRenderWindow());
}

void vtkFlatBlockVolumeMapper::TryFrame(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  const flatblock::SelectorGuard guard(renderer->GetSelector());
  this->AbortExecute = 0; // of an earlier frame
  const flatblock::InterruptionScope scope(
    [&] { return IsToAbort(this, renderer) || in.IsToRelease; });
  in.HasFailed = true;
  try
  {
    this->DrawFrame(renderer, volume);
    ++in.Frames;
    in.HasFailed = false;
    in.Pictures.Remember(renderer);
    in.LastError.clear();
    this->ReportProgress();
  }
  catch (const flatblock::Interrupted&)
  {
    in.HasFailed = false;
    in.WasInterrupted = true;
    in.KeepFormerPicture(renderer);
  }
  catch (const std::bad_alloc&)
  {
    in.KeepFormerPicture(renderer);
    this->ReportOnce("There is not enough main memory for this frame; the former picture stays.");
  }
  catch (const std::exception& problem)
  {
    in.DropBricks();
    if (in.Memory.GetBytes() > this->MaxMemoryInBytes)
    {
      in.RayCaster->ReleaseGraphicsResources(in.Window);
    }
    this->ReportOnce(problem.what());
  }
}

// Where there is none, what the window shows from now on is none of it.
void vtkFlatBlockVolumeMapper::vtkInternals::KeepFormerPicture(vtkRenderer* renderer)
{
  const bool hasPicture = this->Pictures.Has(renderer);
  flatblock::ShowFormerPicture(renderer, hasPicture);
  if (!hasPicture && !renderer->GetSelector())
  {
    this->Pictures.Forget(renderer->GetRenderWindow());
  }
}

// What is there may be more than the limit now, or may have come in part.
void vtkFlatBlockVolumeMapper::vtkInternals::DropBricks()
{
  this->Residency.Clear();
  this->Atlas->ReleaseGraphicsResources(this->Window);
}

// Once, not once a frame; and in the next one, where not even this finds memory.
void vtkFlatBlockVolumeMapper::ReportOnce(const char* error)
{
  std::string& last = this->Internals->LastError;
  try
  {
    if (last != error)
    {
      vtkErrorMacro(<< error);
      last = error;
    }
  }
  catch (const std::bad_alloc&)
  {
    last.clear();
  }
}

// As the superclass does, but that observers of the update may take the input away; and a renderer
// leaves out volumes whose bounds are not finite, so that Render() could not say why.
double* vtkFlatBlockVolumeMapper::GetBounds()
{
  if (this->GetDataSetInput())
  {
    this->Update();
  }
  vtkMath::UninitializeBounds(this->Bounds);
  if (vtkDataSet* input = this->GetDataSetInput())
  {
    double bounds[6];
    input->GetBounds(bounds);
    if (std::all_of(bounds, bounds + 6, [](double b) { return std::isfinite(b); }))
    {
      std::copy_n(bounds, 6, this->Bounds);
    }
  }
  return this->Bounds;
}

bool vtkFlatBlockVolumeMapper::GetConverged() const
{
  const vtkInternals& in = *this->Internals;
  const bool isDrawn = in.Frames > 0 && !in.WasInterrupted && !in.WasLeftOut && !in.HasFailed;
  return isDrawn && in.IsDistortionCurrent && in.Residency.GetLevels() == in.Levels->GetLevels();
}

bool vtkFlatBlockVolumeMapper::GetInterrupted() const
{
  return this->Internals->WasInterrupted;
}

bool vtkFlatBlockVolumeMapper::GetFailed() const
{
  return this->Internals->HasFailed;
}

// Once more when it is done, and then no more.
void vtkFlatBlockVolumeMapper::ReportProgress()
{
  vtkInternals& in = *this->Internals;
  const bool isConverged = this->GetConverged();
  if (!isConverged || !in.WasConverged)
  {
    const auto visible = static_cast<double>(this->GetNumberOfVisibleBlocks());
    const auto pending = static_cast<double>(this->GetNumberOfPendingChanges());
    this->UpdateProgress(isConverged ? 1.0 : 1.0 - pending / std::max(visible, 1.0));
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
  } while (in.Frames > drawnBefore && !this->GetConverged() && !in.HasFailed);
  return frames;
}

void vtkFlatBlockVolumeMapper::WarnAboutIgnoredSettings()
{
  std::string ignored;
  const auto check = [&ignored](bool isSet, const char* name)
  {
    if (isSet)
    {
      ignored += (ignored.empty() ? "" : ", ") + std::string(name);
    }
  };
  const flatblock::RaySampling& sampling = this->Internals->Sampling;
  const bool isCurved = this->CurvatureFunction != NO_CURVATURE || this->SilhouetteWidth > 0.0;
  check(this->Internals->Scalars->HasIgnoredBlanks(), "blanked cells of point data");
  check(isCurved && !sampling.IsCurved(),
    sampling.HasManyValues() ? "curvature of several components"
                             : "curvature in blend modes other than composite and isosurface");
  if (!ignored.empty() && ignored != this->Internals->LastWarning)
  {
    vtkWarningMacro(<< "Not supported and ignored: " << ignored << ".");
  }
  this->Internals->LastWarning = ignored;
}

void vtkFlatBlockVolumeMapper::GetColorImage(vtkImageData* image)
{
  this->Internals->RayCaster->GetImages(image, nullptr);
}

void vtkFlatBlockVolumeMapper::GetDepthImage(vtkImageData* image)
{
  this->Internals->RayCaster->GetImages(nullptr, image);
}

// Of the window that it was drawn in: VTK also asks for others' sake, and for none's while one is
// made. Observers of a frame have to wait for its end.
void vtkFlatBlockVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkInternals& in = *this->Internals;
  in.Pictures.Forget(window);
  if (in.Window && window != in.Window)
  {
    return;
  }
  if (in.IsDrawing)
  {
    in.IsToRelease = true;
    return;
  }
  in.Release(window);
}

void vtkFlatBlockVolumeMapper::vtkInternals::Release(vtkWindow* window)
{
  this->Atlas->ReleaseGraphicsResources(window);
  this->RayCaster->ReleaseGraphicsResources(window);
  this->CardLimit = {};
  this->LastAtlasBytes = 0;
  this->IsToRelease = false;
}

void vtkFlatBlockVolumeMapper::ShallowCopy(vtkAbstractMapper* other)
{
  if (auto* mapper = vtkFlatBlockVolumeMapper::SafeDownCast(other))
  {
    this->SetBlockSize(mapper->BlockSize);
    this->SetMaxMemoryInBytes(mapper->MaxMemoryInBytes);
    this->SetNumberOfLevels(mapper->NumberOfLevels);
    this->SetLevelFilter(mapper->LevelFilter);
    this->SetSelectionCriterion(mapper->SelectionCriterion);
    this->SetDistortionPerByte(mapper->DistortionPerByte);
    this->SetVisibilityWeighting(mapper->VisibilityWeighting);
    this->SetDistortionBackend(mapper->DistortionBackend);
    this->SetDistortionEstimate(mapper->DistortionEstimate);
    this->SetNumberOfThreads(mapper->NumberOfThreads);
    this->SetDistortionBlocksPerFrame(mapper->DistortionBlocksPerFrame);
    this->SetPointOfInterest(mapper->PointOfInterest);
    this->SetUseCameraAsPointOfInterest(mapper->UseCameraAsPointOfInterest);
    this->SetRefinementFraction(mapper->RefinementFraction);
    this->SetUploadBytesPerFrame(mapper->UploadBytesPerFrame);
    this->SetProgressiveStills(mapper->ProgressiveStills);
    this->SetInterblockContinuity(mapper->InterblockContinuity);
  }
  this->Superclass::ShallowCopy(other);
}

void vtkFlatBlockVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BlockSize: " << this->BlockSize << "\n";
  os << indent << "MaxMemoryInBytes: " << this->MaxMemoryInBytes << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "PointOfInterest: " << this->PointOfInterest[0] << " " << this->PointOfInterest[1]
     << " " << this->PointOfInterest[2] << "\n";
  os << indent << "UseCameraAsPointOfInterest: " << this->UseCameraAsPointOfInterest << "\n";
  os << indent << "InterblockContinuity: " << this->InterblockContinuity << "\n";
  os << indent << "LevelFilter: " << (this->LevelFilter == TENT ? "Tent" : "Subsample") << "\n";
  const char* const criteria[] = { "Distance", "Distortion", "DistortionAndDistance" };
  os << indent << "SelectionCriterion: " << criteria[this->SelectionCriterion] << "\n";
  const char* const backends[] = { "Auto", "Serial", "OpenMP", "CUDA" };
  os << indent << "DistortionBackend: " << backends[this->DistortionBackend] << "\n";
  os << indent
     << "DistortionEstimate: " << (this->DistortionEstimate == EXACT ? "Exact" : "Summary") << "\n";
  os << indent << "DistortionPerByte: " << this->DistortionPerByte << "\n";
  os << indent << "VisibilityWeighting: " << this->VisibilityWeighting << "\n";
  os << indent << "DistortionBlocksPerFrame: " << this->DistortionBlocksPerFrame << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "RefinementFraction: " << this->RefinementFraction << "\n";
  os << indent << "UploadBytesPerFrame: " << this->UploadBytesPerFrame << "\n";
  os << indent << "ProgressiveStills: " << this->ProgressiveStills << "\n";
  os << indent << "Converged: " << this->GetConverged() << "\n";
  os << indent << "MemoryInBytes: " << this->GetMemoryInBytes() << "\n";
  os << indent << "NumberOfBlocks: " << this->GetNumberOfBlocks() << "\n";
  os << indent << "NumberOfVisibleBlocks: " << this->GetNumberOfVisibleBlocks() << "\n";
  os << indent << "AtlasBytes: " << this->GetAtlasBytes() << "\n";
  os << indent << "UploadedBytes: " << this->GetUploadedBytes() << "\n";
}
