/**
 * @class   vtkFlatBlockVolumeMapper
 * @brief   draws a volume from flat blocks in one ray-casting pass
 *
 * The volume is cut into flat blocks: cubes of 2^n cells whose neighbours share their border
 * samples. Blocks in which the transfer function is transparent are neither uploaded nor sampled;
 * the bricks of all others lie packed in one 3D texture, the atlas. One box is drawn, and each ray
 * walks from block to block, leaping over what looks all the same.
 *
 * Within MaxMemoryInBytes each block has its own level of detail: level l is made of one sample in
 * 2^l along each axis. Blocks near the point of interest are refined first, those out of view last.
 * A still picture depends on what is set, to the last bit, and not on what was drawn before.
 *
 * Hardware selection (vtkHardwareSelector) gives the prop, and the cell or the point where a ray
 * has gathered an opacity of 3/255. What cannot be drawn gives one error, and nothing is drawn
 * until it is set right. A frame that the window's abort check or SetAbortExecute() stops, or for
 * which main memory is short, is given up: the window keeps its picture, and the next one goes on.
 *
 * @sa vtkGPUVolumeRayCastMapper vtkVolumeProperty
 */

#ifndef vtkFlatBlockVolumeMapper_h
#define vtkFlatBlockVolumeMapper_h

#include "vtkFlatBlockRayCastMapper.h"

#include <memory> // for the internals

class vtkRenderWindow;

