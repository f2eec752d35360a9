#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockAtlas.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cstdint>

vtkStandardNewMacro(vtkOpenGLFlatBlockAtlas);

namespace
{
constexpr std::size_t StagingBytes = std::size_t(16) << 20;
constexpr int IndexWidth = 4096;
constexpr std::uint16_t NotResident = 0xffff;

struct GLFormat
{
  int VtkType;
  unsigned int Internal;
  unsigned int Type;
};

GLFormat GetGLFormat(flatblock::TexelFormat format)
{
  switch (format)
  {
  case flatblock::TexelFormat::Unsigned8:
    return { VTK_UNSIGNED_CHAR, GL_R8, GL_UNSIGNED_BYTE };
  case flatblock::TexelFormat::Unsigned16:
    return { VTK_UNSIGNED_SHORT, GL_R16, GL_UNSIGNED_SHORT };
  default:
    return { VTK_FLOAT, GL_R32F, GL_FLOAT };
  }
}

void ClearGLErrors()
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
}
} // namespace

vtkOpenGLFlatBlockAtlas::vtkOpenGLFlatBlockAtlas() = default;
vtkOpenGLFlatBlockAtlas::~vtkOpenGLFlatBlockAtlas() = default;

void vtkOpenGLFlatBlockAtlas::SetMemoryCounter(flatblock::MemoryCounter* counter)
{
  this->BrickBytes.SetCounter(counter);
  this->IndexBytes.SetCounter(counter);
}

int vtkOpenGLFlatBlockAtlas::GetLargestTexture(vtkOpenGLRenderWindow* window)
{
  int largest = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  return largest;
}

vtkTypeInt64 vtkOpenGLFlatBlockAtlas::GetIndexBytes(vtkTypeInt64 blocks)
{
  const vtkTypeInt64 width = std::min<vtkTypeInt64>(blocks, IndexWidth);
  return 4 * static_cast<vtkTypeInt64>(sizeof(std::uint16_t)) * width *
         ((blocks + width - 1) / width);
}

bool vtkOpenGLFlatBlockAtlas::Execute(vtkOpenGLRenderWindow* window,
  const flatblock::FramePlan& plan, const flatblock::Residency& residency,
  const flatblock::BrickSource& source)
{
  this->UploadedBytes = 0;
  this->MovedBytes = 0;
  const flatblock::AtlasAllocator& places = residency.GetAtlas();
  if ((plan.NewAtlas &&
        !this->Allocate(window, places.GetTextureSize(), source.GetEncoding().Format)) ||
      (plan.NewPlaces && !this->WriteIndex(window, residency)))
  {
    this->ReleaseGraphicsResources(window);
    return false;
  }
  this->Move(plan.Moves, source.GetEncoding().Format);
  this->Upload(plan.Uploads, places, source);
  return true;
}

bool vtkOpenGLFlatBlockAtlas::Allocate(
  vtkOpenGLRenderWindow* window, const flatblock::Index3& size, flatblock::TexelFormat format)
{
  this->ReleaseGraphicsResources(window);
  const GLFormat gl = GetGLFormat(format);
  this->Bricks->SetContext(window);
  this->Bricks->SetInternalFormat(gl.Internal);
  this->Bricks->SetFormat(GL_RED);
  this->Bricks->SetDataType(gl.Type);
  this->Bricks->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Bricks->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Bricks->SetWrapR(vtkTextureObject::ClampToEdge);
  ClearGLErrors();
  if (!this->Bricks->Allocate3D(size[0], size[1], size[2], 1, gl.VtkType) ||
      glGetError() != GL_NO_ERROR)
  {
    ClearGLErrors();
    return false;
  }
  this->BrickBytes.Set(
    static_cast<std::int64_t>(flatblock::BytesPerTexel(format)) * size[0] * size[1] * size[2]);
  return true;
}

bool vtkOpenGLFlatBlockAtlas::WriteIndex(
  vtkOpenGLRenderWindow* window, const flatblock::Residency& residency)
{
  const std::vector<flatblock::BrickPlace>& places = residency.GetPlaces();
  const int width = static_cast<int>(std::min<std::size_t>(places.size(), IndexWidth));
  const int height = static_cast<int>((places.size() - 1) / width + 1);
  std::vector<std::uint16_t> texels(std::size_t(4) * width * height, 0);
  for (std::size_t block = 0; block < places.size(); ++block)
  {
    std::uint16_t* texel = &texels[4 * block];
    texel[3] = NotResident;
    if (places[block].IsResident())
    {
      const flatblock::Index3 origin = residency.GetAtlas().GetOrigin(places[block]);
      std::copy(origin.begin(), origin.end(), texel);
      texel[3] = static_cast<std::uint16_t>(residency.GetLevels()[block]);
    }
  }
  this->BlockIndex->SetContext(window);
  this->BlockIndex->SetInternalFormat(GL_RGBA16UI);
  this->BlockIndex->SetFormat(GL_RGBA_INTEGER);
  this->BlockIndex->SetDataType(GL_UNSIGNED_SHORT);
  ClearGLErrors();
  const bool created =
    this->BlockIndex->Create2DFromRaw(width, height, 4, VTK_UNSIGNED_SHORT, texels.data());
  const bool failed = glGetError() != GL_NO_ERROR;
  this->IndexBytes.Set(GetIndexBytes(static_cast<vtkTypeInt64>(places.size())));
  ClearGLErrors();
  return created && !failed;
}

