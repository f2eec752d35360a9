#include "vtkFlatBlockRayCastMapper.h"

#include <algorithm>
#include <cmath>

// Presets of vtkFlatBlockRayCastMapper: points of the front that `flatblock-bench` draws.

namespace
{
struct Preset
{
  int Classification;
  double VoxelsAStep;
  double PixelsARay;
  double EnoughOpacity;
  double LeastLitOpacity;
};

constexpr Preset Interactive = { vtkFlatBlockRayCastMapper::POST_INTERPOLATION, 1.0, 2.0,
  1.0 - 1.0 / 64.0, 1.0 / 255.0 };
constexpr Preset Balanced = { vtkFlatBlockRayCastMapper::POST_INTERPOLATION, 0.5, 1.0,
  1.0 - 1.0 / 255.0, 1.0 / 1024.0 };
constexpr Preset Accurate = { vtkFlatBlockRayCastMapper::PRE_INTEGRATED, 0.25, 1.0,
  1.0 - 1.0 / 1024.0, 0.0 };
constexpr Preset Reference = { vtkFlatBlockRayCastMapper::PRE_INTEGRATED, 0.125, 1.0, 1.0, 0.0 };

// By how much coarser interactive frames are, and the lowest PSNR of the benchmark's scenes.
constexpr double Expected[][2] = { { 1.0, 54.0 }, { 2.0, 26.0 }, { 4.0, 20.0 }, { 8.0, 16.0 } };

void Apply(const Preset& preset, vtkFlatBlockRayCastMapper* mapper)
{
  mapper->SetClassification(preset.Classification);
  mapper->SetSampleDistance(0.0);
  mapper->SetSampleDistanceInVoxels(preset.VoxelsAStep);
  mapper->LockSampleDistanceToInputSpacingOff();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(preset.PixelsARay);
  mapper->SetEarlyTerminationThreshold(preset.EnoughOpacity);
  mapper->SetShadingOpacityThreshold(preset.LeastLitOpacity);
  mapper->SetVariationTolerance(0.0);
  mapper->SetAtlasPrecisionToNative();
  mapper->SetMaximumNumberOfSamples(0);
}
} // namespace

void vtkFlatBlockRayCastMapper::SetQualityToInteractive()
{
  Apply(Interactive, this);
}

void vtkFlatBlockRayCastMapper::SetQualityToBalanced()
{
  Apply(Balanced, this);
}

void vtkFlatBlockRayCastMapper::SetQualityToAccurate()
{
  Apply(Accurate, this);
}

void vtkFlatBlockRayCastMapper::SetQualityToReference()
{
  Apply(Reference, this);
}

void vtkFlatBlockRayCastMapper::SetQualityToAutomatic()
{
  Apply(Accurate, this);
  this->SetMinimumImageSampleDistance(1.0);
  this->SetMaximumImageSampleDistance(10.0);
  this->AutoAdjustSampleDistancesOn();
}

double vtkFlatBlockRayCastMapper::GetExpectedPSNR(double coarser)
{
  constexpr int Last = static_cast<int>(sizeof(Expected) / sizeof(Expected[0])) - 1;
  const double place = std::clamp(std::log2(std::max(coarser, 1.0)), 0.0, double(Last));
  const int first = std::min(static_cast<int>(place), Last - 1);
  return Expected[first][1] + (place - first) * (Expected[first + 1][1] - Expected[first][1]);
}
