#include "vtkFlatBlockVolumeMapper.h"

#include "FlatBlockVolumeInput.h"
#include "MemoryCounter.h"
#include "Refinement.h"
#include "vtkFlatBlockBuilder.h"
#include "vtkFlatBlockLevels.h"
#include "vtkFlatBlockTransferFunction.h"
#include "vtkOpenGLFlatBlockAtlas.h"
#include "vtkOpenGLFlatBlockRayCaster.h"
#include "vtkOpenGLFlatBlockSceneDepth.h"

#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkFlatBlockVolumeMapper);

// The stages, in the order in which data flows through them.
struct vtkFlatBlockVolumeMapper::vtkInternals
{
  vtkInternals()
  {
    this->Atlas->SetMemoryCounter(&this->Memory);
    this->RayCaster->SetMemoryCounter(&this->Memory);
  }

  flatblock::MemoryCounter Memory; // outlives those who count in it
  vtkNew<vtkFlatBlockBuilder> Builder;
  vtkNew<vtkFlatBlockTransferFunction> TransferFunction;
  std::vector<std::uint8_t> VisibleBlocks;
  vtkNew<vtkFlatBlockLevels> Levels;
  flatblock::Residency Residency;
  vtkNew<vtkOpenGLFlatBlockAtlas> Atlas;
  vtkNew<vtkOpenGLFlatBlockRayCaster> RayCaster;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // whose context holds the textures
  flatblock::VolumeInput Input;
  vtkTimeStamp VisibleBlocksTime;
  vtkTimeStamp TransferTextureTime;
  vtkTypeInt64 UploadedBytes = 0;
  vtkTypeInt64 MovedBytes = 0;
  bool WasConverged = true;
  std::string LastError;
  std::string LastWarning;
};

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
  in.UploadedBytes = 0;
  in.MovedBytes = 0;
  in.Memory.ResetPeak();
  if (renderer->GetSelector())
  {
    return; // a volume's colours are no ids of props or cells
  }
  try
  {
    this->DrawFrame(renderer, volume);
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

void vtkFlatBlockVolumeMapper::DrawFrame(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    throw std::runtime_error("The render window does not use OpenGL.");
  }
  if (in.Window && in.Window != window)
  {
    this->ReleaseGraphicsResources(in.Window);
    window->MakeCurrent();
  }
  in.Window = window;
  if (!volume || !volume->GetProperty())
  {
    throw std::runtime_error("The volume has no vtkVolumeProperty.");
  }
  if (this->BlendMode != COMPOSITE_BLEND)
  {
    throw std::runtime_error("Only composite blending is supported, not blend mode " +
                             std::to_string(this->BlendMode) + ".");
  }
  in.Input = flatblock::GetVolumeInput(*this);
  this->WarnAboutIgnoredSettings(volume);
  this->UpdateBlocks();
  this->UpdateTransferTable(volume);
  this->UpdateAtlas(renderer, volume);

  vtkOpenGLFlatBlockRayCaster::Scene scene;
  scene.Source = &in.Builder->GetSource();
  scene.Atlas = in.Atlas;
  scene.SampleToDataSet = in.Input.SampleToDataSet;
  scene.DataSetToWorld = volume->GetMatrix();
  scene.Step = this->GetStep();
  scene.LinearInterpolation =
    volume->GetProperty()->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
  if (!in.RayCaster->Draw(renderer, scene))
  {
    throw std::runtime_error("The ray caster's shader could not be built.");
  }
}

void vtkFlatBlockVolumeMapper::UpdateBlocks()
{
  vtkInternals& in = *this->Internals;
  if (in.Builder->Update(in.Input.Image, in.Input.Scalars, this->BlockSize))
  {
    in.Residency.Clear();
  }
}

