/**
 * @class   vtkOpenGLFlatBlockSceneDepth
 * @brief   a texture with the depth of what was drawn before the volume
 *
 * Reads the bound framebuffer, multisampled or not.
 */

#ifndef vtkOpenGLFlatBlockSceneDepth_h
#define vtkOpenGLFlatBlockSceneDepth_h

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
};

#endif
