/// How rays are sampled and classified.
#pragma once

#include "Blending.h"

#include <array>

namespace flatblock
{
enum class Classification
{
  PreIntegrated,
  PostInterpolation,
  PreInterpolation
};

/// Of all rays that meet the volume's box.
struct RayCounts
{
  long long Rays = 0;
  long long CutOff = 0; ///< by the limit of samples
  double Samples = 0.0; ///< points that were classified
  double Fetches = 0.0; ///< of textures: bricks, their index, map of leaps, transfer function
};

/// What is between samples.
enum class ReconstructionFilter
{
  Linear,
  CubicBSpline
};

/// What colours depend on, beside values.
enum class CurvatureFunction
{
  None,
  FirstPrincipal,
  SecondPrincipal,
  Mean,
  Gaussian,
  Total,
  LargestMagnitude,
  ShapeIndex,
  Curvedness,
  LineFeature
};

enum class MaskKind
{
  None,
  Binary,
  Labels
};

struct RaySampling
{
  flatblock::Blending Blending;
  int Components = 1;
  MaskKind Mask = MaskKind::None; ///< the last component
  bool AreIndependent = false;    ///< or colours, and the last one opacity
  Classification Method = Classification::PreIntegrated;
  double Step = 1.0;         ///< between samples at the finest level, in the data set's unit
  double UnitOfLength = 1.0; ///< of extinctions, in the data set's unit: the smallest spacing
  double PixelsPerRay = 1.0; ///< along both axes of the picture
  bool Jittering = false;
  bool Adaptive = true; ///< the step doubles a level
  int CellsPerCube = 0; ///< along a side, of the map of leaps; 0: there is none
  bool IsShaded = false;
  bool HasPositionalLights = false;
  bool HasNormalsFromOpacity = false;
  double ScatteringReach = 0.0;
  double ScatteringBlending = 0.0;
  double ScatteringAnisotropy = 0.0;
  bool HasGradientOpacity = false;
  bool IsTwoDimensional = false; ///< colours depend on gradients,
  bool HasSecondArray = false;   ///< or on another array, the last component
  ReconstructionFilter Filter = ReconstructionFilter::Linear;
  bool MayBeSpline = false; ///< in this frame or another
  CurvatureFunction Curvature = CurvatureFunction::None;
  std::array<double, 2> CurvatureRange = { 0.0, 1.0 }; ///< that the table is over
  bool HasEndsInside = false; ///< of that range: at 2 % and 98 % of the table
  bool HasCurvatureOpacity = false;
  double SilhouetteWidth = 0.0; ///< in the data set's unit
  std::array<double, 3> SilhouetteColor = { 0.0, 0.0, 0.0 };
  std::array<double, 3> GradientModulation = { 0.0, 0.0, 0.0 }; ///< of ambient, diffuse, specular
  bool HasEagerDerivatives = false;                             ///< of all samples, seen or not
  double ShadingThreshold = 0.0; ///< opacity that a piece must be seen with to be lit anew
  int MostSamples = 0;           ///< of a ray; 0: no limit
  double RayStart = 0.0;         ///< in world units from the eye, or the near plane
  double EnoughOpacity = 1.0;    ///< at which a ray ends
  double UnitOfOpacity = 1.0;    ///< that it is meant over in sums, in the data set's unit

  bool HasBrickRanges = false; ///< texels are on a scale of their brick
  bool RefinesImage = false;   ///< rays of a coarse grid come first, others only where they differ
  double ImageTolerance = 0.0; ///< by this
  bool CountsSamples = false;
  bool IsSelection = false;  ///< ids are drawn
  bool StaysInImage = false; ///< colours and depths are read back, and not drawn

  static constexpr double CoarsePixelsPerRay = 4.0;

  bool HasScattering() const { return this->ScatteringBlending > 0.0; }
  bool HasGradientTable() const { return this->HasGradientOpacity || this->IsTwoDimensional; }
  bool IsCurved() const
  {
    return this->Curvature != CurvatureFunction::None || this->SilhouetteWidth > 0.0;
  }
  bool HasGradientModulation() const
  {
    return this->IsShaded && !this->HasNormalsFromOpacity &&
           this->GradientModulation != std::array<double, 3>{ 0.0, 0.0, 0.0 };
  }
  bool NeedsMagnitudes() const { return this->HasGradientTable() || this->HasGradientModulation(); }
  bool NeedsGradients() const
  {
    return this->IsShaded || this->HasGradientTable() || this->IsCurved();
  }

  /// Samples around a brick that its values and derivatives reach for.
  int GetApron() const { return this->NeedsGradients() || this->MayBeSpline ? 1 : 0; }

  /// Whether texels are classified by themselves, and so must be samples.
  bool ReadsSamples() const
  {
    return this->Method == Classification::PreInterpolation || this->HasNormalsFromOpacity;
  }

  /// Whether bricks agree with coarser ones at their border, and not with their own samples, which
  /// second derivatives and splines are made of.
  bool MayCoarsenBorders() const { return !this->IsCurved() && !this->MayBeSpline; }

  /// Whether rays ask for the values that a block has.
  bool UsesRanges() const { return this->HasBrickRanges || this->HasExtremeRanges(); }

  /// Whether all components are values, and not a mask or rows of a function.
  bool HasManyValues() const
  {
    return this->Components > 1 && this->Mask == MaskKind::None && !this->HasSecondArray;
  }

  /// Whether the ranges of blocks tell where an extreme may lie.
  bool HasExtremeRanges() const { return this->Blending.IsExtreme() && !this->HasManyValues(); }

  double GetPixelsOfImage() const
  {
    return this->RefinesImage ? CoarsePixelsPerRay : this->PixelsPerRay;
  }

  /// Whether samples and fetches of each ray are counted.
  bool HasCounts() const { return this->CountsSamples || this->MostSamples > 0; }

  /// Whether the image of rays has counts, or depths, beside colours.
  bool HasTwoImages() const { return this->HasCounts() || this->StaysInImage; }

  /// Whether rays are drawn to an image of their own first.
  bool HasImage() const
  {
    return this->PixelsPerRay != 1.0 || this->HasTwoImages() || this->RefinesImage;
  }
};
} // namespace flatblock
