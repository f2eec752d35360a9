/**
 * @class   vtkOpenGLFlatBlockSkipTexture
 * @brief   a map of leaps on the graphics card: one R8UI texel a cube of cells
 */

#ifndef vtkOpenGLFlatBlockSkipTexture_h
#define vtkOpenGLFlatBlockSkipTexture_h

#include "MemoryCounter.h"
#include "SkipMap.h"
#include "vtkNew.h"
#include "vtkObject.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkOpenGLFlatBlockSkipTexture : public vtkObject
{
public:
  static vtkOpenGLFlatBlockSkipTexture* New();
  vtkTypeMacro(vtkOpenGLFlatBlockSkipTexture, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Counts what is allocated from now on.
   */
  void SetMemoryCounter(flatblock::MemoryCounter* counter) { this->Bytes.SetCounter(counter); }

  /**
   * @param cells  of a cube's side
   * @return whether the driver had memory for it
   */
  bool Upload(vtkOpenGLRenderWindow* window, const flatblock::SkipMap& map, int cells);
  bool IsUploaded() const;

  void Activate(vtkShaderProgram* program);
  void Deactivate();

  /**
   * Releases what the next Upload() will allocate in another size, `bytes`.
   */
  void ReleaseIfStale(vtkWindow* window, vtkTypeInt64 bytes);
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkOpenGLFlatBlockSkipTexture();
  ~vtkOpenGLFlatBlockSkipTexture() override;

private:
  vtkOpenGLFlatBlockSkipTexture(const vtkOpenGLFlatBlockSkipTexture&) = delete;
  void operator=(const vtkOpenGLFlatBlockSkipTexture&) = delete;

  vtkNew<vtkTextureObject> Texture;
  flatblock::CountedBytes Bytes;
  flatblock::Index3 Size = { 0, 0, 0 };
  int Cells = 0;
};

#endif
