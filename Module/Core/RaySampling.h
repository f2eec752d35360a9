/// How rays are sampled and classified.
#pragma once

#include "Blending.h"

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
  bool NeedsGradients() const { return this->IsShaded || this->HasGradientTable(); }

  /// Samples around a brick that its derivatives reach for.
  int GetApron() const { return this->NeedsGradients() ? 1 : 0; }

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
