#include "vtkFlatBlockVolumeRepresentation.h"

#include "vtkAlgorithm.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFlatBlockVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

vtkStandardNewMacro(vtkFlatBlockVolumeRepresentation);

namespace
{
vtkFlatBlockVolumeMapper* AsFlatBlockMapper(vtkVolumeMapper* mapper)
{
  return static_cast<vtkFlatBlockVolumeMapper*>(mapper);
}

vtkDataArray* FindArray(vtkDataObject* data)
{
  auto* image = vtkImageData::SafeDownCast(data);
  if (!image)
  {
    return nullptr;
  }
  vtkPointData* arrays = image->GetPointData();
  return arrays->GetScalars() ? arrays->GetScalars() : arrays->GetArray(0);
}

// From transparent black to opaque white over the array's range.
void ShowInGray(vtkDataArray* array, vtkVolumeProperty* property)
{
  double range[2];
  array->GetFiniteRange(range);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(range[0], 0.0, 0.0, 0.0);
  color->AddRGBPoint(range[1], 1.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(range[0], 0.0);
  opacity->AddPoint(range[1], 1.0);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
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
  const char* name =
    chosen->Has(vtkDataObject::FIELD_NAME()) ? chosen->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  vtkDataArray* found = name && *name ? nullptr : FindArray(this->Cache);
  if (!found)
  {
    this->Actor->SetProperty(this->Property);
    return;
  }
  if (found != this->ShownInGray || found->GetMTime() > this->GrayProperty->GetMTime())
  {
    ShowInGray(found, this->GrayProperty);
    this->ShownInGray = found;
  }
  this->GrayProperty->SetScalarOpacityUnitDistance(this->Property->GetScalarOpacityUnitDistance());
  this->GrayProperty->SetInterpolationType(this->Property->GetInterpolationType());
  this->Actor->SetProperty(this->GrayProperty);
  this->VolumeMapper->SelectScalarArray(found->GetName());
  this->VolumeMapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  this->Actor->SetVisibility(true);
}

void vtkFlatBlockVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->VolumeMapper->PrintSelf(os, indent.GetNextIndent());
}
