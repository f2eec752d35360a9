/**
 * @class   vtkOpenGLFlatBlockBrickRanges
 * @brief   the scales of bricks on the graphics card: one RG32F texel a block
 */

#ifndef vtkOpenGLFlatBlockBrickRanges_h
#define vtkOpenGLFlatBlockBrickRanges_h

#include "BrickSource.h"
#include "MemoryCounter.h"
#include "vtkNew.h"
#include "vtkObject.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkOpenGLFlatBlockBrickRanges : public vtkObject
{
public:
  static vtkOpenGLFlatBlockBrickRanges* New();
  vtkTypeMacro(vtkOpenGLFlatBlockBrickRanges, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Counts what is allocated from now on.
   */
  void SetMemoryCounter(flatblock::MemoryCounter* counter) { this->Bytes.SetCounter(counter); }

  static vtkTypeInt64 GetBytes(vtkTypeInt64 blocks);

  /**
   * @return whether the driver had memory for it
   */
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<flatblock::TexelRange>& ranges);
  bool IsUploaded() const;

  void Activate(vtkShaderProgram* program);
  void Deactivate();

  /**
   * Releases what the next Upload() will allocate in another size, `bytes`.
   */
  void ReleaseIfStale(vtkWindow* window, vtkTypeInt64 bytes);
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkOpenGLFlatBlockBrickRanges();
  ~vtkOpenGLFlatBlockBrickRanges() override;

private:
  vtkOpenGLFlatBlockBrickRanges(const vtkOpenGLFlatBlockBrickRanges&) = delete;
  void operator=(const vtkOpenGLFlatBlockBrickRanges&) = delete;

  vtkNew<vtkTextureObject> Texture;
  flatblock::CountedBytes Bytes;
};

#endif
