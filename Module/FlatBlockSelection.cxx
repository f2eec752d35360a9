#include "FlatBlockSelection.h"

#include "FlatBlockVolumeInput.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace flatblock
{
namespace
{
// Samples are points, or cells with one more around on each side.
void SetIds(const VolumeInput& input, bool areCells, Selection& selection)
{
  input.Image->GetDimensions(selection.Ids.data());
  float shift = areCells ? 0.0F : 0.5F;
  if (input.IsCellData)
  {
    shift -= 0.5F;
  }
  selection.SampleToId.fill(shift);
  for (int& ids : selection.Ids)
  {
    ids -= areCells ? 1 : 0;
  }
}
} // namespace

SelectorGuard::SelectorGuard(vtkHardwareSelector* selector) : Selector(selector)
{
  if (this->Selector)
  {
    this->Selector->BeginRenderProp();
  }
}

SelectorGuard::~SelectorGuard()
{
  if (this->Selector)
  {
    this->Selector->EndRenderProp();
  }
}

std::optional<Selection> GetSelection(vtkRenderer* renderer, const VolumeInput& input)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  const bool areCells = selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  Selection selection;
  SetIds(input, areCells, selection);
  selector->UpdateMaximumCellId(input.Image->GetNumberOfCells());
  selector->UpdateMaximumPointId(input.Image->GetNumberOfPoints());
  std::copy_n(selector->GetPropColorValue(), 3, selection.PropColor.begin());
  switch (selector->GetCurrentPass())
  {
  case vtkHardwareSelector::ACTOR_PASS:
  case vtkHardwareSelector::PROCESS_PASS:
    selection.Bits = Selection::Pass::Prop;
    return selection;
  case vtkHardwareSelector::POINT_ID_LOW24:
  case vtkHardwareSelector::CELL_ID_LOW24:
    selection.Bits = Selection::Pass::Low;
    return selection;
  case vtkHardwareSelector::POINT_ID_HIGH24:
  case vtkHardwareSelector::CELL_ID_HIGH24:
    selection.Bits = Selection::Pass::High;
    return selection;
  default:
    return std::nullopt;
  }
}

void SetSelection(vtkShaderProgram* program, const Selection& selection)
{
  program->SetUniformi("in_SelectionPass", static_cast<int>(selection.Bits));
  program->SetUniform3f("in_PropColor", selection.PropColor.data());
  if (selection.Bits != Selection::Pass::Prop)
  {
    program->SetUniform3f("in_SampleToId", selection.SampleToId.data());
    program->SetUniform1iv("in_Ids", 3, selection.Ids.data());
  }
}
} // namespace flatblock
