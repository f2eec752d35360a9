#include "FlatBlockRayCasterProgram.h"

#include "ViewRegion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include "FlatBlockAdaptiveImageGLSL.h"
#include "FlatBlockBlocksGLSL.h"
#include "FlatBlockClassifiedPointGLSL.h"
#include "FlatBlockClippingGLSL.h"
#include "FlatBlockComponentTablesGLSL.h"
#include "FlatBlockComponentValuesGLSL.h"
#include "FlatBlockComponentsGLSL.h"
#include "FlatBlockCompositingGLSL.h"
#include "FlatBlockCountingGLSL.h"
#include "FlatBlockCubicBSplineFilterGLSL.h"
#include "FlatBlockCurvatureGLSL.h"
#include "FlatBlockDerivativesGLSL.h"
#include "FlatBlockExtremesGLSL.h"
#include "FlatBlockGradientGLSL.h"
#include "FlatBlockIsosurfacesGLSL.h"
#include "FlatBlockLinearFilterGLSL.h"
#include "FlatBlockMarchGLSL.h"
#include "FlatBlockMaskGLSL.h"
#include "FlatBlockMaskedGLSL.h"
#include "FlatBlockPostInterpolationGLSL.h"
#include "FlatBlockPreIntegratedGLSL.h"
#include "FlatBlockPreInterpolationGLSL.h"
#include "FlatBlockProgressGLSL.h"
#include "FlatBlockRayCasterFragmentGLSL.h"
#include "FlatBlockRayCasterVertexGLSL.h"
#include "FlatBlockRayGLSL.h"
#include "FlatBlockScatteringGLSL.h"
#include "FlatBlockSelectionGLSL.h"
#include "FlatBlockShadingGLSL.h"
#include "FlatBlockSliceGLSL.h"
#include "FlatBlockSumsGLSL.h"
#include "FlatBlockTransferTableGLSL.h"
#include "FlatBlockTwoDimensionalGLSL.h"
#include "FlatBlockValuePointGLSL.h"
#include "FlatBlockWalkGLSL.h"

#include <string>

