/**
 * @class   vtkOpenGLFlatBlockFunctionTexture
 * @brief   a table of a function on the graphics card: R32F, or RGBA32F
 */

#ifndef vtkOpenGLFlatBlockFunctionTexture_h
#define vtkOpenGLFlatBlockFunctionTexture_h

#include "FunctionTable.h"
#include "vtkOpenGLFlatBlockLookup.h"

class vtkOpenGLFlatBlockFunctionTexture : public vtkOpenGLFlatBlockLookup
{
public:
  static vtkOpenGLFlatBlockFunctionTexture* New();
  vtkTypeMacro(vtkOpenGLFlatBlockFunctionTexture, vtkOpenGLFlatBlockLookup);

  static vtkTypeInt64 GetBytes(const flatblock::FunctionTable& table);

  /**
   * @return whether the driver had memory for it
   */
  bool Upload(vtkOpenGLRenderWindow* window, const flatblock::FunctionTable& table);

  /**
   * Of the sampler that it is activated for.
   */
  void SetName(const char* name) { this->Name = name; }

  void Activate(vtkShaderProgram* program) override;

protected:
  vtkOpenGLFlatBlockFunctionTexture() = default;
  ~vtkOpenGLFlatBlockFunctionTexture() override = default;

private:
  vtkOpenGLFlatBlockFunctionTexture(const vtkOpenGLFlatBlockFunctionTexture&) = delete;
  void operator=(const vtkOpenGLFlatBlockFunctionTexture&) = delete;

  const char* Name = "";
};

#endif