bool vtkOpenGLFlatBlockAtlas::CanMove()
{
  return GLEW_ARB_copy_image != 0;
}

void vtkOpenGLFlatBlockAtlas::Move(
  const std::vector<flatblock::BoxMove>& moves, flatblock::TexelFormat format)
{
  const unsigned int atlas = this->Bricks->GetHandle();
  for (const flatblock::BoxMove& move : moves)
  {
    // A copy must not overlap itself: slabs that move by less than their thickness go in slices.
    const int apart = move.From[2] - move.To[2];
    const bool isAside = move.From[0] != move.To[0] || move.From[1] != move.To[1];
    const int slice = isAside || apart <= 0 ? move.Size[2] : std::min(apart, move.Size[2]);
    for (int z = 0; z < move.Size[2]; z += slice)
    {
      glCopyImageSubData(atlas, GL_TEXTURE_3D, 0, move.From[0], move.From[1], move.From[2] + z,
        atlas, GL_TEXTURE_3D, 0, move.To[0], move.To[1], move.To[2] + z, move.Size[0], move.Size[1],
        std::min(slice, move.Size[2] - z));
    }
    this->MovedBytes += static_cast<vtkTypeInt64>(flatblock::BytesPerTexel(format)) * move.Size[0] *
                        move.Size[1] * move.Size[2];
  }
}

void vtkOpenGLFlatBlockAtlas::Upload(const std::vector<flatblock::BrickUpload>& uploads,
  const flatblock::AtlasAllocator& places, const flatblock::BrickSource& source)
{
  if (uploads.empty())
  {
    return;
  }
  const flatblock::TexelFormat format = source.GetEncoding().Format;
  const flatblock::BlockGrid& grid = source.GetGrid();
  const auto bytesOf = [&grid, format](const flatblock::BrickUpload& upload)
  {
    const std::size_t side = grid.GetBrickSide(upload.Level);
    return flatblock::BytesPerTexel(format) * side * side * side;
  };
  this->Bricks->Activate();
  vtkOpenGLState* state = this->Bricks->GetContext()->GetState();
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  std::vector<std::uint8_t> staging;
  std::vector<std::size_t> offsets;
  for (std::size_t first = 0; first < uploads.size(); first += offsets.size())
  {
    offsets.clear();
    std::size_t bytes = 0;
    for (std::size_t i = first; i < uploads.size() && (i == first || bytes < StagingBytes); ++i)
    {
      offsets.push_back(bytes);
      bytes += bytesOf(uploads[i]);
    }
    staging.resize(std::max(staging.size(), bytes));
    const auto count = static_cast<std::int64_t>(offsets.size());
#pragma omp parallel for schedule(dynamic)
    for (std::int64_t i = 0; i < count; ++i)
    {
      const flatblock::BrickUpload& upload = uploads[first + i];
      source.ReadBrick(upload.Block, upload.Level, upload.Border, &staging[offsets[i]]);
    }
    for (std::int64_t i = 0; i < count; ++i)
    {
      const flatblock::BrickUpload& upload = uploads[first + i];
      const flatblock::Index3 origin = places.GetOrigin(upload.Place);
      const int side = grid.GetBrickSide(upload.Level);
      glTexSubImage3D(GL_TEXTURE_3D, 0, origin[0], origin[1], origin[2], side, side, side, GL_RED,
        GetGLFormat(format).Type, &staging[offsets[i]]);
    }
    this->UploadedBytes += static_cast<vtkTypeInt64>(bytes);
  }
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  this->Bricks->Deactivate();
}

bool vtkOpenGLFlatBlockAtlas::IsAllocated() const
{
  return this->Bricks->GetHandle() != 0 && this->BlockIndex->GetHandle() != 0;
}

void vtkOpenGLFlatBlockAtlas::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Bricks->ReleaseGraphicsResources(window);
  this->BlockIndex->ReleaseGraphicsResources(window);
  this->BrickBytes.Set(0);
  this->IndexBytes.Set(0);
  this->UploadedBytes = 0;
  this->MovedBytes = 0;
}

void vtkOpenGLFlatBlockAtlas::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bytes: " << this->GetBytes() << "\n";
  os << indent << "UploadedBytes: " << this->UploadedBytes << "\n";
  os << indent << "MovedBytes: " << this->MovedBytes << "\n";
}
