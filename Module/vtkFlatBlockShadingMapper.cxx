#include "vtkFlatBlockShadingMapper.h"

vtkFlatBlockShadingMapper::vtkFlatBlockShadingMapper() = default;
vtkFlatBlockShadingMapper::~vtkFlatBlockShadingMapper() = default;

void vtkFlatBlockShadingMapper::ShallowCopy(vtkAbstractMapper* other)
{
  if (auto* mapper = vtkFlatBlockShadingMapper::SafeDownCast(other))
  {
    this->SetShadingOpacityThreshold(mapper->ShadingOpacityThreshold);
    this->SetComputeNormalFromOpacity(mapper->ComputeNormalFromOpacity);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
    this->SetVolumetricScatteringBlending(mapper->VolumetricScatteringBlending);
    this->SetGlobalIlluminationReach(mapper->GlobalIlluminationReach);
#endif
  }
  this->Superclass::ShallowCopy(other);
}

void vtkFlatBlockShadingMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShadingOpacityThreshold: " << this->ShadingOpacityThreshold << "\n";
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  os << indent << "ComputeNormalFromOpacity: " << this->ComputeNormalFromOpacity << "\n";
#else
  os << indent << "VolumetricScatteringBlending: " << this->VolumetricScatteringBlending << "\n";
  os << indent << "GlobalIlluminationReach: " << this->GlobalIlluminationReach << "\n";
#endif
}
