#include "FlatBlockBlending.h"
#include "FlatBlockCurvature.h"
#include "FlatBlockLighting.h"
#include "RoundUp.h"
#include "vtkFlatBlockVolumeMapperInternals.h"

#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <string>

// How rays are sampled in vtkFlatBlockVolumeMapper.

namespace flatblock
{
bool IsInteractive(vtkRenderer* renderer)
{
  constexpr double InteractiveUpdateRate = 1.0;
  return renderer->GetRenderWindow()->GetDesiredUpdateRate() >= InteractiveUpdateRate;
}
} // namespace flatblock

namespace
{
// Images of less are not worth it; and the memory that is kept free for one is a quarter.
constexpr double LeastInteractiveFactor = 2.0;

flatblock::Classification GetMethod(int classification, vtkVolume* volume, bool mayIntegrate)
{
  // Between nearest samples there is nothing to integrate or to interpolate.
  if (volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION || !mayIntegrate)
  {
    return flatblock::Classification::PostInterpolation;
  }
  constexpr flatblock::Classification Methods[] = { flatblock::Classification::PreIntegrated,
    flatblock::Classification::PostInterpolation, flatblock::Classification::PreInterpolation };
  return Methods[classification];
}
} // namespace

double vtkFlatBlockVolumeMapper::GetStep()
{
  const flatblock::VolumeInput& input = this->Internals->Input;
  if (this->LockSampleDistanceToInputSpacing)
  {
    return this->SpacingAdjustedSampleDistance(input.Image->GetSpacing(), input.Image->GetExtent());
  }
  return this->SampleDistance > 0.0 ? this->SampleDistance
                                    : this->SampleDistanceInVoxels * input.SmallestSpacing;
}

