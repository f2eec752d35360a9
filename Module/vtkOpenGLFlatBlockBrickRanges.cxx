#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockBrickRanges.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <cstddef>

vtkStandardNewMacro(vtkOpenGLFlatBlockBrickRanges);

namespace
{
constexpr vtkTypeInt64 Width = 4096; // as wide as textures may be everywhere

std::array<vtkTypeInt64, 2> GetSize(vtkTypeInt64 blocks)
{
  const vtkTypeInt64 width = std::min(blocks, Width);
  return { width, (blocks + width - 1) / width };
}
} // namespace

vtkTypeInt64 vtkOpenGLFlatBlockBrickRanges::GetBytes(vtkTypeInt64 blocks)
{
  const auto size = GetSize(blocks);
  return static_cast<vtkTypeInt64>(sizeof(flatblock::TexelRange)) * size[0] * size[1];
}

bool vtkOpenGLFlatBlockBrickRanges::Upload(
  vtkOpenGLRenderWindow* window, const std::vector<flatblock::TexelRange>& ranges)
{
  const auto size = GetSize(static_cast<vtkTypeInt64>(ranges.size()));
  std::vector<flatblock::TexelRange> texels = ranges;
  texels.resize(static_cast<std::size_t>(size[0] * size[1]));
  return this->Create(window, GetBytes(static_cast<vtkTypeInt64>(ranges.size())),
    [&]
    {
      this->Texture->SetInternalFormat(GL_RG32F);
      return this->Texture->Create2DFromRaw(static_cast<unsigned int>(size[0]),
        static_cast<unsigned int>(size[1]), 2, VTK_FLOAT, texels.data());
    });
}

void vtkOpenGLFlatBlockBrickRanges::Activate(vtkShaderProgram* program)
{
  this->Texture->Activate();
  program->SetUniformi("in_BrickRanges", this->Texture->GetTextureUnit());
}
