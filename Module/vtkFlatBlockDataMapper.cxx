#include "vtkFlatBlockDataMapper.h"

vtkFlatBlockDataMapper::vtkFlatBlockDataMapper() = default;
vtkFlatBlockDataMapper::~vtkFlatBlockDataMapper() = default;

void vtkFlatBlockDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const modes[] = { "Disabled", "Magnitude", "Component" };
  os << indent << "VectorMode: " << modes[this->VectorMode - DISABLED] << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
}
