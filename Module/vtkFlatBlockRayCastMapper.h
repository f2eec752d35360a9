/**
 * @class   vtkFlatBlockRayCastMapper
 * @brief   abstract superclass of a volume mapper: how its rays are sampled and classified
 *
 * Properties that vtkGPUVolumeRayCastMapper has, too, have its names and its meaning. Distances
 * along a ray are in the data set's unit of length, as in vtkGPUVolumeRayCastMapper: the unit of
 * world coordinates, unless the prop is scaled.
 *
 * From vtkVolumeProperty: colour, scalar opacity, ScalarOpacityUnitDistance, interpolation (linear
 * or nearest). Shading by the lights of the renderer with the property's material. All blend modes
 * of vtkVolumeMapper: maximum and minimum show the colour and the opacity that the functions give
 * to that value; an average is that of values times their opacity, over the parts of a ray within
 * AverageIPScalarRange; the additive sum is the same over ScalarOpacityUnitDistance, both for
 * values from 0 to 1 over the data's range and drawn as grays. Isosurfaces, those of the property's
 * GetIsoSurfaceValues(), have the colour and the opacity of their value. The slice is that of a
 * vtkPlane in world coordinates, in the property's SetSliceFunction(). Clipping planes and cropping
 * cut rays where they lie.
 *
 * With composite blending, gradient opacity and 2D transfer functions are measured as
 * vtkGPUVolumeRayCastMapper does: the magnitude of the gradient times the mean spacing, where what
 * is beyond a quarter of the data's range counts as that. Rows of a 2D function go from 0 to there,
 * columns over the data's range; its opacity is that of ScalarOpacityUnitDistance. Other blend
 * modes take of a 2D function what is the most opaque with a value.
 *
 * @sa vtkFlatBlockVolumeMapper
 */

#ifndef vtkFlatBlockRayCastMapper_h
#define vtkFlatBlockRayCastMapper_h

#include "vtkFlatBlockCurvatureMapper.h"

