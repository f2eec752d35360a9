#include "vtkFlatBlockRayCastMapper.h"

vtkFlatBlockRayCastMapper::vtkFlatBlockRayCastMapper() = default;
vtkFlatBlockRayCastMapper::~vtkFlatBlockRayCastMapper() = default;

void vtkFlatBlockRayCastMapper::SetAtlasPrecision(int precision)
{
  if (precision != NATIVE && precision != BITS_8 && precision != BITS_4 && precision != BITS_1)
  {
    vtkErrorMacro(<< "AtlasPrecision is 0 (native), 8, 4 or 1 bits, not " << precision << ".");
    return;
  }
  if (this->AtlasPrecision != precision)
  {
    this->AtlasPrecision = precision;
    this->Modified();
  }
}

void vtkFlatBlockRayCastMapper::ShallowCopy(vtkAbstractMapper* other)
{
  if (auto* mapper = vtkFlatBlockRayCastMapper::SafeDownCast(other))
  {
    this->SetClassification(mapper->Classification);
    this->SetSampleDistance(mapper->SampleDistance);
    this->SetSampleDistanceInVoxels(mapper->SampleDistanceInVoxels);
    this->SetFrameTimeGoal(mapper->FrameTimeGoal);
    this->SetAdaptiveImageSampling(mapper->AdaptiveImageSampling);
    this->SetImageSamplingTolerance(mapper->ImageSamplingTolerance);
    this->SetAutoAdjustSampleDistances(mapper->AutoAdjustSampleDistances);
    this->SetLockSampleDistanceToInputSpacing(mapper->LockSampleDistanceToInputSpacing);
    this->SetImageSampleDistance(mapper->ImageSampleDistance);
    this->SetMinimumImageSampleDistance(mapper->MinimumImageSampleDistance);
    this->SetMaximumImageSampleDistance(mapper->MaximumImageSampleDistance);
    this->SetUseJittering(mapper->UseJittering);
    this->SetAdaptiveSampling(mapper->AdaptiveSampling);
    this->SetMaximumNumberOfSamples(mapper->MaximumNumberOfSamples);
    this->SetRayStartOffset(mapper->RayStartOffset);
    this->SetEarlyTerminationThreshold(mapper->EarlyTerminationThreshold);
    this->SetSkipping(mapper->Skipping);
    this->SetHomogeneousLeaps(mapper->HomogeneousLeaps);
    this->SetAtlasPrecision(mapper->AtlasPrecision);
    this->SetVariationTolerance(mapper->VariationTolerance);
    this->SetProfiling(mapper->Profiling);
    this->SetCountSamples(mapper->CountSamples);
  }
  this->Superclass::ShallowCopy(other);
}

void vtkFlatBlockRayCastMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const classifications[] = { "PreIntegrated", "PostInterpolation",
    "PreInterpolation" };
  os << indent << "Classification: " << classifications[this->Classification] << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "LockSampleDistanceToInputSpacing: " << this->LockSampleDistanceToInputSpacing
     << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "AdaptiveSampling: " << this->AdaptiveSampling << "\n";
  os << indent << "MaximumNumberOfSamples: " << this->MaximumNumberOfSamples << "\n";
  os << indent << "RayStartOffset: " << this->RayStartOffset << "\n";
  os << indent << "EarlyTerminationThreshold: " << this->EarlyTerminationThreshold << "\n";
  const char* const skippings[] = { "Nothing", "Blocks", "Cells" };
  os << indent << "Skipping: " << skippings[this->Skipping] << "\n";
  os << indent << "HomogeneousLeaps: " << this->HomogeneousLeaps << "\n";
  os << indent << "AtlasPrecision: " << this->AtlasPrecision << "\n";
  os << indent << "SampleDistanceInVoxels: " << this->SampleDistanceInVoxels << "\n";
  os << indent << "AdaptiveImageSampling: " << this->AdaptiveImageSampling << "\n";
  os << indent << "ImageSamplingTolerance: " << this->ImageSamplingTolerance << "\n";
  os << indent << "FrameTimeGoal: " << this->FrameTimeGoal << "\n";
  os << indent << "VariationTolerance: " << this->VariationTolerance << "\n";
  os << indent << "Profiling: " << this->Profiling << "\n";
  os << indent << "CountSamples: " << this->CountSamples << "\n";
}
