/**
 * @class   vtkOpenGLFlatBlockGradientTexture
 * @brief   a table of gradients on the graphics card: R32F, or RGBA32F
 */

#ifndef vtkOpenGLFlatBlockGradientTexture_h
#define vtkOpenGLFlatBlockGradientTexture_h

#include "GradientTable.h"
#include "vtkOpenGLFlatBlockLookup.h"

class vtkOpenGLFlatBlockGradientTexture : public vtkOpenGLFlatBlockLookup
{
public:
  static vtkOpenGLFlatBlockGradientTexture* New();
  vtkTypeMacro(vtkOpenGLFlatBlockGradientTexture, vtkOpenGLFlatBlockLookup);

  static vtkTypeInt64 GetBytes(const flatblock::GradientTable& table);

  /**
   * @return whether the driver had memory for it
   */
  bool Upload(vtkOpenGLRenderWindow* window, const flatblock::GradientTable& table);

  void Activate(vtkShaderProgram* program) override;

protected:
  vtkOpenGLFlatBlockGradientTexture() = default;
  ~vtkOpenGLFlatBlockGradientTexture() override = default;

private:
  vtkOpenGLFlatBlockGradientTexture(const vtkOpenGLFlatBlockGradientTexture&) = delete;
  void operator=(const vtkOpenGLFlatBlockGradientTexture&) = delete;
};

#endif
