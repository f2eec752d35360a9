#include "vtk_glew.h"

#include "vtkOpenGLFlatBlockAtlas.h"

#include "FlatBlockGLErrors.h"
#include "Interruption.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

vtkStandardNewMacro(vtkOpenGLFlatBlockAtlas);

namespace
{
constexpr std::size_t StagingBytes = std::size_t(4) << 20; // what caches hold
constexpr int IndexWidth = 4096;
constexpr std::uint16_t NotResident = 0xffff;

struct GLFormat
{
  int VtkType;
  unsigned int Internal;
  unsigned int Format;
  unsigned int Type;
};

GLFormat GetGLFormat(const flatblock::TexelEncoding& encoding)
{
  const int i = encoding.Components == 1 ? 0 : (encoding.Components == 2 ? 1 : 2);
  constexpr unsigned int Formats[] = { GL_RED, GL_RG, GL_RGBA };
  constexpr unsigned int Bytes[] = { GL_R8, GL_RG8, GL_RGBA8 };
  constexpr unsigned int Shorts[] = { GL_R16, GL_RG16, GL_RGBA16 };
  constexpr unsigned int Floats[] = { GL_R32F, GL_RG32F, GL_RGBA32F };
  switch (encoding.Format)
  {
  case flatblock::TexelFormat::Unsigned8:
    return { VTK_UNSIGNED_CHAR, Bytes[i], Formats[i], GL_UNSIGNED_BYTE };
  case flatblock::TexelFormat::Unsigned16:
    return { VTK_UNSIGNED_SHORT, Shorts[i], Formats[i], GL_UNSIGNED_SHORT };
  default:
    return { VTK_FLOAT, Floats[i], Formats[i], GL_FLOAT };
  }
}

// Asks before VTK does, which would report an error of its own. Drivers answer as well as they
// know.
bool CanAllocate(const flatblock::Index3& size, const GLFormat& format)
{
  glTexImage3D(GL_PROXY_TEXTURE_3D, 0, static_cast<int>(format.Internal), size[0], size[1], size[2],
    0, format.Format, format.Type, nullptr);
  int depth = 0;
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_DEPTH, &depth);
  return depth == size[2];
}

bool IsAllocated3D(vtkTextureObject* texture, int depth)
{
  int allocated = 0;
  texture->Activate();
  glGetTexLevelParameteriv(GL_TEXTURE_3D, 0, GL_TEXTURE_DEPTH, &allocated);
  texture->Deactivate();
  return allocated == depth;
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
  if ((plan.NewAtlas && !this->Allocate(window, places.GetTextureSize(), source.GetEncoding())) ||
      (plan.NewPlaces && !this->WriteIndex(window, residency, source.GetGrid().GetApron())))
  {
    this->ReleaseGraphicsResources(window);
    return false;
  }
  flatblock::ClearGLErrors();
  this->Move(plan.Moves, source.GetEncoding());
  this->Upload(plan.Uploads, places, source);
  if (glGetError() == GL_OUT_OF_MEMORY) // of drivers that allocate what is touched
  {
    this->ReleaseGraphicsResources(window);
    return false;
  }
  return true;
}

bool vtkOpenGLFlatBlockAtlas::Allocate(vtkOpenGLRenderWindow* window, const flatblock::Index3& size,
  const flatblock::TexelEncoding& texels)
{
  const GLFormat gl = GetGLFormat(texels);
  if (this->Bricks->GetHandle() != 0 && this->Size == size && this->InternalFormat == gl.Internal)
  {
    return true; // of another step in time, say
  }
  this->ReleaseGraphicsResources(window);
  this->Bricks->SetContext(window);
  this->Bricks->SetInternalFormat(gl.Internal);
  this->Bricks->SetFormat(gl.Format);
  this->Bricks->SetDataType(gl.Type);
  this->Bricks->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Bricks->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Bricks->SetWrapR(vtkTextureObject::ClampToEdge);
  flatblock::ClearGLErrors();
  if (!CanAllocate(size, gl) ||
      !this->Bricks->Allocate3D(size[0], size[1], size[2], texels.Components, gl.VtkType) ||
      !IsAllocated3D(this->Bricks, size[2]))
  {
    flatblock::ClearGLErrors();
    return false;
  }
  // What lies beside a brick has no weight, but times NaN that is not nothing.
  if (texels.Format == flatblock::TexelFormat::Float32 && GLEW_ARB_clear_texture)
  {
    glClearTexImage(this->Bricks->GetHandle(), 0, gl.Format, gl.Type, nullptr);
  }
  this->BrickBytes.Set(
    static_cast<std::int64_t>(flatblock::BytesPerTexel(texels)) * size[0] * size[1] * size[2]);
  this->Size = size;
  this->InternalFormat = gl.Internal;
  return true;
}