// The table, and the blocks that it shows.
void vtkFlatBlockVolumeMapper::UpdateTransferTable(vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  in.TransferFunction->Update(volume->GetProperty(), in.Builder->GetRange(), this->GetStep());
  const flatblock::TransferTable& table = in.TransferFunction->GetTable();
  if (std::max(in.TransferFunction->GetMTime(), in.Builder->GetMTime()) > in.VisibleBlocksTime)
  {
    const auto& ranges = in.Builder->GetBlockRanges();
    in.VisibleBlocks.resize(ranges.size());
    std::transform(ranges.begin(), ranges.end(), in.VisibleBlocks.begin(),
      [&table](const flatblock::ValueRange& range) -> std::uint8_t
      { return !table.IsTransparent(range.Lowest, range.Highest); });
    in.VisibleBlocksTime.Modified();
  }
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetBytesBesideAtlas(vtkRenderer* renderer) const
{
  const vtkInternals& in = *this->Internals;
  const int* size = renderer->GetSize();
  const auto table =
    in.TransferFunction->GetTable().GetEntries().size() * sizeof(flatblock::TransferTable::Entry);
  return vtkOpenGLFlatBlockAtlas::GetIndexBytes(this->GetNumberOfBlocks()) +
         vtkOpenGLFlatBlockSceneDepth::GetBytes(size[0], size[1]) +
         static_cast<vtkTypeInt64>(table);
}

void vtkFlatBlockVolumeMapper::UpdateLevels(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  vtkNew<vtkMatrix4x4> sampleToWorld;
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), in.Input.SampleToDataSet, sampleToWorld);
  vtkFlatBlockLevels::Limits limits;
  limits.MaxMemoryInBytes = this->MaxMemoryInBytes;
  limits.BytesBesideAtlas = this->GetBytesBesideAtlas(renderer);
  limits.LargestTexture = vtkOpenGLFlatBlockAtlas::GetLargestTexture(in.Window);
  limits.NumberOfLevels = this->NumberOfLevels;
  limits.PointOfInterest = this->UseCameraAsPointOfInterest
                             ? renderer->GetActiveCamera()->GetPosition()
                             : this->PointOfInterest;
  double viewPlanes[24];
  renderer->GetActiveCamera()->GetFrustumPlanes(renderer->GetTiledAspectRatio(), viewPlanes);
  limits.ViewPlanes = viewPlanes;
  limits.SampleToWorld = sampleToWorld;
  in.Levels->Update(
    in.Builder->GetSource(), in.VisibleBlocks, in.VisibleBlocksTime.GetMTime(), limits);
}

// The wanted ones, or what an interactive frame may do towards them.
std::vector<std::int8_t> vtkFlatBlockVolumeMapper::GetLevelsOfFrame(vtkRenderer* renderer)
{
  constexpr double InteractiveUpdateRate = 1.0;
  const vtkInternals& in = *this->Internals;
  const std::vector<std::int8_t>& wanted = in.Levels->GetLevels();
  if (renderer->GetRenderWindow()->GetDesiredUpdateRate() < InteractiveUpdateRate)
  {
    return wanted;
  }
  const flatblock::BrickSource& source = in.Builder->GetSource();
  const auto texel =
    static_cast<vtkTypeInt64>(flatblock::BytesPerTexel(source.GetEncoding().Format));
  flatblock::RefinementBudget budget;
  budget.Blocks = static_cast<vtkTypeInt64>(
    this->RefinementFraction * static_cast<double>(this->GetNumberOfVisibleBlocks()));
  budget.Texels = this->UploadBytesPerFrame / texel;
  return flatblock::StepTowards(
    source.GetGrid(), in.Levels->GetShape(), in.Residency.GetLevels(), wanted, budget);
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
  int frames = 0;
  do
  {
    window->Render();
    ++frames;
  } while (!this->GetConverged() && this->Internals->LastError.empty());
  return frames;
}

void vtkFlatBlockVolumeMapper::UpdateAtlas(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  if (!in.Atlas->IsAllocated())
  {
    in.Residency.Clear();
  }
  const flatblock::TransferTable& table = in.TransferFunction->GetTable();
  in.RayCaster->ReleaseStale(renderer, table);
  this->UpdateLevels(renderer, volume);
  const flatblock::BrickSource& source = in.Builder->GetSource();
  const auto plan = [&]
  {
    return in.Residency.Plan(source.GetGrid(), this->GetLevelsOfFrame(renderer),
      in.Levels->GetShape(), this->InterblockContinuity);
  };
  flatblock::FramePlan frame = plan();
  if (!frame.Moves.empty() && !vtkOpenGLFlatBlockAtlas::CanMove())
  {
    in.Residency.Clear();
    frame = plan();
  }
  if (!in.Atlas->Execute(in.Window, frame, in.Residency, source))
  {
    const flatblock::Index3 size = in.Residency.GetAtlas().GetTextureSize();
    throw std::runtime_error("The graphics card has no memory for an atlas of " +
                             std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
                             std::to_string(size[2]) + " texels.");
  }
  in.UploadedBytes = in.Atlas->GetUploadedBytes();
  in.MovedBytes = in.Atlas->GetMovedBytes();
  if (!in.RayCaster->HasTransferTable() || in.TransferFunction->GetMTime() > in.TransferTextureTime)
  {
    in.RayCaster->SetTransferTable(in.Window, table);
    in.TransferTextureTime.Modified();
  }
}

// A float has 24 bits: with more samples a ray, neighbours could fall together.
double vtkFlatBlockVolumeMapper::GetStep() const
{
  constexpr double MostSamples = 1 << 20;
  const flatblock::VolumeInput& input = this->Internals->Input;
  const double wanted =
    this->SampleDistance > 0.0 ? this->SampleDistance : 0.5 * input.SmallestSpacing;
  return std::max(wanted, input.Diagonal / MostSamples);
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
  return this->Internals->MovedBytes;
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetUploadedBytes() const
{
  return this->Internals->UploadedBytes;
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
