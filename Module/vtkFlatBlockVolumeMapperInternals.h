/// What vtkFlatBlockVolumeMapper is made of.
#pragma once

#include "ComponentTable.h"
#include "FlatBlockFormerPicture.h"
#include "FlatBlockSelection.h"
#include "FlatBlockVolumeInput.h"
#include "FlatBlockVolumeView.h"
#include "FramePlan.h"
#include "InterleavedBricks.h"
#include "MemoryCounter.h"
#include "vtkFlatBlockBuilder.h"
#include "vtkFlatBlockDistortion.h"
#include "vtkFlatBlockGradientFunction.h"
#include "vtkFlatBlockLevels.h"
#include "vtkFlatBlockScalars.h"
#include "vtkFlatBlockSkipMap.h"
#include "vtkFlatBlockTransferFunction.h"
#include "vtkFlatBlockVolumeMapper.h"
#include "vtkOpenGLFlatBlockAtlas.h"
#include "vtkOpenGLFlatBlockRayCaster.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace flatblock
{
/// What the last frame did.
struct FrameStatistics
{
  vtkTypeInt64 UploadedBytes = 0;
  vtkTypeInt64 MovedBytes = 0;
  vtkTypeInt64 FramesSinceChange = 0;
  double RangeMilliseconds = 0.0; ///< block ranges and transfer table
  double DistortionMilliseconds = 0.0;
  double SelectionMilliseconds = 0.0; ///< levels, and their places
  double UploadMilliseconds = 0.0;    ///< bricks and tables to the graphics card
  double DrawMilliseconds = 0.0;      ///< commands of the ray caster, not their execution
};

/// What the graphics card turned out to have.
struct CardLimit
{
  vtkTypeInt64 AtlasBytes = VTK_TYPE_INT64_MAX;
  vtkTypeInt64 FoundFor = 0; ///< MaxMemoryInBytes that was too much, 0: none was
};

/// Whether the renderer's window is to be quick: where its desired update rate is 1 or more.
bool IsInteractive(vtkRenderer* renderer);

/// A component of the data, on its way to bricks and colours.
struct Channel
{
  vtkNew<vtkFlatBlockScalars> Scalars;
  vtkNew<vtkFlatBlockBuilder> Builder;
  vtkNew<vtkFlatBlockTransferFunction> TransferFunction;
  double Weight = 1.0; ///< in the picture
};

/// A mask, and the functions of its labels.
struct MaskChannel
{
  struct Label
  {
    int Number = 0;
    vtkNew<vtkVolumeProperty> Property;
    vtkNew<vtkFlatBlockTransferFunction> TransferFunction;
  };

  vtkNew<vtkFlatBlockScalars> Scalars;
  vtkNew<vtkFlatBlockBuilder> Builder;
  std::vector<std::unique_ptr<Label>> Labels;
};

/// For after events, whose observers may have drawn other windows.
inline void MakeCurrent(vtkRenderWindow* window)
{
  if (!window->IsCurrent())
  {
    window->MakeCurrent();
  }
}

/// Sets a flag until it goes out of scope.
class FlagScope
{
public:
  explicit FlagScope(bool& flag) : Flag(flag) { this->Flag = true; }
  ~FlagScope() { this->Flag = false; }
  FlagScope(const FlagScope&) = delete;
  void operator=(const FlagScope&) = delete;

private:
  bool& Flag;
};

/// Adds the time until it goes out of scope.
class StageTimer
{
public:
  explicit StageTimer(double& milliseconds) : Milliseconds(milliseconds) {}
  ~StageTimer()
  {
    const std::chrono::duration<double, std::milli> taken =
      std::chrono::steady_clock::now() - this->Start;
    this->Milliseconds += taken.count();
  }
  StageTimer(const StageTimer&) = delete;
  void operator=(const StageTimer&) = delete;

private:
  double& Milliseconds;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
} // namespace flatblock

// The stages, in the order in which data flows through them.
struct vtkFlatBlockVolumeMapper::vtkInternals
{
  vtkInternals()
  {
    this->Atlas->SetMemoryCounter(&this->Memory);
    this->RayCaster->SetMemoryCounter(&this->Memory);
    this->SetChannels({}, nullptr);
  }

  void DropBricks();
  void KeepFormerPicture(vtkRenderer* renderer);
  void Release(vtkWindow* window);
  void SetChannels(const flatblock::VolumeInput& input, vtkVolumeProperty* property);
  void SetLabels(vtkVolumeProperty* property);
  bool IsPlain() const { return this->Channels.size() == 1 && !this->Mask; }
  void UpdateFunctions();
  void UpdateLabelFunctions();
  void ForgetBlocks();
  bool UpdateBuilders(int blockSize, const vtkFlatBlockBuilder::Bricks& bricks);
  vtkTypeInt64 CountHoles() const;
  vtkMTimeType GetFunctionTime() const;
  const flatblock::BrickSource& GetSource() const;
  flatblock::ComponentTables GetTables() const;
  bool IsBlockVisible(std::size_t block) const;
  bool IsMaskedBlockVisible(std::size_t block) const;
  bool UpdateMask(int blockSize, const vtkFlatBlockBuilder::Bricks& bricks);
  void UpdateVisibleBlocks();

  void UpdateClassified();
  void UpdateTransmittance(const flatblock::VolumeView& view);
  void ChooseCubes(int skipping, vtkTypeInt64 memory);
  void UpdateSkipMap(vtkFlatBlockSkipMap::Settings settings);
  vtkTypeInt64 GetSkipMapBytes() const;
  void AdjustInteractiveFactor(double seconds, double allowed, double largest);
  void UpdateBrickRanges();
  vtkTypeInt64 GetBrickRangeBytes() const;
  void UpdateGradientTable();
  vtkTypeInt64 GetGradientTableBytes() const;
  void UpdateCurvatureTable(vtkFlatBlockCurvatureMapper* mapper);
  vtkTypeInt64 GetCurvatureTableBytes() const;
  flatblock::FramePlan PlanFrame(const flatblock::RefinementBudget* budget, bool continuity);

  flatblock::MemoryCounter Memory;                           // outlives those who count in it
  std::vector<std::unique_ptr<flatblock::Channel>> Channels; // at least one
  std::unique_ptr<flatblock::MaskChannel> Mask;              // of a single channel
  std::unique_ptr<flatblock::InterleavedBricks> Interleaved; // of several channels
  // Of the channel that opacity comes from; of several, the weightiest.
  vtkFlatBlockScalars* Scalars = nullptr;
  vtkFlatBlockBuilder* Builder = nullptr;
  vtkFlatBlockTransferFunction* TransferFunction = nullptr;
  vtkNew<vtkFlatBlockGradientFunction> GradientFunction;
  std::vector<std::uint8_t> VisibleBlocks;
  std::vector<double> VisibleWeights; // of channels, that they are visible with
  vtkNew<vtkFlatBlockDistortion> Distortion;
  std::vector<float> LeastExtinction; // of each block
  std::vector<float> Transmittance;   // with which each block is seen at most
  vtkNew<vtkFlatBlockLevels> Levels;
  flatblock::Residency Residency;
  vtkNew<vtkFlatBlockSkipMap> SkipMap;
  vtkNew<vtkOpenGLFlatBlockAtlas> Atlas;
  vtkNew<vtkOpenGLFlatBlockRayCaster> RayCaster;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // whose context holds the textures
  flatblock::VolumeInput Input;
  flatblock::RaySampling Sampling;      // of this frame,
  flatblock::RaySampling PlainSampling; // and as it is but for selections
  std::optional<flatblock::Selection> Selection;
  double InteractiveFactor = 1.0; // by which interactive frames lengthen their distances
  vtkTimeStamp VisibleBlocksTime;
  vtkTimeStamp TransferTextureTime;
  vtkTimeStamp GradientTextureTime;
  vtkTimeStamp CurvatureTextureTime;
  vtkTimeStamp SkipTextureTime;
  vtkTimeStamp ExtinctionTime;
  vtkTimeStamp TransmittanceTime;
  flatblock::VolumeView TransmittanceView; // only compared with
  flatblock::FrameStatistics Statistics;
  vtkTypeInt64 Frames = 0; // drawn so far
  flatblock::FormerPictures Pictures;
  vtkTypeInt64 LastAtlasBytes = 0;
  flatblock::CardLimit CardLimit;
  std::string LastError;
  std::string LastWarning;
  std::string LastSampleWarning;
  vtkSmartPointer<vtkVolumeProperty> Property; // of the last frame
  int Lead = 0; // the channel whose scalars, builder and function are named above
  bool AreIndependent = false;
  bool HasSecondArray = false; // the last channel has the rows of 2D functions
  bool AreBrickRangesCurrent = false;
  bool IsDrawing = false;
  bool WasInterrupted = false; // the last frame
  bool WasLeftOut = false;     // of a frame that another mapper gave up
  bool HasFailed = false;
  bool IsToRelease = false; // once the frame has ended
  bool WasConverged = true;
  bool IsDistortionCurrent = true; // or not asked for
  bool HasCudaFailed = false;
};
