/**
 * @class   vtkOpenGLFlatBlockSkipTexture
 * @brief   a map of leaps on the graphics card: one R8UI texel a cube of cells
 */

#ifndef vtkOpenGLFlatBlockSkipTexture_h
#define vtkOpenGLFlatBlockSkipTexture_h

#include "SkipMap.h"
#include "vtkOpenGLFlatBlockLookup.h"

class vtkOpenGLFlatBlockSkipTexture : public vtkOpenGLFlatBlockLookup
{
public:
  static vtkOpenGLFlatBlockSkipTexture* New();
  vtkTypeMacro(vtkOpenGLFlatBlockSkipTexture, vtkOpenGLFlatBlockLookup);

  /**
   * @param cells  of a cube's side
   * @return whether the driver had memory for it
   */
  bool Upload(vtkOpenGLRenderWindow* window, const flatblock::SkipMap& map, int cells);

  void Activate(vtkShaderProgram* program) override;

protected:
  vtkOpenGLFlatBlockSkipTexture() = default;
  ~vtkOpenGLFlatBlockSkipTexture() override = default;

private:
  vtkOpenGLFlatBlockSkipTexture(const vtkOpenGLFlatBlockSkipTexture&) = delete;
  void operator=(const vtkOpenGLFlatBlockSkipTexture&) = delete;

  flatblock::Index3 Size = { 0, 0, 0 };
  int Cells = 0;
};

#endif
