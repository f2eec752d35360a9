#include "RoundUp.h"
#include "vtkFlatBlockVolumeMapperInternals.h"
#include "vtkOpenGLFlatBlockSceneDepth.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <exception>
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
    in.Release(in.Window);
    window->MakeCurrent();
  }
  in.Window = window;
  if (!volume || !volume->GetProperty())
  {
    throw std::runtime_error("The volume has no vtkVolumeProperty.");
  }
  in.Property = volume->GetProperty();
  in.Input = flatblock::GetVolumeInput(*this, in.Property);
  in.Selection.reset();
  if (renderer->GetSelector())
  {
    in.Selection = flatblock::GetSelection(renderer, in.Input);
    if (!in.Selection)
    {
      return;
    }
  }
  in.SetChannels(in.Input, in.Property);
  this->AdjustSampling(renderer, volume);
  in.Statistics = flatblock::FrameStatistics{ 0, 0, in.Statistics.FramesSinceChange + 1 };
  this->UpdateBlocks();
  this->WarnAboutIgnoredSettings();
  this->WarnAboutSamples();
  flatblock::MakeCurrent(window);
  this->UpdateTransferTable();
  in.ChooseCubes(this->Skipping, this->MaxMemoryInBytes);
  this->UpdateAtlas(renderer, volume);
  vtkFlatBlockSkipMap::Settings settings;
  settings.IsFiltered = this->LevelFilter == TENT;
  settings.IsSpline = in.Sampling.MayBeSpline;
  const bool isComposite = in.Sampling.Blending.IsComposite();
  settings.LeapsMatter =
    this->HomogeneousLeaps && !in.Sampling.NeedsGradients() && isComposite && in.IsPlain();
  settings.Tolerance =
    isComposite && in.IsPlain() && !in.Sampling.IsCurved() ? this->VariationTolerance : 0.0;
  in.UpdateSkipMap(settings);
  in.UpdateBrickRanges();
  in.UpdateGradientTable();
  in.UpdateCurvatureTable(this);
  flatblock::MakeCurrent(window);
  this->DrawRays(renderer, volume);
}

void vtkFlatBlockVolumeMapper::DrawRays(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  const bool adjusts =
    this->AutoAdjustSampleDistances && flatblock::IsInteractive(renderer) && !in.Selection;
  double milliseconds = 0.0;
  {
    flatblock::StageTimer timer(milliseconds);
    this->CastRays(renderer, volume);
    if (adjusts)
    {
      vtkOpenGLFlatBlockRayCaster::Finish();
    }
  }
  in.Statistics.DrawMilliseconds = milliseconds;
  if (adjusts)
  {
    in.AdjustInteractiveFactor(1e-3 * milliseconds,
      this->FrameTimeGoal > 0.0 ? this->FrameTimeGoal : volume->GetAllocatedRenderTime(),
      this->MaximumImageSampleDistance);
  }
}

void vtkFlatBlockVolumeMapper::CastRays(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  vtkOpenGLFlatBlockRayCaster::Scene scene;
  scene.Source = &in.GetSource();
  scene.Tables = in.GetTables();
  if (in.Mask)
  {
    scene.Mask = { in.Mask->Builder->GetSource().GetEncoding().Offset, this->MaskBlendFactor };
  }
  scene.Atlas = in.Atlas;
  scene.SampleToDataSet = in.Input.SampleToDataSet;
  scene.DataSetToWorld = volume->GetMatrix();
  scene.Material = in.Property;
  scene.LinearInterpolation =
    volume->GetProperty()->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
  scene.HasHoles = in.CountHoles() > 0;
  scene.Sampling = in.Sampling;
  scene.Selection = in.Selection;
  scene.Clipping = flatblock::GetClipping(volume, this, in.Input);
  vtkOpenGLRenderTimer timer;
  this->GPUMilliseconds = -1.0;
  const bool isTimed = this->Profiling && vtkOpenGLRenderTimer::IsSupported();
  if (isTimed)
  {
    timer.Start();
  }
  if (!in.RayCaster->Draw(renderer, scene))
  {
    throw std::runtime_error("The ray caster's shader could not be built.");
  }
  if (isTimed)
  {
    timer.Stop();
    vtkOpenGLFlatBlockRayCaster::Finish();
    this->GPUMilliseconds = timer.GetElapsedMilliseconds();
    timer.ReleaseGraphicsResources();
  }
  const flatblock::RayCounts& counts = in.RayCaster->GetCounts();
  const bool isCounted = in.Sampling.HasCounts() && counts.Rays > 0;
  this->SamplesPerRay = isCounted ? counts.Samples / static_cast<double>(counts.Rays) : 0.0;
  this->FetchesPerRay = isCounted ? counts.Fetches / static_cast<double>(counts.Rays) : 0.0;
}

