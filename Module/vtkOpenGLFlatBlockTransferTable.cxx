#include "vtkOpenGLFlatBlockTransferTable.h"

#include "TransferIntegrals.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <vector>

vtkStandardNewMacro(vtkOpenGLFlatBlockTransferTable);

namespace
{
int GetTexelsPerEntry(bool hasIntegrals)
{
  return hasIntegrals ? flatblock::TransferTexels : 1;
}
} // namespace

vtkOpenGLFlatBlockTransferTable::vtkOpenGLFlatBlockTransferTable() = default;
vtkOpenGLFlatBlockTransferTable::~vtkOpenGLFlatBlockTransferTable() = default;

vtkTypeInt64 vtkOpenGLFlatBlockTransferTable::GetBytes(
  const flatblock::TransferTable& table, bool hasIntegrals)
{
  const auto entries = static_cast<vtkTypeInt64>(table.GetEntries().size());
  const auto bytesPerTexel = static_cast<vtkTypeInt64>(sizeof(flatblock::TransferTable::Entry));
  return entries * GetTexelsPerEntry(hasIntegrals) * bytesPerTexel;
}

void vtkOpenGLFlatBlockTransferTable::Upload(
  vtkOpenGLRenderWindow* window, const flatblock::TransferTable& table, bool hasIntegrals)
{
  static_assert(sizeof(flatblock::TransferTable::Entry) == 4 * sizeof(float));
  const std::vector<flatblock::TransferTable::Entry> texels =
    hasIntegrals ? flatblock::IntegrateTransferTable(table) : table.GetEntries();
  this->Texture->SetContext(window);
  this->Buffer->Upload(texels, vtkOpenGLBufferObject::TextureBuffer);
  this->Texture->CreateTextureBuffer(
    static_cast<unsigned int>(texels.size()), 4, VTK_FLOAT, this->Buffer);
  this->Bytes.Set(GetBytes(table, hasIntegrals));
  this->HasIntegrals = hasIntegrals;
  this->Lowest = table.GetLowest();
  this->Highest = table.GetHighest();
  this->Entries = static_cast<int>(table.GetEntries().size());
  this->TotalDepth = hasIntegrals ? texels[texels.size() - flatblock::TransferTexels + 1][3] : 0.0;
}

bool vtkOpenGLFlatBlockTransferTable::NeedsLongSums(double length) const
{
  constexpr double FloatRounding = 6e-8;
  constexpr double LargestError = 5e-5; // of an optical depth
  return this->TotalDepth * length * FloatRounding > LargestError;
}

bool vtkOpenGLFlatBlockTransferTable::IsUploaded(bool hasIntegrals) const
{
  return this->Texture->GetHandle() != 0 && this->HasIntegrals == hasIntegrals;
}

// A texel t is the value offset + scale * t.
void vtkOpenGLFlatBlockTransferTable::Activate(
  vtkShaderProgram* program, const flatblock::TexelEncoding& texels)
{
  const double span = this->Highest - this->Lowest;
  const double entriesPerValue = span > 0.0 ? (this->Entries - 1) / span : 0.0;
  const float texelToTable[2] = { static_cast<float>(texels.Scale * entriesPerValue),
    static_cast<float>((texels.Offset - this->Lowest) * entriesPerValue) };
  this->Texture->Activate();
  program->SetUniformi("in_TransferTable", this->Texture->GetTextureUnit());
  program->SetUniformi("in_TexelsPerEntry", GetTexelsPerEntry(this->HasIntegrals));
  program->SetUniformf("in_LastEntry", static_cast<float>(this->Entries - 1));
  program->SetUniform2f("in_TexelToTable", texelToTable);
}

void vtkOpenGLFlatBlockTransferTable::Deactivate()
{
  this->Texture->Deactivate();
}

void vtkOpenGLFlatBlockTransferTable::ReleaseIfStale(
  vtkWindow* window, const flatblock::TransferTable& table, bool hasIntegrals)
{
  if (this->Bytes.Get() != GetBytes(table, hasIntegrals))
  {
    this->ReleaseGraphicsResources(window);
  }
}

void vtkOpenGLFlatBlockTransferTable::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
  this->Bytes.Set(0);
}

void vtkOpenGLFlatBlockTransferTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Range: " << this->Lowest << " " << this->Highest << "\n";
  os << indent << "Entries: " << this->Entries << "\n";
  os << indent << "HasIntegrals: " << this->HasIntegrals << "\n";
}
