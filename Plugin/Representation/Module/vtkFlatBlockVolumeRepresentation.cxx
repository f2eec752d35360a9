#include "vtkFlatBlockVolumeRepresentation.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFlatBlockVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPointData.h"

vtkStandardNewMacro(vtkFlatBlockVolumeRepresentation);

namespace
{
vtkFlatBlockVolumeMapper* AsFlatBlockMapper(vtkVolumeMapper* mapper)
{
  return static_cast<vtkFlatBlockVolumeMapper*>(mapper);
}

const char* FindArray(vtkDataObject* data)
{
  auto* image = vtkImageData::SafeDownCast(data);
  if (!image)
  {
    return nullptr;
  }
  vtkPointData* arrays = image->GetPointData();
  vtkDataArray* array = arrays->GetScalars() ? arrays->GetScalars() : arrays->GetArray(0);
  return array ? array->GetName() : nullptr;
}
} // namespace

vtkFlatBlockVolumeRepresentation::vtkFlatBlockVolumeRepresentation()
{
  this->VolumeMapper = vtkSmartPointer<vtkFlatBlockVolumeMapper>::New();
}

vtkFlatBlockVolumeRepresentation::~vtkFlatBlockVolumeRepresentation() = default;

int vtkFlatBlockVolumeRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkFlatBlockVolumeRepresentation::SetBlockSize(int samples)
{
  AsFlatBlockMapper(this->VolumeMapper)->SetBlockSize(samples);
}

void vtkFlatBlockVolumeRepresentation::SetSampleDistance(double distance)
{
  AsFlatBlockMapper(this->VolumeMapper)->SetSampleDistance(distance);
}

void vtkFlatBlockVolumeRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  vtkInformation* chosen = this->GetInputArrayInformation(0);
  const char* name = chosen->Has(vtkDataObject::FIELD_NAME())
    ? chosen->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  if (name && *name)
  {
    return;
  }
  if (const char* found = FindArray(this->Cache))
  {
    this->VolumeMapper->SelectScalarArray(found);
    this->VolumeMapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
    this->Actor->SetVisibility(true);
  }
}

void vtkFlatBlockVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->VolumeMapper->PrintSelf(os, indent.GetNextIndent());
}