void vtkFlatBlockVolumeMapper::UpdateBlocks()
{
  vtkInternals& in = *this->Internals;
  flatblock::StageTimer timer(in.Statistics.RangeMilliseconds);
  vtkFlatBlockBuilder::Bricks bricks;
  bricks.Filter =
    this->LevelFilter == TENT ? flatblock::LevelFilter::Tent : flatblock::LevelFilter::Subsample;
  bricks.Bits = in.IsPlain() ? this->AtlasPrecision : NATIVE;
  bricks.Apron = in.Sampling.GetApron();
  bricks.MayBeSpline = in.Sampling.MayBeSpline;
  bricks.MayInterpolate =
    bricks.MayBeSpline && this->InterpolatingBSpline && in.IsPlain() && !in.Sampling.ReadsSamples();
  bricks.AreCoefficients =
    bricks.MayInterpolate && in.Sampling.Filter == flatblock::ReconstructionFilter::CubicBSpline;
  bool areNew = false;
  try
  {
    areNew = in.UpdateBuilders(this->BlockSize, bricks);
  }
  catch (const std::exception&)
  {
    in.ForgetBlocks(); // some of which may be others than before
    throw;
  }
  if (areNew)
  {
    in.Residency.Clear();
    in.LastAtlasBytes = 0;
    in.CardLimit = {};
    in.AreBrickRangesCurrent = false;
    in.RayCaster->GetLookups().SetBrickRanges(
      in.Window, {}); // before their place is given to others
  }
}