bool vtkOpenGLFlatBlockAtlas::WriteIndex(
  vtkOpenGLRenderWindow* window, const flatblock::Residency& residency, int apron)
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
      std::transform(origin.begin(), origin.end(), texel,
        [apron](int first) { return static_cast<std::uint16_t>(first + apron); });
      texel[3] = static_cast<std::uint16_t>(residency.GetLevels()[block]);
    }
  }
  this->BlockIndex->SetContext(window);
  this->BlockIndex->SetInternalFormat(GL_RGBA16UI);
  this->BlockIndex->SetFormat(GL_RGBA_INTEGER);
  this->BlockIndex->SetDataType(GL_UNSIGNED_SHORT);
  flatblock::ClearGLErrors();
  const bool created =
    this->BlockIndex->Create2DFromRaw(width, height, 4, VTK_UNSIGNED_SHORT, texels.data());
  const bool failed = glGetError() != GL_NO_ERROR;
  this->IndexBytes.Set(GetIndexBytes(static_cast<vtkTypeInt64>(places.size())));
  flatblock::ClearGLErrors();
  return created && !failed;
}

bool vtkOpenGLFlatBlockAtlas::CanMove()
{
  return GLEW_ARB_copy_image != 0;
}

void vtkOpenGLFlatBlockAtlas::Move(
  const std::vector<flatblock::BoxMove>& moves, const flatblock::TexelEncoding& texels)
{
  const unsigned int atlas = this->Bricks->GetHandle();
  for (const flatblock::BoxMove& move : moves)
  {
    // A copy must not overlap itself: boxes that move by less than their depth go in slices, the
    // foremost first.
    const int down = move.From[2] - move.To[2];
    const bool isAside = move.From[0] != move.To[0] || move.From[1] != move.To[1];
    const int depth = move.Size[2];
    const int slice = isAside || down == 0 ? depth : std::min(std::abs(down), depth);
    for (int done = 0; done < depth; done += slice)
    {
      const int layers = std::min(slice, depth - done);
      const int z = down > 0 ? done : depth - done - layers;
      glCopyImageSubData(atlas, GL_TEXTURE_3D, 0, move.From[0], move.From[1], move.From[2] + z,
        atlas, GL_TEXTURE_3D, 0, move.To[0], move.To[1], move.To[2] + z, move.Size[0], move.Size[1],
        layers);
    }
    this->MovedBytes += static_cast<vtkTypeInt64>(flatblock::BytesPerTexel(texels)) * move.Size[0] *
                        move.Size[1] * move.Size[2];
  }
}

namespace
{
// Some uploads that follow each other, with their bricks.
class Batch
{
public:
  using Uploads = std::vector<flatblock::BrickUpload>;

  // From `first` on, as many as there is room for.
  void Begin(const Uploads& uploads, std::size_t first, const flatblock::BrickSource& source)
  {
    this->First = first;
    this->Offsets.clear();
    const std::size_t bytesPerTexel = flatblock::BytesPerTexel(source.GetEncoding());
    std::size_t bytes = 0;
    for (std::size_t i = first; i < uploads.size() && bytes < StagingBytes; ++i)
    {
      const std::size_t side = source.GetGrid().GetTexelSide(uploads[i].Level);
      this->Offsets.push_back(bytes);
      bytes += bytesPerTexel * side * side * side;
    }
    this->Bytes.resize(std::max(this->Bytes.size(), bytes));
  }