class VTKFLATBLOCKVOLUMERENDERING_EXPORT vtkFlatBlockVolumeMapper : public vtkFlatBlockRayCastMapper
{
public:
  static vtkFlatBlockVolumeMapper* New();
  vtkTypeMacro(vtkFlatBlockVolumeMapper, vtkFlatBlockRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  void ShallowCopy(vtkAbstractMapper* other) override;

  ///@{
  /**
   * Samples along a block's side: 17, 33 (default) or 65. Anything else is refused with an error
   * and changes nothing. Small blocks follow the visible structures closely, large ones spend less
   * on shared borders.
   */
  void SetBlockSize(int samples);
  vtkGetMacro(BlockSize, int);
  ///@}

  ///@{
  /**
   * Bytes on the graphics card that are never exceeded, by atlas, index texture, tables, image of
   * rays and the copy of the scene's depth together. Default: 256 MiB. Where the visible blocks
   * don't fit at their finest level, those far from the point of interest are drawn coarser. Where
   * the card has less memory than this, an error says so, and a smaller atlas is drawn until this
   * is set anew.
   */
  vtkSetClampMacro(MaxMemoryInBytes, vtkTypeInt64, 1, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MaxMemoryInBytes, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * Levels of detail that a block may have: 1 (finest only) to 7. Default: 4. Coarser levels than
   * these are added where not even the coarsest of them fits MaxMemoryInBytes.
   */
  vtkSetClampMacro(NumberOfLevels, int, 1, 7);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  enum LevelFilters
  {
    SUBSAMPLE,
    TENT
  };

  ///@{
  /**
   * What the samples of a coarser level are. Subsample (default): finest samples at a stride, so
   * that all values are those of the data, and their colours too. Tent: the mean of the samples
   * around, weighted by a tent that falls to 0 at a distance of 2^l along each axis; smoother, and
   * slower to upload. Where only a mean lies in the visible range of a block, and none of its
   * samples does, it is not drawn.
   */
  vtkSetClampMacro(LevelFilter, int, SUBSAMPLE, TENT);
  vtkGetMacro(LevelFilter, int);
  void SetLevelFilterToSubsample() { this->SetLevelFilter(SUBSAMPLE); }
  void SetLevelFilterToTent() { this->SetLevelFilter(TENT); }
  ///@}

  enum SelectionCriteria
  {
    DISTANCE,
    DISTORTION,
    DISTORTION_AND_DISTANCE
  };

  ///@{
  /**
   * Which block is refined first. Distance (default): the one for which 1 / (d + diagonal) is the
   * largest, with d the distance from the point of interest to the block's centre, and the diagonal
   * that of the block counted in voxels of its present level, both in world units of the finest
   * voxel. Distortion: the one that looks most wrong at its present level,
   * e(b, l) = sqrt(1/n sum |T(v) - T(v_l)|^2) over its n samples v, with v_l the interpolant of its
   * samples at a stride of 2^l, and T the CIELUV colour over black, and opacity, that the transfer
   * function gives to a value. Both: the one with the largest e / (d + diagonal). Blocks that are
   * wholly out of view, or beyond a clipping plane or the cropping, come after all others.
   */
  vtkSetClampMacro(SelectionCriterion, int, DISTANCE, DISTORTION_AND_DISTANCE);
  vtkGetMacro(SelectionCriterion, int);
  void SetSelectionCriterionToDistance() { this->SetSelectionCriterion(DISTANCE); }
  void SetSelectionCriterionToDistortion() { this->SetSelectionCriterion(DISTORTION); }
  void SetSelectionCriterionToDistortionAndDistance()
  {
    this->SetSelectionCriterion(DISTORTION_AND_DISTANCE);
  }
  ///@}

  ///@{
  /**
   * Whether errors count for each byte of the brick that would replace the present one. Default:
   * on.
   */
  vtkSetMacro(DistortionPerByte, bool);
  vtkGetMacro(DistortionPerByte, bool);
  vtkBooleanMacro(DistortionPerByte, bool);
  ///@}

  ///@{
  /**
   * Whether blocks count by the largest transmittance with which a ray from the camera may reach
   * them: so what hides behind opaque matter leaves the memory to what is seen. A block that is
   * seen at all is never taken for hidden, so that only matter that fills whole blocks hides
   * others; the opacity is that of the values in a block, for integers of 8 and 16 bit at the
   * integers. Does nothing in stereo, with sheared or off-axis cameras, nor where gradients or
   * curvature change the opacity. Default: off.
   */
  vtkSetMacro(VisibilityWeighting, bool);
  vtkGetMacro(VisibilityWeighting, bool);
  vtkBooleanMacro(VisibilityWeighting, bool);
  ///@}

  enum DistortionBackends
  {
    AUTO,
    SERIAL,
    OPENMP,
    CUDA
  };

  ///@{
  /**
   * What computes distortions: CUDA where a device answers, else OpenMP (Auto, default), or one of
   * them. They agree to 1e-6 of a value; Serial and OpenMP to the last bit. Where CUDA is chosen
   * and there is none, or it fails, a warning says so and OpenMP takes its place.
   */
  vtkSetClampMacro(DistortionBackend, int, AUTO, CUDA);
  vtkGetMacro(DistortionBackend, int);
  void SetDistortionBackendToAuto() { this->SetDistortionBackend(AUTO); }
  void SetDistortionBackendToSerial() { this->SetDistortionBackend(SERIAL); }
  void SetDistortionBackendToOpenMP() { this->SetDistortionBackend(OPENMP); }
  void SetDistortionBackendToCUDA() { this->SetDistortionBackend(CUDA); }
  ///@}

  enum DistortionEstimates
  {
    EXACT,
    SUMMARY
  };

  ///@{
  /**
   * What follows an edit of the transfer function. Exact (default): blocks whose values it touches
   * are computed again. Summary: each block is looked at once; how often a value in one of 16 bins
   * stands for one in another tells e(b, l) for any function within milliseconds, off by no more
   * than colours vary within a bin. It takes main memory: 0.5 % of a CT in blocks of 33, up to 20 %
   * of noise of 16 bit in blocks of 17.
   */
  vtkSetClampMacro(DistortionEstimate, int, EXACT, SUMMARY);
  vtkGetMacro(DistortionEstimate, int);
  void SetDistortionEstimateToExact() { this->SetDistortionEstimate(EXACT); }
  void SetDistortionEstimateToSummary() { this->SetDistortionEstimate(SUMMARY); }
  vtkTypeInt64 GetDistortionSummaryBytes() const;
  ///@}

  ///@{
  /**
   * Threads of the OpenMP backend; 0 (default): as many as OpenMP finds.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Blocks whose distortion an interactive frame computes, those first that could be most wrong;
   * all others have their last value, or a guess. Default: 512. All other frames compute what is
   * missing.
   */
  vtkSetClampMacro(DistortionBlocksPerFrame, int, 1, VTK_INT_MAX);
  vtkGetMacro(DistortionBlocksPerFrame, int);
  ///@}

  ///@{
  /**
   * Whether no visible block waits for its distortion: so also where it is not asked for. Sum of
   * e(b, l) over all visible blocks at the levels of the last frame, and its mean over those that
   * are not at their finest level: computes what is missing, whatever the criterion; 0 before the
   * first frame.
   */
  bool GetDistortionComplete() const;
  double GetTotalDistortion();
  double GetMeanDistortionOfUnrefinedBlocks();
  ///@}

  ///@{
  /**
   * Where detail matters most, in world coordinates; and whether that is the camera (default on)
   * whatever is set.
   */
  vtkSetVector3Macro(PointOfInterest, double);
  vtkGetVector3Macro(PointOfInterest, double);
  vtkSetMacro(UseCameraAsPointOfInterest, bool);
  vtkGetMacro(UseCameraAsPointOfInterest, bool);
  vtkBooleanMacro(UseCameraAsPointOfInterest, bool);
  ///@}

  ///@{
  /**
   * What an interactive frame may do to reach the levels that are wanted: the share of all blocks
   * that change (default 0.1), and bytes of bricks and borders that are uploaded, or else moved
   * within the atlas (default 16 MiB). One block may change in any case, and blocks that were
   * transparent come at once, coarse. A frame is interactive where the render window's desired
   * update rate is 1 or more, as with vtkSmartVolumeMapper; all others are converged before they
   * are shown, but with ProgressiveStills (default off), for programs that stay responsive and
   * render again until GetConverged(); bricks then lie elsewhere, and last bits may differ.
   */
  vtkSetClampMacro(RefinementFraction, double, 0.0, 1.0);
  vtkGetMacro(RefinementFraction, double);
  vtkSetClampMacro(UploadBytesPerFrame, vtkTypeInt64, 1, VTK_TYPE_INT64_MAX);
  vtkGetMacro(UploadBytesPerFrame, vtkTypeInt64);
  vtkSetMacro(ProgressiveStills, bool);
  vtkGetMacro(ProgressiveStills, bool);
  vtkBooleanMacro(ProgressiveStills, bool);
  ///@}

  ///@{
  /**
   * Whether the last frame showed every block at the level that is wanted; false before the first.
   * Frames that don't send a ProgressEvent with the share of the visible blocks that do. Whether it
   * was given up by a wish, or ended in an error; the next one goes on.
   */
  bool GetConverged() const;
  bool GetInterrupted() const;
  bool GetFailed() const;
  ///@}

  /**
   * Renders the window until this mapper, which draws in it, has converged; stops where the window
   * does not draw it, as when its volume is hidden, and where it cannot draw.
   * @return the number of frames
   */
  int RenderUntilConverged(vtkRenderWindow* window);

  ///@{
  /**
   * Whether blocks take over the borders of coarser neighbours, so that levels meet without a
   * crack: on both sides values are the same to 2^-16 of the range, for data of 8 bit to one step.
   * Not with a B-spline or curvature, which need a block's own samples. Default: on.
   */
  vtkSetMacro(InterblockContinuity, bool);
  vtkGetMacro(InterblockContinuity, bool);
  vtkBooleanMacro(InterblockContinuity, bool);
  ///@}

  ///@{
  /**
   * What the last frame was made of: blocks of the volume; blocks that are not transparent; those
   * drawn at a level of detail; visible blocks that are not yet at the level that is wanted; and
   * how many frames before it something last changed.
   */
  vtkTypeInt64 GetNumberOfBlocks() const;
  vtkTypeInt64 GetNumberOfVisibleBlocks() const;
  vtkTypeInt64 GetNumberOfBricks(int level) const;
  vtkTypeInt64 GetNumberOfPendingChanges() const;
  vtkTypeInt64 GetFramesSinceLastChange() const;
  ///@}

  ///@{
  /**
   * Bytes on the graphics card, counted where they are allocated: in all; the most at any time of
   * the last frame; of the atlas. Of the atlas, bytes that bricks take; that can hold a brick of a
   * level that a block waits for; and neither.
   */
  vtkTypeInt64 GetMemoryInBytes() const;
  vtkTypeInt64 GetPeakMemoryInBytes() const;
  vtkTypeInt64 GetAtlasBytes() const;
  vtkTypeInt64 GetUsedAtlasBytes() const;
  vtkTypeInt64 GetFreeAtlasBytes() const;
  vtkTypeInt64 GetUnusableAtlasBytes() const;
  ///@}

  ///@{
  /**
   * Bytes of bricks that were sent to the graphics card for the last frame, and moved within the
   * atlas.
   */
  vtkTypeInt64 GetUploadedBytes() const;
  vtkTypeInt64 GetMovedBytes() const;
  ///@}

  ///@{
  /// Of the last frame: rays that MaximumNumberOfSamples cut off; its ImageSampleDistance.
  vtkTypeInt64 GetNumberOfRaysCutOff() const;
  double GetUsedImageSampleDistance() const;
  ///@}

  ///@{
  /**
   * Milliseconds that the last frame took on the CPU: block ranges and transfer table; distortion;
   * levels and places; bricks and tables to the graphics card; commands of the ray caster, not
   * their execution.
   */
  double GetRangeMilliseconds() const;
  double GetDistortionMilliseconds() const;
  double GetSelectionMilliseconds() const;
  double GetUploadMilliseconds() const;
  double GetDrawMilliseconds() const;
  ///@}

  void GetColorImage(vtkImageData* image) override;
  void GetDepthImage(vtkImageData* image) override;

  /// Prints all these.
  void PrintStatistics(ostream& os);

  /// Bounds of the input in data set coordinates; uninitialized where they are not finite.
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }

  /// Draws the volume. Called by vtkVolume.
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /// Gives back everything on the graphics card of this window, after the frame that is drawn.
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkFlatBlockVolumeMapper();
  ~vtkFlatBlockVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkFlatBlockVolumeMapper(const vtkFlatBlockVolumeMapper&) = delete;
  void operator=(const vtkFlatBlockVolumeMapper&) = delete;
  void ReportOnce(const char* error);
  void TryFrame(vtkRenderer* renderer, vtkVolume* volume);
  void DrawFrame(vtkRenderer* renderer, vtkVolume* volume);
  void UpdateBlocks();
  void UpdateTransferTable();
  void ReportProgress();
  void UpdateAtlas(vtkRenderer* renderer, vtkVolume* volume);
  bool TryAtlas(vtkRenderer* renderer, vtkVolume* volume);
  void ShrinkAtlas();
  void UpdateLevels(vtkRenderer* renderer, vtkVolume* volume);
  void UpdateDistortion(vtkTypeInt64 mostBlocks);
  bool UsesCuda();
  vtkTypeInt64 GetBytesBesideAtlas(vtkRenderer* renderer) const;
  bool IsStepwise(vtkRenderer* renderer) const;
  double GetStep();
  vtkTypeInt64 GetImageBytes(vtkRenderer* renderer) const;
  void DrawRays(vtkRenderer* renderer, vtkVolume* volume);
  void CastRays(vtkRenderer* renderer, vtkVolume* volume);
  void AdjustDerivatives(vtkRenderer* renderer, vtkVolume* volume);
  void AdjustSampling(vtkRenderer* renderer, vtkVolume* volume);
  void WarnAboutSamples();
  void WarnAboutIgnoredSettings();

  int BlockSize = 33;
  vtkTypeInt64 MaxMemoryInBytes = vtkTypeInt64(256) << 20;
  int NumberOfLevels = 4;
  int LevelFilter = SUBSAMPLE;
  int SelectionCriterion = DISTANCE;
  bool DistortionPerByte = true;
  bool VisibilityWeighting = false;
  int DistortionBackend = AUTO;
  int DistortionEstimate = EXACT;
  int NumberOfThreads = 0;
  int DistortionBlocksPerFrame = 512;
  double PointOfInterest[3] = { 0.0, 0.0, 0.0 };
  bool UseCameraAsPointOfInterest = true;
  double RefinementFraction = 0.1;
  vtkTypeInt64 UploadBytesPerFrame = vtkTypeInt64(16) << 20;
  bool ProgressiveStills = false;
  bool InterblockContinuity = true;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