namespace flatblock
{
namespace
{
std::string GetClassification(const RaySampling& sampling)
{
  const Classification method = sampling.Method;
  if (!sampling.Blending.IsComposite())
  {
    if (sampling.HasManyValues())
    {
      return std::string(FlatBlockComponentTablesGLSL) + FlatBlockComponentValuesGLSL;
    }
    const bool isMasked = sampling.Mask != MaskKind::None;
    return std::string(isMasked ? FlatBlockMaskGLSL : "") + FlatBlockValuePointGLSL;
  }
  if (sampling.IsTwoDimensional)
  {
    return std::string(FlatBlockClassifiedPointGLSL) + FlatBlockTwoDimensionalGLSL;
  }
  if (sampling.Mask != MaskKind::None)
  {
    return std::string(FlatBlockClassifiedPointGLSL) + FlatBlockMaskGLSL + FlatBlockMaskedGLSL;
  }
  if (sampling.Components > 1)
  {
    return std::string(FlatBlockClassifiedPointGLSL) + FlatBlockComponentTablesGLSL +
           FlatBlockComponentsGLSL;
  }
  if (method == Classification::PreIntegrated)
  {
    return FlatBlockPreIntegratedGLSL;
  }
  return std::string(FlatBlockClassifiedPointGLSL) + (method == Classification::PreInterpolation
                                                         ? FlatBlockPreInterpolationGLSL
                                                         : FlatBlockPostInterpolationGLSL);
}

const char* GetGathering(const RaySampling& sampling)
{
  switch (sampling.Blending.Mode)
  {
  case BlendMode::Maximum:
  case BlendMode::Minimum:
    return FlatBlockExtremesGLSL;
  case BlendMode::Average:
  case BlendMode::Additive:
    return FlatBlockSumsGLSL;
  case BlendMode::Isosurface:
    return FlatBlockIsosurfacesGLSL;
  case BlendMode::Slice:
    return FlatBlockSliceGLSL;
  default:
    return FlatBlockCompositingGLSL;
  }
}

bool IsSpline(const RaySampling& sampling)
{
  return sampling.Filter == ReconstructionFilter::CubicBSpline;
}

bool HasDerivatives(const RaySampling& sampling)
{
  return sampling.IsCurved() || (IsSpline(sampling) && sampling.NeedsGradients());
}

// What the shader calls it.
const char* GetName(CurvatureFunction function)
{
  constexpr const char* Names[] = { "", "firstPrincipal", "secondPrincipal", "meanCurvature",
    "gaussianCurvature", "totalCurvature", "largestMagnitude", "shapeIndex", "curvedness",
    "lineFeature" };
  return Names[static_cast<int>(function)];
}

std::string GetDefines(
  const RaySampling& sampling, const Clipping& clipping, bool hasHoles, bool hasLongSums)
{
  std::string defines;
  const auto define = [&defines](bool isSet, const char* name)
  { defines += isSet ? "#define " + std::string(name) + "\n" : std::string(); };
  define(hasHoles, "FLATBLOCK_HOLES");
  define(hasLongSums, "FLATBLOCK_LONG_SUMS");
  define(sampling.HasBrickRanges, "FLATBLOCK_BRICK_RANGES");
  define(sampling.CellsPerCube > 0, "FLATBLOCK_SKIPPING");
  define(sampling.Jittering, "FLATBLOCK_JITTERING");
  define(sampling.RefinesImage, "FLATBLOCK_ADAPTIVE_IMAGE");
  define(sampling.IsShaded, "FLATBLOCK_SHADING");
  define(sampling.HasNormalsFromOpacity, "FLATBLOCK_NORMAL_FROM_OPACITY");
  define(sampling.HasScattering(), "FLATBLOCK_SCATTERING");
  define(sampling.HasPositionalLights, "FLATBLOCK_POSITIONAL_LIGHTS");
  define(sampling.NeedsGradients(), "FLATBLOCK_GRADIENT");
  define(sampling.GetApron() > 0, "FLATBLOCK_APRON");
  define(IsSpline(sampling), "FLATBLOCK_SPLINE");
  define(HasDerivatives(sampling), "FLATBLOCK_DERIVATIVES");
  define(sampling.IsCurved(), "FLATBLOCK_CURVED");
  if (sampling.Curvature != CurvatureFunction::None)
  {
    defines += std::string("#define FLATBLOCK_CURVATURE ") + GetName(sampling.Curvature) + "\n";
  }
  define(sampling.HasCurvatureOpacity, "FLATBLOCK_CURVATURE_OPACITY");
  define(sampling.SilhouetteWidth > 0.0, "FLATBLOCK_SILHOUETTES");
  define(sampling.HasGradientModulation(), "FLATBLOCK_GRADIENT_MODULATION");
  define(sampling.NeedsMagnitudes(), "FLATBLOCK_GRADIENT_MAGNITUDE");
  define(sampling.HasEagerDerivatives, "FLATBLOCK_EAGER_DERIVATIVES");
  define(sampling.Mask != MaskKind::None, "FLATBLOCK_MASK");
  define(sampling.Mask == MaskKind::Labels, "FLATBLOCK_LABELS");
  const bool isValueFirst = sampling.Mask != MaskKind::None || sampling.HasSecondArray;
  define(sampling.HasSecondArray, "FLATBLOCK_SECOND_ARRAY");
  define(isValueFirst, "FLATBLOCK_VALUE_FIRST");
  define((sampling.Components == 1 || isValueFirst) &&
           (sampling.IsShaded || sampling.HasGradientOpacity || sampling.IsCurved()),
    "FLATBLOCK_MODULATED");
  define(sampling.AreIndependent, "FLATBLOCK_INDEPENDENT");
  if (sampling.Components > 1)
  {
    defines += "#define FLATBLOCK_COMPONENTS " + std::to_string(sampling.Components) + "\n";
  }
  define(sampling.HasGradientTable(), "FLATBLOCK_GRADIENT_TABLE");
  define(sampling.HasGradientOpacity, "FLATBLOCK_GRADIENT_OPACITY");
  define(sampling.HasManyValues(), "FLATBLOCK_MANY_VALUES");
  define(sampling.HasExtremeRanges(), "FLATBLOCK_EXTREMES");
  define(sampling.Blending.Mode == BlendMode::Minimum, "FLATBLOCK_MINIMUM");
  define(sampling.Blending.Mode == BlendMode::Average, "FLATBLOCK_AVERAGE");
  define(sampling.HasCounts(), "FLATBLOCK_COUNTING");
  define(sampling.IsSelection, "FLATBLOCK_SELECTION");
  define(sampling.StaysInImage, "FLATBLOCK_DEPTH_IMAGE");
  define(sampling.IsSelection || sampling.StaysInImage, "FLATBLOCK_SEEN");
  define(sampling.MostSamples > 0, "FLATBLOCK_SAMPLE_LIMIT");
  define(sampling.RayStart > 0.0, "FLATBLOCK_RAY_START");
  if (sampling.Blending.Mode == BlendMode::Isosurface)
  {
    defines +=
      "#define FLATBLOCK_ISOSURFACES " + std::to_string(sampling.Blending.IsoValues.size()) + "\n";
  }
  if (!clipping.Planes.empty())
  {
    defines += "#define FLATBLOCK_CLIPPING_PLANES " + std::to_string(clipping.Planes.size()) + "\n";
  }
  define(clipping.Cropping.has_value(), "FLATBLOCK_CROPPING");
  return defines;
}
} // namespace

vtkShaderProgram* ReadyRayCaster(vtkOpenGLRenderWindow* window, const RaySampling& sampling,
  const Clipping& clipping, bool hasHoles, bool hasLongSums)
{
  std::string fragment = FlatBlockRayCasterFragmentGLSL;
  const auto insert = [&fragment](const char* place, const std::string& source)
  { vtkShaderProgram::Substitute(fragment, place, source); };
  insert("//FlatBlock::Defines", GetDefines(sampling, clipping, hasHoles, hasLongSums));
  insert("//FlatBlock::Counting", FlatBlockCountingGLSL);
  insert("//FlatBlock::Ray", FlatBlockRayGLSL);
  insert("//FlatBlock::Clipping",
    clipping.Planes.empty() && !clipping.Cropping ? "" : FlatBlockClippingGLSL);
  insert("//FlatBlock::AdaptiveImage", sampling.RefinesImage ? FlatBlockAdaptiveImageGLSL : "");
  insert("//FlatBlock::Blocks", FlatBlockBlocksGLSL);
  insert("//FlatBlock::Filter",
    IsSpline(sampling) ? FlatBlockCubicBSplineFilterGLSL : FlatBlockLinearFilterGLSL);
  insert("//FlatBlock::Walk", FlatBlockWalkGLSL);
  insert("//FlatBlock::TransferTable", FlatBlockTransferTableGLSL);
  insert("//FlatBlock::Derivatives", HasDerivatives(sampling) ? FlatBlockDerivativesGLSL : "");
  insert("//FlatBlock::Curvature", sampling.IsCurved() ? FlatBlockCurvatureGLSL : "");
  insert("//FlatBlock::Gradient", sampling.NeedsGradients() ? FlatBlockGradientGLSL : "");
  insert("//FlatBlock::Classification", GetClassification(sampling));
  insert("//FlatBlock::Scattering", sampling.HasScattering() ? FlatBlockScatteringGLSL : "");
  insert("//FlatBlock::Shading", sampling.IsShaded ? FlatBlockShadingGLSL : "");
  const bool isMarched = sampling.Blending.Mode != BlendMode::Slice;
  insert("//FlatBlock::Selection", sampling.IsSelection ? FlatBlockSelectionGLSL : "");
  insert("//FlatBlock::Progress", FlatBlockProgressGLSL);
  insert("//FlatBlock::Gathering", GetGathering(sampling));
  insert("//FlatBlock::March", isMarched ? FlatBlockMarchGLSL : "");
  return window->GetShaderCache()->ReadyShaderProgram(
    FlatBlockRayCasterVertexGLSL, fragment.c_str(), "");
}
} // namespace flatblock