void vtkFlatBlockVolumeMapper::AdjustSampling(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& in = *this->Internals;
  flatblock::RaySampling& sampling = in.Sampling;
  sampling.Blending = flatblock::GetBlending(this, volume->GetProperty(), in.Input.Components);
  sampling.Method = GetMethod(this->Classification, volume,
    sampling.Blending.IsComposite() && in.IsPlain() &&
      !flatblock::HasTwoDimensions(volume->GetProperty()));
  sampling.Components = static_cast<int>(in.Channels.size()) + (in.Mask ? 1 : 0);
  sampling.Mask =
    !in.Mask ? flatblock::MaskKind::None
             : (in.Input.HasLabels ? flatblock::MaskKind::Labels : flatblock::MaskKind::Binary);
  sampling.AreIndependent = in.Input.Components.AreIndependent;
  sampling.UnitOfOpacity = volume->GetProperty()->GetScalarOpacityUnitDistance();
  sampling.UnitOfLength = in.Input.SmallestSpacing;
  // Beyond these nothing changes in the picture, and single precision would overflow.
  sampling.Step = std::clamp(
    this->GetStep(), 1e-6 * in.Input.SmallestSpacing, std::max(2.0 * in.Input.Diagonal, 1e-30));
  sampling.PixelsPerRay = this->ImageSampleDistance;
  if (this->AutoAdjustSampleDistances)
  {
    const bool isInteractive = flatblock::IsInteractive(renderer);
    const double factor = isInteractive ? in.InteractiveFactor : 1.0;
    sampling.PixelsPerRay = std::max(
      this->MinimumImageSampleDistance, std::min(factor, this->MaximumImageSampleDistance));
    sampling.Step *= factor;
  }
  sampling.Jittering = this->UseJittering;
  sampling.Adaptive = this->AdaptiveSampling;
  sampling.IsShaded = volume->GetProperty()->GetShade() != 0 && sampling.Blending.HasSurfaces();
  sampling.HasGradientOpacity = flatblock::HasGradientOpacity(volume->GetProperty(),
                                  sampling.AreIndependent ? sampling.Components : 1) &&
                                sampling.Blending.IsComposite();
  sampling.HasSecondArray = in.HasSecondArray;
  sampling.IsTwoDimensional = flatblock::HasTwoDimensions(volume->GetProperty()) &&
                              sampling.Blending.IsComposite() &&
                              (sampling.Components == 1 || in.HasSecondArray);
  sampling.HasNormalsFromOpacity =
    sampling.IsShaded && this->ComputeNormalFromOpacity && sampling.Blending.IsComposite();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  const bool mayScatter = sampling.IsShaded && sampling.Blending.IsComposite() &&
                          sampling.Components == 1 && !sampling.IsTwoDimensional;
  sampling.ScatteringBlending = mayScatter ? this->VolumetricScatteringBlending : 0.0;
  sampling.ScatteringReach = this->GlobalIlluminationReach;
  sampling.ScatteringAnisotropy = volume->GetProperty()->GetScatteringAnisotropy();
#endif
  this->AdjustDerivatives(renderer, volume);
  sampling.HasPositionalLights = sampling.IsShaded && flatblock::HasPositionalLights(renderer);
  // The first light is that of surfaces, which says nothing of shadows.
  sampling.ShadingThreshold = sampling.HasScattering() ? 0.0 : this->ShadingOpacityThreshold;
  sampling.MostSamples = this->MaximumNumberOfSamples;
  sampling.CountsSamples = this->CountSamples;
  sampling.RayStart = this->RayStartOffset;
  sampling.EnoughOpacity = this->EarlyTerminationThreshold;
  sampling.ImageTolerance = this->ImageSamplingTolerance;
  sampling.RefinesImage =
    this->AdaptiveImageSampling && flatblock::IsInteractive(renderer) && !sampling.HasCounts();
  sampling.PixelsPerRay = sampling.RefinesImage ? 1.0 : sampling.PixelsPerRay;
  sampling.StaysInImage = this->RenderToImage;
  if (sampling.StaysInImage)
  {
    sampling.RefinesImage = false;
    sampling.CountsSamples = false;
    sampling.MostSamples = 0;
  }
  sampling.IsSelection = false;
  in.PlainSampling = sampling;
  sampling.IsSelection = in.Selection.has_value();
  if (sampling.IsSelection)
  {
    constexpr double Seen = 3.0 / 255.0; // as in the shader
    sampling.StaysInImage = false;
    sampling.PixelsPerRay = 1.0;
    sampling.RefinesImage = false;
    sampling.CountsSamples = false;
    sampling.MostSamples = 0;
    sampling.EnoughOpacity = std::min(sampling.EnoughOpacity, Seen);
  }
}

// The filter, and what curvature shows.
void vtkFlatBlockVolumeMapper::AdjustDerivatives(vtkRenderer* renderer, vtkVolume* volume)
{
  flatblock::RaySampling& sampling = this->Internals->Sampling;
  const bool isStill = !flatblock::IsInteractive(renderer);
  const int stillFilter = this->StillReconstructionFilter == SAME_FILTER
                            ? this->ReconstructionFilter
                            : this->StillReconstructionFilter;
  const bool isLinear = volume->GetProperty()->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
  const int filter = isStill ? stillFilter : this->ReconstructionFilter;
  sampling.Filter = isLinear ? static_cast<flatblock::ReconstructionFilter>(filter)
                             : flatblock::ReconstructionFilter::Linear;
  sampling.MayBeSpline =
    isLinear && (stillFilter == CUBIC_B_SPLINE || this->ReconstructionFilter == CUBIC_B_SPLINE);
  const bool mayBeCurved =
    (sampling.Components == 1 || !sampling.HasManyValues()) &&
    (sampling.Blending.IsComposite() || sampling.Blending.Mode == flatblock::BlendMode::Isosurface);
  sampling.Curvature = mayBeCurved
                         ? static_cast<flatblock::CurvatureFunction>(this->CurvatureFunction)
                         : flatblock::CurvatureFunction::None;
  sampling.HasEndsInside = !(this->CurvatureRange[0] < this->CurvatureRange[1]);
  sampling.CurvatureRange =
    sampling.HasEndsInside
      ? flatblock::GetNaturalRange(sampling.Curvature, sampling.UnitOfLength)
      : std::array<double, 2>{ this->CurvatureRange[0], this->CurvatureRange[1] };
  std::copy_n(sampling.CurvatureRange.begin(), 2, this->UsedCurvatureRange);
  sampling.HasCurvatureOpacity =
    sampling.Curvature != flatblock::CurvatureFunction::None && this->GetCurvatureOpacity();
  sampling.SilhouetteWidth = mayBeCurved ? this->SilhouetteWidth : 0.0;
  std::copy_n(this->SilhouetteColor, 3, sampling.SilhouetteColor.begin());
  std::copy_n(this->GradientModulation, 3, sampling.GradientModulation.begin());
  sampling.HasEagerDerivatives = !this->DerivativesOnDemand && sampling.NeedsGradients();
}

