#include "FlatBlockRayLookups.h"

#include "vtkOpenGLRenderWindow.h"

namespace flatblock
{
namespace
{
bool NeedsIntegrals(const RaySampling& sampling)
{
  return sampling.Method == Classification::PreIntegrated;
}
} // namespace

RayLookups::RayLookups()
{
  this->Functions[OF_GRADIENTS]->SetName("in_GradientTable");
  this->Functions[OF_CURVATURE]->SetName("in_CurvatureTable");
}

RayLookups::~RayLookups() = default;

void RayLookups::SetMemoryCounter(MemoryCounter* counter)
{
  this->TransferTable->SetMemoryCounter(counter);
  this->SkipTexture->SetMemoryCounter(counter);
  this->BrickRanges->SetMemoryCounter(counter);
  for (const auto& function : this->Functions)
  {
    function->SetMemoryCounter(counter);
  }
}

void RayLookups::ReleaseStale(vtkWindow* window, const ComponentTables& tables,
  const LookupBytes& bytes, const RaySampling& sampling)
{
  this->SkipTexture->ReleaseIfStale(window, bytes.SkipMap);
  this->Functions[OF_GRADIENTS]->ReleaseIfStale(window, bytes.OfGradients);
  this->Functions[OF_CURVATURE]->ReleaseIfStale(window, bytes.OfCurvature);
  this->BrickRanges->ReleaseIfStale(window, bytes.BrickRanges);
  this->TransferTable->ReleaseIfStale(window, tables, NeedsIntegrals(sampling));
}

vtkTypeInt64 RayLookups::GetTableBytes(const ComponentTables& tables, const RaySampling& sampling)
{
  return vtkOpenGLFlatBlockTransferTable::GetBytes(tables, NeedsIntegrals(sampling));
}

bool RayLookups::SetTransferTable(
  vtkOpenGLRenderWindow* window, const ComponentTables& tables, const RaySampling& sampling)
{
  return this->TransferTable->Upload(window, tables, NeedsIntegrals(sampling));
}

bool RayLookups::HasTransferTable(const RaySampling& sampling) const
{
  return this->TransferTable->IsUploaded(NeedsIntegrals(sampling));
}

bool RayLookups::SetSkipMap(
  vtkOpenGLRenderWindow* window, const SkipMap& map, const RaySampling& sampling)
{
  return this->SkipTexture->Upload(window, map, sampling.CellsPerCube);
}

bool RayLookups::HasSkipMap() const
{
  return this->SkipTexture->IsUploaded();
}

bool RayLookups::SetBrickRanges(
  vtkOpenGLRenderWindow* window, const std::vector<TexelRange>& ranges)
{
  this->BrickRanges->ReleaseGraphicsResources(window);
  return ranges.empty() || this->BrickRanges->Upload(window, ranges);
}

bool RayLookups::HasBrickRanges() const
{
  return this->BrickRanges->IsUploaded();
}

bool RayLookups::SetFunction(
  vtkOpenGLRenderWindow* window, Function function, const FunctionTable& table)
{
  this->Functions[function]->ReleaseGraphicsResources(window);
  return table.IsEmpty() || this->Functions[function]->Upload(window, table);
}

bool RayLookups::HasFunction(Function function) const
{
  return this->Functions[function]->IsUploaded();
}

bool RayLookups::NeedsLongSums(const RaySampling& sampling) const
{
  return this->TransferTable->NeedsLongSums(sampling.Step / sampling.UnitOfLength);
}

void RayLookups::Activate(
  vtkShaderProgram* program, const ComponentTables& tables, const RaySampling& sampling)
{
  this->TransferTable->Activate(program, tables);
  if (sampling.HasGradientTable())
  {
    this->Functions[OF_GRADIENTS]->Activate(program);
  }
  if (sampling.Curvature != CurvatureFunction::None)
  {
    this->Functions[OF_CURVATURE]->Activate(program);
  }
  if (sampling.UsesRanges())
  {
    this->BrickRanges->Activate(program);
  }
  if (sampling.CellsPerCube > 0)
  {
    this->SkipTexture->Activate(program);
  }
}

void RayLookups::Deactivate()
{
  this->TransferTable->Deactivate();
  this->SkipTexture->Deactivate();
  this->BrickRanges->Deactivate();
  for (const auto& function : this->Functions)
  {
    function->Deactivate();
  }
}

void RayLookups::ReleaseGraphicsResources(vtkWindow* window)
{
  this->TransferTable->ReleaseGraphicsResources(window);
  this->SkipTexture->ReleaseGraphicsResources(window);
  this->BrickRanges->ReleaseGraphicsResources(window);
  for (const auto& function : this->Functions)
  {
    function->ReleaseGraphicsResources(window);
  }
}

void RayLookups::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "TransferTable:\n";
  this->TransferTable->PrintSelf(os, indent.GetNextIndent());
}
} // namespace flatblock