class VTKFLATBLOCKVOLUMERENDERING_EXPORT vtkFlatBlockRayCastMapper
  : public vtkFlatBlockCurvatureMapper
{
public:
  vtkTypeMacro(vtkFlatBlockRayCastMapper, vtkFlatBlockCurvatureMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  void ShallowCopy(vtkAbstractMapper* other) override;

  enum Classifications
  {
    PRE_INTEGRATED,
    POST_INTERPOLATION,
    PRE_INTERPOLATION
  };

  ///@{
  /**
   * How samples become colours. PreIntegrated (default): between two samples of a ray values are
   * taken as linear, and colour and opacity of all that they run through are integrated, to 1e-4,
   * for any step and any opacity: thin shells stay whole. PostInterpolation: values are
   * interpolated, then classified, as in vtkGPUVolumeRayCastMapper; what lies between two samples
   * is missed. PreInterpolation: samples of the data are classified, then their colours
   * interpolated; slow, and blurred. With nearest interpolation there is nothing between two
   * samples, and PreIntegrated draws as PostInterpolation.
   */
  vtkSetClampMacro(Classification, int, PRE_INTEGRATED, PRE_INTERPOLATION);
  vtkGetMacro(Classification, int);
  void SetClassificationToPreIntegrated() { this->SetClassification(PRE_INTEGRATED); }
  void SetClassificationToPostInterpolation() { this->SetClassification(POST_INTERPOLATION); }
  void SetClassificationToPreInterpolation() { this->SetClassification(PRE_INTERPOLATION); }
  ///@}

  ///@{
  /**
   * Distance between two samples along a ray, in the finest blocks. 0 (default): half of the
   * smallest spacing. A step of less than 1/256 voxel is lengthened to it, since texture units
   * filter no finer, with a warning where it was asked for; one that is longer than the volume
   * takes a sample where the ray enters it and one where it leaves, with a warning.
   */
  vtkSetClampMacro(SampleDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * The same in units of the smallest spacing, where SampleDistance is 0. Default: 0.5.
   */
  vtkSetClampMacro(SampleDistanceInVoxels, double, 1e-3, 1e6);
  vtkGetMacro(SampleDistanceInVoxels, double);
  ///@}

  ///@{
  /**
   * Sets all that trades accuracy for speed at once: Classification, the sample distances, the
   * image sample distances and whether they adjust themselves, early termination, tolerances and
   * ShadingOpacityThreshold. Over the scenes of `flatblock-bench --filter Quality` with 128^3
   * samples in 256^2 pixels, Interactive has a PSNR of 22 dB at least, Balanced of 28, Accurate of
   * 54, Reference of 60; README.md has the table. Automatic is Accurate for stills, and
   * interactive frames keep to FrameTimeGoal: GetExpectedPSNR() says how close they then
   * are.
   */
  void SetQualityToInteractive();
  void SetQualityToBalanced();
  void SetQualityToAccurate();
  void SetQualityToReference();
  void SetQualityToAutomatic();
  ///@}

  /**
   * The lowest PSNR in dB that the benchmark found where frames of the automatic quality are so
   * much coarser: what GetUsedImageSampleDistance() of the mapper says.
   */
  static double GetExpectedPSNR(double coarser);

  ///@{
  /**
   * Whether interactive frames, instead of choosing an image sample distance, first draw one ray
   * for 4 x 4 pixels, and others only where channels of the four rays around a pixel, of colours
   * multiplied by opacity and of opacity, differ by more than ImageSamplingTolerance, from 0 to 1.
   * What is smaller than the grid may be missed. Default: off, 0.02. Does nothing where rays are
   * counted.
   */
  vtkSetMacro(AdaptiveImageSampling, bool);
  vtkGetMacro(AdaptiveImageSampling, bool);
  vtkBooleanMacro(AdaptiveImageSampling, bool);
  vtkSetClampMacro(ImageSamplingTolerance, double, 0.0, 1.0);
  vtkGetMacro(ImageSamplingTolerance, double);
  ///@}

  ///@{
  /**
   * Seconds that an interactive frame may take where AutoAdjustSampleDistances is on. Default: 0,
   * what the renderer allocates.
   */
  vtkSetClampMacro(FrameTimeGoal, double, 0.0, 3600.0);
  vtkGetMacro(FrameTimeGoal, double);
  ///@}

  ///@{
  /**
   * Whether interactive frames lengthen SampleDistance and ImageSampleDistance alike to take no
   * more time than the volume is allowed, by the time that the last one took. All other frames are
   * drawn with MinimumImageSampleDistance. Default: on.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  ///@{
  /**
   * Whether the data's spacing and size give the distance between samples, whatever SampleDistance
   * is: from 1/200 of the mean spacing for 8 voxels, growing with the cube root of their number, to
   * 1/2 of it for a million or more. Default: off.
   */
  vtkSetMacro(LockSampleDistanceToInputSpacing, bool);
  vtkGetMacro(LockSampleDistanceToInputSpacing, bool);
  vtkBooleanMacro(LockSampleDistanceToInputSpacing, bool);
  ///@}

  ///@{
  /**
   * Pixels from one ray to the next along both axes of the picture, from 0.1 to 100: 1 (default) is
   * a ray a pixel, 2 one for four pixels, which are interpolated, 0.5 four rays for each pixel,
   * whose mean it shows. Where AutoAdjustSampleDistances is on, interactive frames choose it
   * between MinimumImageSampleDistance (default 1) and MaximumImageSampleDistance (default 10).
   */
  vtkSetClampMacro(ImageSampleDistance, double, 0.1, 100.0);
  vtkGetMacro(ImageSampleDistance, double);
  vtkSetClampMacro(MinimumImageSampleDistance, double, 0.1, 100.0);
  vtkGetMacro(MinimumImageSampleDistance, double);
  vtkSetClampMacro(MaximumImageSampleDistance, double, 0.1, 100.0);
  vtkGetMacro(MaximumImageSampleDistance, double);
  ///@}

  ///@{
  /**
   * Whether each ray begins at another share of a step, so that too long steps show as noise
   * instead of rings. The shares depend on the pixel alone: a picture repeats. Default: off.
   */
  vtkSetMacro(UseJittering, bool);
  vtkGetMacro(UseJittering, bool);
  vtkBooleanMacro(UseJittering, bool);
  ///@}

  ///@{
  /**
   * Whether the step follows the level of detail of the block that a ray is in: twice as long a
   * level, with the opacity of its length. Default: on.
   */
  vtkSetMacro(AdaptiveSampling, bool);
  vtkGetMacro(AdaptiveSampling, bool);
  vtkBooleanMacro(AdaptiveSampling, bool);
  ///@}

  ///@{
  /**
   * Samples after which a ray ends, whatever is behind. 0 (default): no limit. Rays that it cut off
   * are counted: see GetNumberOfRaysCutOff(). Where it is set, rays are drawn to a picture of their
   * own first, which counts in MaxMemoryInBytes.
   */
  vtkSetClampMacro(MaximumNumberOfSamples, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfSamples, int);
  ///@}

  ///@{
  /**
   * What is nearer to the eye than this is not drawn, in world units: for a camera inside the
   * volume. In parallel projection it counts from the near plane. Default: 0.
   */
  vtkSetClampMacro(RayStartOffset, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RayStartOffset, double);
  ///@}

  ///@{
  /**
   * Opacity at which a ray ends, from 0 to 1. Default: 1 - 1/255, so that what is left out is at
   * most one step of a picture of 8 bits. 1: rays go on to the end.
   */
  vtkSetClampMacro(EarlyTerminationThreshold, double, 0.0, 1.0);
  vtkGetMacro(EarlyTerminationThreshold, double);
  ///@}

  enum Skippings
  {
    SKIP_NOTHING,
    SKIP_BLOCKS,
    SKIP_CELLS
  };

  ///@{
  /**
   * What rays leap over where the transfer function leaves it transparent: nothing but what no
   * brick holds, one block after the other; runs of transparent blocks; or also cubes of 4^3 cells
   * and more (default), by a map of one byte a cube, which counts in MaxMemoryInBytes and takes at
   * most 1/64 of it. Points of a ray stay where they are, and pictures the same to 1/255.
   */
  vtkSetClampMacro(Skipping, int, SKIP_NOTHING, SKIP_CELLS);
  vtkGetMacro(Skipping, int);
  void SetSkippingToNothing() { this->SetSkipping(SKIP_NOTHING); }
  void SetSkippingToBlocks() { this->SetSkipping(SKIP_BLOCKS); }
  void SetSkippingToCells() { this->SetSkipping(SKIP_CELLS); }
  ///@}

  ///@{
  /**
   * Whether what Skipping looks at is also left in one leap where it is of one colour and opacity:
   * with the opacity of its whole length. Default: on. Volumes that are shaded vary in light, so
   * there it does nothing.
   */
  vtkSetMacro(HomogeneousLeaps, bool);
  vtkGetMacro(HomogeneousLeaps, bool);
  vtkBooleanMacro(HomogeneousLeaps, bool);
  ///@}

  enum Precisions
  {
    NATIVE = 0,
    BITS_1 = 1,
    BITS_4 = 4,
    BITS_8 = 8
  };

  ///@{
  /**
   * Of texels in the atlas: as they are (NATIVE, default), or of 8 bits on a scale of each block's
   * own range, so that a sample is off by at most 1/510 of that range; or of 4 bits (1/30) or 1 bit
   * (1/2), which take 8 bits as well. The range is that of the blocks around it, too, where levels
   * are filtered, and where shading, gradients, curvature or a B-spline reach for samples around
   * it. Anything else is refused with an error. Volumes with
   * samples that are not finite are drawn as they are.
   */
  void SetAtlasPrecision(int precision);
  vtkGetMacro(AtlasPrecision, int);
  void SetAtlasPrecisionToNative() { this->SetAtlasPrecision(NATIVE); }
  void SetAtlasPrecisionTo8Bits() { this->SetAtlasPrecision(BITS_8); }
  void SetAtlasPrecisionTo4Bits() { this->SetAtlasPrecision(BITS_4); }
  void SetAtlasPrecisionTo1Bit() { this->SetAtlasPrecision(BITS_1); }
  ///@}

  ///@{
  /**
   * The variation map's epsilon, in units of the scalars, from 0 on. Where all values of a cube
   * that Skipping looks at, and of those around it, are no further apart, a ray takes two samples
   * and leaps, with the matter of the second one over the whole length. So what is classified is
   * off by at most this. Default: 0, exact. Needs Skipping.
   */
  vtkSetClampMacro(VariationTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(VariationTolerance, double);
  ///@}

  ///@{
  /**
   * Whether frames tell by timer queries how long the graphics card took for the rays; each is
   * waited for. GetGPUMilliseconds() is that of the last frame, -1 where there are no such queries,
   * or where this is off, the default.
   */
  vtkSetMacro(Profiling, bool);
  vtkGetMacro(Profiling, bool);
  vtkBooleanMacro(Profiling, bool);
  vtkGetMacro(GPUMilliseconds, double);
  ///@}

  ///@{
  /**
   * Whether rays count, in a shader of their own: GetSamplesPerRay() are the points that were
   * classified, GetFetchesPerRay() the texels or filtered values that were read from textures,
   * means over the rays of the last frame that met the volume's box; 0 where this is off, the
   * default.
   */
  vtkSetMacro(CountSamples, bool);
  vtkGetMacro(CountSamples, bool);
  vtkBooleanMacro(CountSamples, bool);
  vtkGetMacro(SamplesPerRay, double);
  vtkGetMacro(FetchesPerRay, double);
  ///@}

protected:
  vtkFlatBlockRayCastMapper();
  ~vtkFlatBlockRayCastMapper() override;

  int Classification = PRE_INTEGRATED;
  double SampleDistance = 0.0;
  double SampleDistanceInVoxels = 0.5;
  double FrameTimeGoal = 0.0;
  bool AdaptiveImageSampling = false;
  double ImageSamplingTolerance = 0.02;
  bool AutoAdjustSampleDistances = true;
  bool LockSampleDistanceToInputSpacing = false;
  double ImageSampleDistance = 1.0;
  double MinimumImageSampleDistance = 1.0;
  double MaximumImageSampleDistance = 10.0;
  bool UseJittering = false;
  bool AdaptiveSampling = true;
  int MaximumNumberOfSamples = 0;
  double RayStartOffset = 0.0;
  double EarlyTerminationThreshold = 1.0 - 1.0 / 255.0;
  int Skipping = SKIP_CELLS;
  bool HomogeneousLeaps = true;
  int AtlasPrecision = NATIVE;
  double VariationTolerance = 0.0;
  bool Profiling = false;
  bool CountSamples = false;
  double GPUMilliseconds = -1.0;
  double SamplesPerRay = 0.0;
  double FetchesPerRay = 0.0;

private:
  vtkFlatBlockRayCastMapper(const vtkFlatBlockRayCastMapper&) = delete;
  void operator=(const vtkFlatBlockRayCastMapper&) = delete;
};

#endif
