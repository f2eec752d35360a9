/**
 * @class   vtkFlatBlockCurvatureMapper
 * @brief   abstract superclass of a volume mapper: derivatives, and what curvature shows
 *
 * Curvature is that of the surfaces of equal value, in the data set's unit of length, whatever the
 * spacing and the direction; normals point to where values fall, so that a dense ball is convex,
 * and convex is positive. Derivatives are computed where a ray is sampled, and only there where
 * something is seen. In composites and of isosurfaces, of one component, which may have a mask;
 * other scenes ignore it with a warning.
 *
 * @sa vtkFlatBlockVolumeMapper
 */

#ifndef vtkFlatBlockCurvatureMapper_h
#define vtkFlatBlockCurvatureMapper_h

#include "vtkFlatBlockShadingMapper.h"
#include "vtkSmartPointer.h" // for functions

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

class VTKFLATBLOCKVOLUMERENDERING_EXPORT vtkFlatBlockCurvatureMapper
  : public vtkFlatBlockShadingMapper
{
public:
  vtkTypeMacro(vtkFlatBlockCurvatureMapper, vtkFlatBlockShadingMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  void ShallowCopy(vtkAbstractMapper* other) override;
  vtkMTimeType GetMTime() override;

  enum ReconstructionFilters
  {
    SAME_FILTER = -1,
    LINEAR,
    CUBIC_B_SPLINE
  };

  ///@{
  /**
   * What is between samples, where the property's interpolation is linear. Linear (default):
   * trilinear values, and central differences. CubicBSpline: a uniform tricubic B-spline, smooth up
   * to its second derivatives, which are exact; it takes 8 fetches for a value where Linear takes
   * 1, and a sample around each brick. Classification PreInterpolation, normals from opacity and
   * gradients of several components stay with Linear.
   */
  vtkSetClampMacro(ReconstructionFilter, int, LINEAR, CUBIC_B_SPLINE);
  vtkGetMacro(ReconstructionFilter, int);
  void SetReconstructionFilterToLinear() { this->SetReconstructionFilter(LINEAR); }
  void SetReconstructionFilterToCubicBSpline() { this->SetReconstructionFilter(CUBIC_B_SPLINE); }
  ///@}

  ///@{
  /**
   * Whether the B-spline goes through the samples (Sigg and Hadwiger's prefilter), or has them for
   * its coefficients (default: off), which smooths. Bricks then hold coefficients, in floats,
   * whatever AtlasPrecision says, and are uploaded again where the filter changes between moving
   * and still pictures; those of coarser levels go through samples, whatever LevelFilter says. For
   * one component without a mask whose samples are all finite; but for PreInterpolation and normals
   * from opacity, which classify samples.
   */
  vtkSetMacro(InterpolatingBSpline, bool);
  vtkGetMacro(InterpolatingBSpline, bool);
  vtkBooleanMacro(InterpolatingBSpline, bool);
  ///@}

  ///@{
  /**
   * The filter of stills, those frames whose window's desired update rate is below 1: Same
   * (default) as ReconstructionFilter, or another: then pictures are quick while one moves, and
   * good when one stops.
   */
  vtkSetClampMacro(StillReconstructionFilter, int, SAME_FILTER, CUBIC_B_SPLINE);
  vtkGetMacro(StillReconstructionFilter, int);
  void SetStillReconstructionFilterToSame() { this->SetStillReconstructionFilter(SAME_FILTER); }
  void SetStillReconstructionFilterToLinear() { this->SetStillReconstructionFilter(LINEAR); }
  void SetStillReconstructionFilterToCubicBSpline()
  {
    this->SetStillReconstructionFilter(CUBIC_B_SPLINE);
  }
  ///@}

  enum CurvatureFunctions
  {
    NO_CURVATURE,
    FIRST_PRINCIPAL,
    SECOND_PRINCIPAL,
    MEAN,
    GAUSSIAN,
    TOTAL,
    LARGEST_MAGNITUDE,
    SHAPE_INDEX,
    CURVEDNESS,
    LINE_FEATURE
  };

  ///@{
  /**
   * The function of the principal curvatures k1 >= k2, in 1/length, that CurvatureColor shows in
   * place of the property's colours; opacity stays that of the property. None (default);
   * FirstPrincipal k1; SecondPrincipal k2; Mean (k1 + k2)/2; Gaussian k1 k2, in 1/length^2; Total
   * sqrt(k1^2 + k2^2); LargestMagnitude that of k1 and k2 with the larger magnitude, with its sign;
   * ShapeIndex 2/pi atan((k1 + k2)/(k1 - k2)) from -1 (cup) by -0.5 (rut), 0 (saddle) and 0.5
   * (ridge) to 1 (cap); Curvedness sqrt((k1^2 + k2^2)/2) (both of Koenderink and van Doorn, 1992);
   * LineFeature |k1| - |k2| where the mean is positive, else that too, negative where the surface
   * is a groove: 0 on planes, balls and saddles, 1/radius on a tube. All fade to 0
   * where the gradient may be rounding of the samples: to a half of what they are where it is two
   * steps of integers a spacing, or 2/255 of their range where that is less, and 2^-21 of the range
   * of floats.
   */
  vtkSetClampMacro(CurvatureFunction, int, NO_CURVATURE, LINE_FEATURE);
  vtkGetMacro(CurvatureFunction, int);
  void SetCurvatureFunctionToNone() { this->SetCurvatureFunction(NO_CURVATURE); }
  void SetCurvatureFunctionToFirstPrincipal() { this->SetCurvatureFunction(FIRST_PRINCIPAL); }
  void SetCurvatureFunctionToSecondPrincipal() { this->SetCurvatureFunction(SECOND_PRINCIPAL); }
  void SetCurvatureFunctionToMean() { this->SetCurvatureFunction(MEAN); }
  void SetCurvatureFunctionToGaussian() { this->SetCurvatureFunction(GAUSSIAN); }
  void SetCurvatureFunctionToTotal() { this->SetCurvatureFunction(TOTAL); }
  void SetCurvatureFunctionToLargestMagnitude() { this->SetCurvatureFunction(LARGEST_MAGNITUDE); }
  void SetCurvatureFunctionToShapeIndex() { this->SetCurvatureFunction(SHAPE_INDEX); }
  void SetCurvatureFunctionToCurvedness() { this->SetCurvatureFunction(CURVEDNESS); }
  void SetCurvatureFunctionToLineFeature() { this->SetCurvatureFunction(LINE_FEATURE); }
  ///@}

  ///@{
  /**
   * Colours over the function's value. From their first point to the last they are stretched over
   * CurvatureRange. Default: none; then blue where the surface is concave, gray where it is flat
   * and red where it is convex, or gray and red for Total and Curvedness.
   */
  virtual void SetCurvatureColor(vtkColorTransferFunction* color);
  virtual vtkColorTransferFunction* GetCurvatureColor();
  ///@}

  ///@{
  /**
   * A share of the property's opacity over the function's value, from 0 to 1, stretched like
   * CurvatureColor: matter is as many times less dense. Light that is scattered is absorbed as if
   * all of it were there. Default: none, all of it. A value that is not finite is an error.
   */
  virtual void SetCurvatureOpacity(vtkPiecewiseFunction* opacity);
  virtual vtkPiecewiseFunction* GetCurvatureOpacity();
  ///@}

  ///@{
  /**
   * Values of the function that CurvatureColor and CurvatureOpacity go from and to: as their points
   * are, where it is the range of these. Default: 0 and 0; wherever the first is not below the
   * second the range is automatic: what samples can tell, up to 1/4 of the inverse of the smallest
   * spacing (its square for Gaussian, from -1 to 1 for ShapeIndex), on both sides of 0 for
   * functions that have a sign. That then takes 2 % to 98 % of the functions, and values beyond it
   * count as its ends.
   */
  vtkSetVector2Macro(CurvatureRange, double);
  vtkGetVector2Macro(CurvatureRange, double);
  ///@}

  /**
   * What CurvatureRange was in the last frame.
   */
  void GetUsedCurvatureRange(double range[2]) const;

  ///@{
  /**
   * Width of the outlines that are drawn where surfaces turn away from the eye, in the data set's
   * unit of length, 0 or more. By the curvature along the view it is the same on flat and on bent
   * surfaces (Kindlmann, Whitaker, Tasdizen and Moeller, Curvature-Based Transfer Functions, 2003).
   * Default: 0, none.
   */
  vtkSetClampMacro(SilhouetteWidth, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SilhouetteWidth, double);
  ///@}

  ///@{
  /**
   * Colour of the outlines, red, green and blue from 0 to 1. Default: black.
   */
  void SetSilhouetteColor(double red, double green, double blue);
  vtkGetVector3Macro(SilhouetteColor, double);
  ///@}

  ///@{
  /**
   * How much of the material's ambient, diffuse and specular light depends on the magnitude of the
   * gradient, from 0 (default), nothing, to 1: light falls on what has the steepest gradients that
   * gradient opacity tells, none on what has none. Where the property shades, but for normals from
   * opacity.
   */
  void SetGradientModulation(double ambient, double diffuse, double specular);
  vtkGetVector3Macro(GradientModulation, double);
  ///@}

  ///@{
  /**
   * Whether derivatives are computed only where something is seen. Default: on. Off is slower and
   * draws the same: to measure what that brings.
   */
  vtkSetMacro(DerivativesOnDemand, bool);
  vtkGetMacro(DerivativesOnDemand, bool);
  vtkBooleanMacro(DerivativesOnDemand, bool);
  ///@}

protected:
  vtkFlatBlockCurvatureMapper();
  ~vtkFlatBlockCurvatureMapper() override;

  int ReconstructionFilter = LINEAR;
  bool InterpolatingBSpline = false;
  int StillReconstructionFilter = SAME_FILTER;
  int CurvatureFunction = NO_CURVATURE;
  vtkSmartPointer<vtkColorTransferFunction> CurvatureColor;
  vtkSmartPointer<vtkPiecewiseFunction> CurvatureOpacity;
  double CurvatureRange[2] = { 0.0, 0.0 };
  double UsedCurvatureRange[2] = { 0.0, 0.0 };
  double SilhouetteWidth = 0.0;
  double SilhouetteColor[3] = { 0.0, 0.0, 0.0 };
  double GradientModulation[3] = { 0.0, 0.0, 0.0 };
  bool DerivativesOnDemand = true;

private:
  vtkFlatBlockCurvatureMapper(const vtkFlatBlockCurvatureMapper&) = delete;
  void operator=(const vtkFlatBlockCurvatureMapper&) = delete;
};

#endif
