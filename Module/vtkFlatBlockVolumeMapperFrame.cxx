#include "Refinement.h"
#include "vtkFlatBlockVolumeMapperInternals.h"
#include "vtkOpenGLFlatBlockSceneDepth.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <stdexcept>
#include <string>

// One frame of vtkFlatBlockVolumeMapper: the stages, in the order in which data flows through them.

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
  in.Statistics = flatblock::FrameStatistics{ 0, 0, in.Statistics.FramesSinceChange + 1 };
  this->UpdateBlocks();
  this->UpdateTransferTable(volume);
  this->UpdateAtlas(renderer, volume);

  flatblock::StageTimer timer(in.Statistics.DrawMilliseconds);
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
  flatblock::StageTimer timer(in.Statistics.RangeMilliseconds);
  if (in.Builder->Update(in.Input.Image, in.Input.Scalars, this->BlockSize))
  {
    in.Residency.Clear();
  }
}

// The table, and the blocks that it shows.
void vtkFlatBlockVolumeMapper::UpdateTransferTable(vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  flatblock::StageTimer timer(in.Statistics.RangeMilliseconds);
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
  flatblock::StageTimer timer(in.Statistics.SelectionMilliseconds);
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
    flatblock::StageTimer timer(in.Statistics.SelectionMilliseconds);
    return in.Residency.Plan(source.GetGrid(), this->GetLevelsOfFrame(renderer),
      in.Levels->GetShape(), this->InterblockContinuity);
  };
  flatblock::FramePlan frame = plan();
  if (!frame.Moves.empty() && !vtkOpenGLFlatBlockAtlas::CanMove())
  {
    in.Residency.Clear();
    frame = plan();
  }
  flatblock::StageTimer timer(in.Statistics.UploadMilliseconds);
  if (!in.Atlas->Execute(in.Window, frame, in.Residency, source))
  {
    const flatblock::Index3 size = in.Residency.GetAtlas().GetTextureSize();
    throw std::runtime_error("The graphics card has no memory for an atlas of " +
                             std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
                             std::to_string(size[2]) + " texels.");
  }
  in.Statistics.UploadedBytes = in.Atlas->GetUploadedBytes();
  in.Statistics.MovedBytes = in.Atlas->GetMovedBytes();
  if (frame.NewPlaces || !frame.Uploads.empty())
  {
    in.Statistics.FramesSinceChange = 0;
  }
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
