/**
 * @class   vtkOpenGLFlatBlockSceneDepth
 * @brief   a texture with the depth of what was drawn before the volume
 *
 * Reads the bound framebuffer, multisampled or not.
 */

#ifndef vtkOpenGLFlatBlockSceneDepth_h
#define vtkOpenGLFlatBlockSceneDepth_h

#include "MemoryCounter.h"
#include "vtkNew.h"
#include "vtkObject.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

class vtkOpenGLFlatBlockSceneDepth : public vtkObject
{
public:
  static vtkOpenGLFlatBlockSceneDepth* New();
  vtkTypeMacro(vtkOpenGLFlatBlockSceneDepth, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Counts what is allocated from now on.
   */
  void SetMemoryCounter(flatblock::MemoryCounter* counter) { this->Bytes.SetCounter(counter); }

  /**
   * Releases the texture if it is not of the size of the renderer's viewport.
   */
  void ReleaseIfStale(vtkRenderer* renderer);

  /**
   * Copies the depth of the renderer's viewport.
   */
  void Capture(vtkRenderer* renderer);

  /**
   * Window depth, a texel a pixel of the viewport.
   */
  vtkTextureObject* GetTexture() const { return this->Depth; }

  /**
   * The viewport's lower left pixel in the window.
   */
  vtkGetVector2Macro(Origin, int);

  /**
   * Bytes of the texture of such a viewport, at most.
   */
  static vtkTypeInt64 GetBytes(int width, int height) { return vtkTypeInt64(4) * width * height; }

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkOpenGLFlatBlockSceneDepth();
  ~vtkOpenGLFlatBlockSceneDepth() override;

private:
  vtkOpenGLFlatBlockSceneDepth(const vtkOpenGLFlatBlockSceneDepth&) = delete;
  void operator=(const vtkOpenGLFlatBlockSceneDepth&) = delete;

  void Allocate(vtkOpenGLRenderWindow* window, int width, int height);
  void Blit(vtkOpenGLRenderWindow* window, int width, int height);

  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  int Origin[2] = { 0, 0 };
  int Format = 0;
  flatblock::CountedBytes Bytes;
};

#endif
