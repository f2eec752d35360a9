#include "vtkFlatBlockDataMapper.h"

vtkFlatBlockDataMapper::vtkFlatBlockDataMapper() = default;
vtkFlatBlockDataMapper::~vtkFlatBlockDataMapper()
{
  delete[] this->Transfer2DYAxisArray;
}

void vtkFlatBlockDataMapper::SetMaskInput(vtkImageData* mask)
{
  if (this->MaskInput != mask)
  {
    this->MaskInput = mask;
    this->Modified();
  }
}

void vtkFlatBlockDataMapper::ShallowCopy(vtkAbstractMapper* other)
{
  if (auto* mapper = vtkFlatBlockDataMapper::SafeDownCast(other))
  {
    this->SetBlendMode(mapper->BlendMode);
    this->SetAverageIPScalarRange(mapper->AverageIPScalarRange);
    this->SetCropping(mapper->Cropping);
    this->SetCroppingRegionPlanes(mapper->CroppingRegionPlanes);
    this->SetCroppingRegionFlags(mapper->CroppingRegionFlags);
    this->SetScalarMode(mapper->ScalarMode);
    this->SetArrayAccessMode(mapper->ArrayAccessMode);
    this->SetVectorMode(mapper->VectorMode);
    this->SetVectorComponent(mapper->VectorComponent);
    this->SetTransfer2DYAxisArray(mapper->Transfer2DYAxisArray);
    this->SetMaskInput(mapper->MaskInput);
    this->SetMaskType(mapper->MaskType);
    this->SetMaskBlendFactor(mapper->MaskBlendFactor);
    this->SetRenderToImage(mapper->RenderToImage);
    if (mapper->ArrayAccessMode == VTK_GET_ARRAY_BY_ID)
    {
      this->SelectScalarArray(mapper->ArrayId);
    }
    else
    {
      this->SelectScalarArray(mapper->ArrayName);
    }
  }
  this->Superclass::ShallowCopy(other);
}

void vtkFlatBlockDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const modes[] = { "Disabled", "Magnitude", "Component" };
  os << indent << "VectorMode: " << modes[this->VectorMode - DISABLED] << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "Transfer2DYAxisArray: "
     << (this->Transfer2DYAxisArray ? this->Transfer2DYAxisArray : "(none)") << "\n";
  os << indent << "MaskInput: " << this->MaskInput << "\n";
  os << indent << "MaskType: " << (this->MaskType == BinaryMaskType ? "Binary" : "LabelMap")
     << "\n";
  os << indent << "RenderToImage: " << this->RenderToImage << "\n";
  os << indent << "MaskBlendFactor: " << this->MaskBlendFactor << "\n";
}