// The table, and the blocks that it shows.
void vtkFlatBlockVolumeMapper::UpdateTransferTable()
{
  vtkInternals& in = *this->Internals;
  flatblock::StageTimer timer(in.Statistics.RangeMilliseconds);
  in.UpdateFunctions();
  in.UpdateVisibleBlocks();
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetBytesBesideAtlas(vtkRenderer* renderer) const
{
  const vtkInternals& in = *this->Internals;
  const int* size = renderer->GetSize();
  // Rounded up, so that not each step of a window that is being resized changes the atlas.
  return vtkOpenGLFlatBlockAtlas::GetIndexBytes(this->GetNumberOfBlocks()) +
         flatblock::RoundUp(vtkOpenGLFlatBlockSceneDepth::GetBytes(size[0], size[1])) +
         flatblock::RayLookups::GetTableBytes(in.GetTables(), in.Sampling) + in.GetSkipMapBytes() +
         in.GetBrickRangeBytes() + in.GetGradientTableBytes() + in.GetCurvatureTableBytes() +
         this->GetImageBytes(renderer);
}

// Towards the levels that are wanted.
bool vtkFlatBlockVolumeMapper::IsStepwise(vtkRenderer* renderer) const
{
  return this->ProgressiveStills || flatblock::IsInteractive(renderer);
}

void vtkFlatBlockVolumeMapper::UpdateLevels(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  vtkFlatBlockLevels::Limits limits;
  limits.MaxMemoryInBytes = this->MaxMemoryInBytes;
  limits.MaxAtlasBytes = in.CardLimit.AtlasBytes;
  limits.BytesBesideAtlas = this->GetBytesBesideAtlas(renderer);
  limits.LargestTexture = vtkOpenGLFlatBlockAtlas::GetLargestTexture(in.Window);
  limits.NumberOfLevels = this->NumberOfLevels;
  const flatblock::BrickSource& source = in.GetSource();
  const bool isLimited = in.Levels->UpdateShape(source, in.VisibleBlocks, limits);
  auto criterion = vtkFlatBlockLevels::Criterion::Distance;
  in.IsDistortionCurrent = !isLimited || this->SelectionCriterion == DISTANCE;
  if (isLimited && this->SelectionCriterion != DISTANCE)
  {
    criterion = this->SelectionCriterion == DISTORTION
                  ? vtkFlatBlockLevels::Criterion::Distortion
                  : vtkFlatBlockLevels::Criterion::DistortionAndDistance;
    this->UpdateDistortion(
      this->IsStepwise(renderer) ? this->DistortionBlocksPerFrame : VTK_TYPE_INT64_MAX);
    in.IsDistortionCurrent = in.Distortion->IsComplete();
  }
  const double* point = this->UseCameraAsPointOfInterest
                          ? renderer->GetActiveCamera()->GetPosition()
                          : this->PointOfInterest;
  const flatblock::VolumeView view =
    flatblock::GetVolumeView(renderer, volume, this, in.Input, point);
  const bool isWeighted = isLimited && this->VisibilityWeighting && view.HasPlainCamera &&
                          in.Sampling.Blending.IsComposite() && !in.Sampling.HasGradientTable() &&
                          !in.Sampling.HasCurvatureOpacity && in.IsPlain();
  if (isWeighted)
  {
    in.UpdateClassified();
  }
  flatblock::StageTimer timer(in.Statistics.SelectionMilliseconds);
  if (isWeighted)
  {
    in.UpdateTransmittance(view);
  }
  vtkFlatBlockLevels::Blocks blocks = { &in.VisibleBlocks, in.VisibleBlocksTime.GetMTime(),
    in.Distortion->Get(this->DistortionPerByte), in.Distortion->GetMTime(),
    isWeighted ? in.TransmittanceTime.GetMTime() : 0 };
  blocks.Distortion.Weights = isWeighted ? in.Transmittance.data() : nullptr;
  in.Levels->Update(source, blocks, criterion, view, limits);
}

// A still, or what an interactive frame may do towards it.
flatblock::FramePlan vtkFlatBlockVolumeMapper::vtkInternals::PlanFrame(
  const flatblock::RefinementBudget* budget, bool continuity)
{
  flatblock::StageTimer timer(this->Statistics.SelectionMilliseconds);
  const flatblock::BrickSource& source = this->GetSource();
  const auto borders = continuity ? source.GetContinuity() : flatblock::Continuity::Off;
  const auto plan = [&]
  {
    return budget ? this->Residency.PlanStep(source.GetGrid(), this->Levels->GetLevels(),
                      this->Levels->GetOrder(), this->Levels->GetShape(), borders, *budget)
                  : this->Residency.PlanStill(source.GetGrid(), this->Levels->GetLevels(),
                      this->Levels->GetShape(), borders);
  };
  flatblock::FramePlan frame = plan();
  if (!frame.Moves.empty() && !vtkOpenGLFlatBlockAtlas::CanMove())
  {
    // All bricks anew, and in one frame, or the next ones would come to the same point again.
    this->Residency.Clear();
    frame = this->Residency.PlanStill(
      source.GetGrid(), this->Levels->GetLevels(), this->Levels->GetShape(), borders);
  }
  return frame;
}

void vtkFlatBlockVolumeMapper::UpdateAtlas(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  if (!in.Atlas->IsAllocated())
  {
    in.Residency.Clear();
  }
  if (in.CardLimit.FoundFor != this->MaxMemoryInBytes)
  {
    in.CardLimit = {};
  }
  const flatblock::ComponentTables tables = in.GetTables();
  in.RayCaster->ReleaseStale(renderer, tables,
    { in.GetSkipMapBytes(), in.GetGradientTableBytes(), in.GetCurvatureTableBytes(),
      in.GetBrickRangeBytes() },
    in.PlainSampling);
  while (!this->TryAtlas(renderer, volume))
  {
    this->ShrinkAtlas();
  }
  if (!in.RayCaster->GetLookups().HasTransferTable(in.Sampling) ||
      in.GetFunctionTime() > in.TransferTextureTime)
  {
    flatblock::StageTimer timer(in.Statistics.UploadMilliseconds);
    if (!in.RayCaster->GetLookups().SetTransferTable(in.Window, tables, in.Sampling))
    {
      throw std::runtime_error(
        "The graphics card has no room for the functions of so many labels.");
    }
    in.TransferTextureTime.Modified();
  }
}

// False where the graphics card has no memory for it.
bool vtkFlatBlockVolumeMapper::TryAtlas(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  this->UpdateLevels(renderer, volume);
  const flatblock::BrickSource& source = in.GetSource();
  flatblock::RefinementBudget budget;
  budget.Blocks = static_cast<vtkTypeInt64>(
    this->RefinementFraction * static_cast<double>(this->GetNumberOfBlocks()));
  budget.Texels =
    this->UploadBytesPerFrame / static_cast<vtkTypeInt64>(BytesPerTexel(source.GetEncoding()));
  try
  {
    const flatblock::FramePlan frame = in.PlanFrame(this->IsStepwise(renderer) ? &budget : nullptr,
      this->InterblockContinuity && in.Sampling.MayCoarsenBorders());
    in.Statistics.FramesSinceChange = frame.IsEmpty() ? in.Statistics.FramesSinceChange : 0;
    flatblock::StageTimer timer(in.Statistics.UploadMilliseconds);
    if (!in.Atlas->Execute(in.Window, frame, in.Residency, source))
    {
      return false;
    }
  }
  catch (const std::exception&)
  {
    in.DropBricks(); // which are not what was planned
    throw;
  }
  in.Statistics.UploadedBytes = in.Atlas->GetUploadedBytes();
  in.Statistics.MovedBytes = in.Atlas->GetMovedBytes();
  in.LastAtlasBytes = in.Atlas->GetBytes();
  return true;
}

// To what was there before, or else to less and less.
void vtkFlatBlockVolumeMapper::ShrinkAtlas()
{
  constexpr vtkTypeInt64 TooSmall = 4096;
  vtkInternals& in = *this->Internals;
  const flatblock::AtlasAllocator& atlas = in.Residency.GetAtlas();
  const flatblock::Index3 size = atlas.GetTextureSize();
  const vtkTypeInt64 bytes =
    atlas.GetTexels() * static_cast<vtkTypeInt64>(BytesPerTexel(in.GetSource().GetEncoding()));
  const bool isLastWorthwhile = in.LastAtlasBytes < bytes && in.LastAtlasBytes >= bytes / 16;
  const vtkTypeInt64 smaller = isLastWorthwhile ? in.LastAtlasBytes : bytes / 4 * 3;
  const std::string problem = "The graphics card has no memory for an atlas of " +
                              std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
                              std::to_string(size[2]) + " texels, " + std::to_string(bytes) +
                              " bytes";
  if (smaller < TooSmall)
  {
    throw std::runtime_error(problem + ".");
  }
  if (in.CardLimit.FoundFor != this->MaxMemoryInBytes)
  {
    vtkErrorMacro(<< problem << "; a smaller one takes its place until MaxMemoryInBytes is set.");
  }
  in.CardLimit = { smaller, this->MaxMemoryInBytes };
  in.Residency.Clear();
}
