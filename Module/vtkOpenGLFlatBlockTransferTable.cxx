#include "vtk_glew.h"

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
  const flatblock::ComponentTables& tables, bool hasIntegrals)
{
  const auto bytesPerTexel = static_cast<vtkTypeInt64>(sizeof(flatblock::TransferTable::Entry));
  vtkTypeInt64 entries = 0;
  for (const flatblock::ComponentTable& component : tables)
  {
    entries += static_cast<vtkTypeInt64>(component.Table->GetEntries().size());
  }
  return entries * GetTexelsPerEntry(hasIntegrals) * bytesPerTexel;
}

bool vtkOpenGLFlatBlockTransferTable::Upload(
  vtkOpenGLRenderWindow* window, const flatblock::ComponentTables& tables, bool hasIntegrals)
{
  static_assert(sizeof(flatblock::TransferTable::Entry) == 4 * sizeof(float));
  std::vector<flatblock::TransferTable::Entry> texels;
  for (const flatblock::ComponentTable& component : tables)
  {
    const std::vector<flatblock::TransferTable::Entry> own =
      hasIntegrals ? flatblock::IntegrateTransferTable(*component.Table)
                   : component.Table->GetEntries();
    texels.insert(texels.end(), own.begin(), own.end());
  }
  int mostTexels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &mostTexels);
  if (texels.size() > static_cast<std::size_t>(mostTexels))
  {
    return false;
  }
  this->Texture->SetContext(window);
  this->Buffer->Upload(texels, vtkOpenGLBufferObject::TextureBuffer);
  this->Texture->CreateTextureBuffer(
    static_cast<unsigned int>(texels.size()), 4, VTK_FLOAT, this->Buffer);
  this->Bytes.Set(GetBytes(tables, hasIntegrals));
  this->HasIntegrals = hasIntegrals;
  this->TotalDepth = hasIntegrals ? texels[texels.size() - flatblock::TransferTexels + 1][3] : 0.0;
  return true;
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

void vtkOpenGLFlatBlockTransferTable::Activate(
  vtkShaderProgram* program, const flatblock::ComponentTables& tables)
{
  const flatblock::ComponentTable& first = tables.front();
  const std::array<double, 2> line = flatblock::GetTexelToTable(first);
  const float texelToTable[2] = { static_cast<float>(line[0]), static_cast<float>(line[1]) };
  this->Texture->Activate();
  program->SetUniformi("in_TransferTable", this->Texture->GetTextureUnit());
  program->SetUniformi("in_TexelsPerEntry", GetTexelsPerEntry(this->HasIntegrals));
  program->SetUniformf("in_LastEntry", static_cast<float>(first.Table->GetEntries().size() - 1));
  program->SetUniform2f("in_TexelToTable", texelToTable);
}

void vtkOpenGLFlatBlockTransferTable::Deactivate()
{
  this->Texture->Deactivate();
}

void vtkOpenGLFlatBlockTransferTable::ReleaseIfStale(
  vtkWindow* window, const flatblock::ComponentTables& tables, bool hasIntegrals)
{
  if (this->Bytes.Get() != GetBytes(tables, hasIntegrals))
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
  os << indent << "Bytes: " << this->Bytes.Get() << "\n";
  os << indent << "HasIntegrals: " << this->HasIntegrals << "\n";
}
