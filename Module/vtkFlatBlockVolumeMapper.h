/**
 * @class   vtkFlatBlockVolumeMapper
 * @brief   draws a volume from flat blocks in one ray-casting pass
 *
 * The volume is cut into flat blocks: cubes of 2^n cells whose neighbours share their border
 * samples. Blocks in which the transfer function is transparent are neither uploaded nor sampled;
 * the bricks of all others lie packed in one 3D texture, the atlas. One box is drawn, and each ray
 * walks from block to block.
 *
 * Within MaxMemoryInBytes each block has its own level of detail: level l is made of one sample in
 * 2^l along each axis. Blocks near the point of interest are refined first, those out of view last.
 *
 * Input: vtkImageData, point data, one component, at least two samples along each axis. Integers of
 * 8 and 16 bit are kept as they are. All other types become 32-bit floats over the data's own
 * range: a value is off by at most 2^-24 of that range; NaN counts as the lowest value, and
 * infinite values as the lowest or highest.
 *
 * From vtkVolumeProperty: colour, scalar opacity, ScalarOpacityUnitDistance, interpolation (linear
 * or nearest) of the first component. Blending is composite. Shading, gradient opacity, 2D transfer
 * functions, blanked points, cropping and clipping planes are not supported yet; a warning says so
 * where they are set. Hardware selection passes through the volume.
 *
 * What cannot be drawn gives one error, and nothing is drawn until it is set right.
 *
 * @sa vtkGPUVolumeRayCastMapper vtkVolumeProperty
 */

#ifndef vtkFlatBlockVolumeMapper_h
#define vtkFlatBlockVolumeMapper_h

#include "vtkFlatBlockVolumeRenderingModule.h" // for the export macro
#include "vtkVolumeMapper.h"

#include <memory> // for the internals
#include <vector> // for levels

class vtkRenderWindow;

class VTKFLATBLOCKVOLUMERENDERING_EXPORT vtkFlatBlockVolumeMapper : public vtkVolumeMapper
{
public:
  static vtkFlatBlockVolumeMapper* New();
  vtkTypeMacro(vtkFlatBlockVolumeMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
   * Distance between two samples along a ray, in the data set's unit of length (as in
   * vtkGPUVolumeRayCastMapper, a scale of the prop does not change it). 0 (default): half of the
   * smallest spacing. At most 2^20 samples are taken across the volume's diagonal; a distance that
   * asks for more is lengthened, with a warning.
   */
  vtkSetClampMacro(SampleDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * Bytes on the graphics card that are never exceeded, by atlas, index texture, tables and the
   * copy of the scene's depth together. Default: 256 MiB. Where the visible blocks don't fit at
   * their finest level, those far from the point of interest are drawn coarser.
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
   * What an interactive frame may do to reach the levels that are wanted: the share of the visible
   * blocks that change (default 0.1), and bytes of the bricks that these get (default 16 MiB);
   * bricks whose border follows a neighbour that has changed come on top. A frame is interactive
   * where the render window's desired update rate is 1 or more, as with vtkSmartVolumeMapper; all
   * others are converged before they are shown.
   */
  vtkSetClampMacro(RefinementFraction, double, 0.0, 1.0);
  vtkGetMacro(RefinementFraction, double);
  vtkSetClampMacro(UploadBytesPerFrame, vtkTypeInt64, 1, VTK_TYPE_INT64_MAX);
  vtkGetMacro(UploadBytesPerFrame, vtkTypeInt64);
  ///@}

  /**
   * Whether the last frame showed every block at the level that is wanted. Frames that don't send a
   * ProgressEvent with the share of the visible blocks that do.
   */
  bool GetConverged() const;

  /**
   * Renders the window until this mapper, which draws in it, has converged; stops where the window
   * does not draw it, as when its volume is hidden, and where it cannot draw.
   * @return the number of frames
   */
  int RenderUntilConverged(vtkRenderWindow* window);

  ///@{
  /**
   * Whether blocks take over the borders of coarser neighbours, so that levels meet without a
   * crack. Default: on.
   */
  vtkSetMacro(InterblockContinuity, bool);
  vtkGetMacro(InterblockContinuity, bool);
  vtkBooleanMacro(InterblockContinuity, bool);
  ///@}

  ///@{
  /**
   * What the last frame was made of: blocks of the volume; blocks that are not transparent; those
   * drawn at a level of detail; bytes on the graphics card, counted where they are allocated: in
   * all, the most at any time of the frame, and of the atlas; bytes of bricks sent to it for that
   * frame, and moved within the atlas.
   */
  vtkTypeInt64 GetNumberOfBlocks() const;
  vtkTypeInt64 GetNumberOfVisibleBlocks() const;
  vtkTypeInt64 GetNumberOfBricks(int level) const;
  vtkTypeInt64 GetMemoryInBytes() const;
  vtkTypeInt64 GetPeakMemoryInBytes() const;
  vtkTypeInt64 GetAtlasBytes() const;
  vtkTypeInt64 GetUploadedBytes() const;
  vtkTypeInt64 GetMovedBytes() const;
  ///@}

  ///@{
  /**
   * Bounds of the input in data set coordinates; uninitialized where they are not finite.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  ///@}

  /**
   * Prints all these, what the atlas has left, how many frames ago something last changed, and what
   * each stage of the last frame took on the CPU.
   */
  void PrintStatistics(ostream& os);

  /**
   * Draws the volume. Called by vtkVolume.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * Gives back everything on the graphics card. The next render starts anew, in any window.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkFlatBlockVolumeMapper();
  ~vtkFlatBlockVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkFlatBlockVolumeMapper(const vtkFlatBlockVolumeMapper&) = delete;
  void operator=(const vtkFlatBlockVolumeMapper&) = delete;

  void ReportOnce(const char* error);
  void DrawFrame(vtkRenderer* renderer, vtkVolume* volume);
  void UpdateBlocks();
  void UpdateTransferTable(vtkVolume* volume);
  std::vector<signed char> GetLevelsOfFrame(vtkRenderer* renderer);
  void ReportProgress();
  void UpdateAtlas(vtkRenderer* renderer, vtkVolume* volume);
  void UpdateLevels(vtkRenderer* renderer, vtkVolume* volume);
  vtkTypeInt64 GetBytesBesideAtlas(vtkRenderer* renderer) const;
  double GetStep() const;
  void WarnAboutIgnoredSettings(vtkVolume* volume);

  int BlockSize = 33;
  double SampleDistance = 0.0;
  vtkTypeInt64 MaxMemoryInBytes = vtkTypeInt64(256) << 20;
  int NumberOfLevels = 4;
  double PointOfInterest[3] = { 0.0, 0.0, 0.0 };
  bool UseCameraAsPointOfInterest = true;
  double RefinementFraction = 0.1;
  vtkTypeInt64 UploadBytesPerFrame = vtkTypeInt64(16) << 20;
  bool InterblockContinuity = true;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