  void Read(
    const Uploads& uploads, const flatblock::BrickSource& source, flatblock::ParallelLoop& loop)
  {
    const auto count = static_cast<std::int64_t>(this->Offsets.size());
    const flatblock::BrickUpload* first = uploads.data() + this->First;
    const flatblock::BrickSource* from = &source; // a task would copy what a reference refers to
    flatblock::ParallelLoop* turns = &loop;
#pragma omp taskloop nogroup
    for (std::int64_t i = 0; i < count; ++i)
    {
      turns->Do([=]
        { from->ReadBrick(first[i].Block, first[i].Level, first[i].Border, this->GetBrick(i)); });
    }
  }

  std::size_t GetFirst() const
  {
    return this->First;
  }
  std::size_t GetCount() const
  {
    return this->Offsets.size();
  }
  std::uint8_t* GetBrick(std::size_t i)
  {
    return &this->Bytes[this->Offsets[i]];
  }

private:
  std::size_t First = 0;
  std::vector<std::size_t> Offsets;
  std::vector<std::uint8_t> Bytes;
};
} // namespace

// While one thread, that of the OpenGL context, sends a batch, the others read the next.
void vtkOpenGLFlatBlockAtlas::Upload(const std::vector<flatblock::BrickUpload>& uploads,
  const flatblock::AtlasAllocator& places, const flatblock::BrickSource& source)
{
  if (uploads.empty())
  {
    return;
  }
  this->Bricks->Activate();
  vtkOpenGLState* state = this->Bricks->GetContext()->GetState();
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  Batch batches[2];
  flatblock::ParallelLoop loop;
#pragma omp parallel
#pragma omp master
  {
    Batch* ready = &batches[0];
    Batch* next = &batches[1];
    const auto begin = [&](std::size_t first)
    {
      loop.Do(
        [&]
        {
          next->Begin(uploads, first, source);
          next->Read(uploads, source, loop);
        });
    };
    begin(0);
    while (next->GetCount() > 0 && !loop.IsEnding())
    {
#pragma omp taskwait
      std::swap(ready, next);
      begin(ready->GetFirst() + ready->GetCount());
      for (std::size_t i = 0; i < ready->GetCount(); ++i)
      {
        loop.Do(
          [&]
          {
            const flatblock::BrickUpload& upload = uploads[ready->GetFirst() + i];
            this->UploadParts(upload, places.GetOrigin(upload.Place), source, ready->GetBrick(i));
          });
      }
    }
  }
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  this->Bricks->Deactivate();
  loop.Finish();
}

void vtkOpenGLFlatBlockAtlas::UploadParts(const flatblock::BrickUpload& upload,
  const flatblock::Index3& origin, const flatblock::BrickSource& source, const std::uint8_t* brick)
{
  const GLFormat gl = GetGLFormat(source.GetEncoding());
  const std::size_t bytesPerTexel = flatblock::BytesPerTexel(source.GetEncoding());
  const flatblock::BlockGrid& grid = source.GetGrid();
  const int side = grid.GetTexelSide(upload.Level);
  vtkTypeInt64 texels = 0;
  const auto boxes =
    flatblock::GetBoxes(upload.Parts, grid.GetBrickSide(upload.Level), grid.GetApron());
  glPixelStorei(GL_UNPACK_ROW_LENGTH, side);
  glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, side);
  for (const flatblock::BrickBox& box : boxes)
  {
    const flatblock::Index3& at = box.First;
    const std::size_t texel = at[0] + static_cast<std::size_t>(side) * (at[1] + side * at[2]);
    glTexSubImage3D(GL_TEXTURE_3D, 0, origin[0] + at[0], origin[1] + at[1], origin[2] + at[2],
      box.Size[0], box.Size[1], box.Size[2], gl.Format, gl.Type, brick + texel * bytesPerTexel);
    texels += static_cast<vtkTypeInt64>(box.Size[0]) * box.Size[1] * box.Size[2];
  }
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 0);
  this->UploadedBytes += static_cast<vtkTypeInt64>(bytesPerTexel) * texels;
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
