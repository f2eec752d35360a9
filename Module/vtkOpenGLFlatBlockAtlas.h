/**
 * @class   vtkOpenGLFlatBlockAtlas
 * @brief   the 3D texture that holds the bricks, and the index texture that says where
 *
 * The index texture has one RGBA16UI texel a block, folded into rows: xyz the brick's first texel,
 * w its level, or 65535 where the block is transparent.
 */

#ifndef vtkOpenGLFlatBlockAtlas_h
#define vtkOpenGLFlatBlockAtlas_h

#include "BrickSource.h"
#include "FramePlan.h"
#include "MemoryCounter.h"
#include "vtkNew.h"
#include "vtkObject.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkOpenGLFlatBlockAtlas : public vtkObject
{
public:
  static vtkOpenGLFlatBlockAtlas* New();
  vtkTypeMacro(vtkOpenGLFlatBlockAtlas, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Counts what is allocated from now on.
   */
  void SetMemoryCounter(flatblock::MemoryCounter* counter);

  /**
   * Texels a side of the largest 3D texture of the window's driver.
   */
  static int GetLargestTexture(vtkOpenGLRenderWindow* window);

  /**
   * Whether the driver can move bricks within the atlas.
   */
  static bool CanMove();

  /**
   * Carries out a plan. Where the driver has no memory left nothing remains allocated.
   * @return whether it could
   */
  bool Execute(vtkOpenGLRenderWindow* window, const flatblock::FramePlan& plan,
    const flatblock::Residency& residency, const flatblock::BrickSource& source);

  /**
   * Bytes of the index texture of so many blocks.
   */
  static vtkTypeInt64 GetIndexBytes(vtkTypeInt64 blocks);

  /**
   * Whether the textures are still there; a window that went away took them along.
   */
  bool IsAllocated() const;

  vtkTextureObject* GetBricks() const { return this->Bricks; }
  vtkTextureObject* GetBlockIndex() const { return this->BlockIndex; }

  /**
   * Bytes of the 3D texture, and bytes of bricks that the last Execute() uploaded or moved.
   */
  vtkTypeInt64 GetBytes() const { return this->BrickBytes.Get(); }
  vtkGetMacro(UploadedBytes, vtkTypeInt64);
  vtkGetMacro(MovedBytes, vtkTypeInt64);

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkOpenGLFlatBlockAtlas();
  ~vtkOpenGLFlatBlockAtlas() override;

private:
  vtkOpenGLFlatBlockAtlas(const vtkOpenGLFlatBlockAtlas&) = delete;
  void operator=(const vtkOpenGLFlatBlockAtlas&) = delete;

  bool Allocate(vtkOpenGLRenderWindow* window, const flatblock::Index3& size,
    const flatblock::TexelEncoding& texels);
  bool WriteIndex(vtkOpenGLRenderWindow* window, const flatblock::Residency& residency, int apron);
  void Move(const std::vector<flatblock::BoxMove>& moves, const flatblock::TexelEncoding& texels);
  void Upload(const std::vector<flatblock::BrickUpload>& uploads,
    const flatblock::AtlasAllocator& places, const flatblock::BrickSource& source);
  void UploadParts(const flatblock::BrickUpload& upload, const flatblock::Index3& origin,
    const flatblock::BrickSource& source, const std::uint8_t* brick);

  vtkNew<vtkTextureObject> Bricks;
  vtkNew<vtkTextureObject> BlockIndex;
  flatblock::Index3 Size = { 0, 0, 0 }; // of the bricks' texture
  unsigned int InternalFormat = 0;
  flatblock::CountedBytes BrickBytes;
  flatblock::CountedBytes IndexBytes;
  vtkTypeInt64 UploadedBytes = 0;
  vtkTypeInt64 MovedBytes = 0;
};

#endif