// Of the image of rays; where interactive frames may have one, it is kept free for it, so that the
// atlas is the same for all frames.
vtkTypeInt64 vtkFlatBlockVolumeMapper::GetImageBytes(vtkRenderer* renderer) const
{
  const flatblock::RaySampling& sampling = this->Internals->PlainSampling;
  flatblock::RaySampling interactive = sampling;
  interactive.PixelsPerRay = LeastInteractiveFactor;
  flatblock::RaySampling refined = sampling;
  refined.RefinesImage = this->AdaptiveImageSampling;
  const bool mayAdjust =
    this->AutoAdjustSampleDistances && this->MaximumImageSampleDistance >= LeastInteractiveFactor;
  return flatblock::RoundUp(
    std::max({ vtkOpenGLFlatBlockRayCaster::GetImageBytes(renderer, sampling),
      vtkOpenGLFlatBlockRayCaster::GetImageBytes(renderer, refined),
      mayAdjust ? vtkOpenGLFlatBlockRayCaster::GetImageBytes(renderer, interactive)
                : vtkTypeInt64(0) }));
}

// Time goes with the rays along both axes of the picture and the samples along each.
void vtkFlatBlockVolumeMapper::vtkInternals::AdjustInteractiveFactor(
  double seconds, double allowed, double largest)
{
  constexpr double NotWorthwhile = 1.5;
  const double wanted = this->InteractiveFactor * std::cbrt(seconds / std::max(allowed, 1e-3));
  this->InteractiveFactor = wanted < NotWorthwhile ? 1.0
                                                   : std::clamp(wanted, LeastInteractiveFactor,
                                                       std::max(LeastInteractiveFactor, largest));
}

// Once for each that is new.
void vtkFlatBlockVolumeMapper::WarnAboutSamples()
{
  constexpr double LeastStep = 1.0 / 256.0; // as in the shader
  vtkInternals& in = *this->Internals;
  const double asked = this->LockSampleDistanceToInputSpacing ? 0.0 : this->SampleDistance;
  std::string warning;
  if (asked > 0.0 && asked < LeastStep * in.Input.SmallestSpacing)
  {
    warning +=
      " A sample distance of " + std::to_string(asked / in.Input.SmallestSpacing) +
      " of the smallest spacing is too small to be told from 1/256, which takes its place.";
  }
  if (asked > in.Input.Diagonal)
  {
    warning +=
      " The sample distance is longer than the volume: rays take a sample where they enter "
      "it and one where they leave.";
  }
  const vtkTypeInt64 holes = in.CountHoles() - in.Scalars->GetNumberOfBlanked() *
                                                 static_cast<vtkTypeInt64>(in.Channels.size());
  if (holes > 0)
  {
    warning +=
      " " + std::to_string(holes) + " samples are not finite; the cells around them are not drawn.";
  }
  if (!warning.empty() && warning != in.LastSampleWarning)
  {
    vtkWarningMacro(<< warning.substr(1));
  }
  in.LastSampleWarning = warning;
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetNumberOfRaysCutOff() const
{
  return this->Internals->Sampling.MostSamples > 0 ? this->Internals->RayCaster->GetCounts().CutOff
                                                   : 0;
}

double vtkFlatBlockVolumeMapper::GetUsedImageSampleDistance() const
{
  return this->Internals->Sampling.PixelsPerRay;
}
