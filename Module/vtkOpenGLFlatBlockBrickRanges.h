/**
 * @class   vtkOpenGLFlatBlockBrickRanges
 * @brief   the scales of bricks on the graphics card: one RG32F texel a block
 */

#ifndef vtkOpenGLFlatBlockBrickRanges_h
#define vtkOpenGLFlatBlockBrickRanges_h

#include "BrickSource.h"
#include "vtkOpenGLFlatBlockLookup.h"

class vtkOpenGLFlatBlockBrickRanges : public vtkOpenGLFlatBlockLookup
{
public:
  static vtkOpenGLFlatBlockBrickRanges* New();
  vtkTypeMacro(vtkOpenGLFlatBlockBrickRanges, vtkOpenGLFlatBlockLookup);

  static vtkTypeInt64 GetBytes(vtkTypeInt64 blocks);

  /**
   * @return whether the driver had memory for it
   */
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<flatblock::TexelRange>& ranges);

  void Activate(vtkShaderProgram* program) override;

protected:
  vtkOpenGLFlatBlockBrickRanges() = default;
  ~vtkOpenGLFlatBlockBrickRanges() override = default;

private:
  vtkOpenGLFlatBlockBrickRanges(const vtkOpenGLFlatBlockBrickRanges&) = delete;
  void operator=(const vtkOpenGLFlatBlockBrickRanges&) = delete;
};

#endif
