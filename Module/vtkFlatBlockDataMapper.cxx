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
