/**
 * @class   vtkOpenGLFlatBlockRayCaster
 * @brief   draws the bricks of an atlas: one box, one pass
 */

#ifndef vtkOpenGLFlatBlockRayCaster_h
#define vtkOpenGLFlatBlockRayCaster_h

#include "BrickSource.h"
#include "MemoryCounter.h"
#include "TransferTable.h"
#include "vtkNew.h"
#include "vtkObject.h"

class vtkMatrix4x4;
class vtkOpenGLFlatBlockAtlas;
class vtkOpenGLFlatBlockSceneDepth;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkOpenGLFlatBlockRayCaster : public vtkObject
{
public:
  static vtkOpenGLFlatBlockRayCaster* New();
  vtkTypeMacro(vtkOpenGLFlatBlockRayCaster, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What a frame shows.
   */
  struct Scene
  {
    const flatblock::BrickSource* Source;
    vtkOpenGLFlatBlockAtlas* Atlas;
    vtkMatrix4x4* SampleToDataSet; ///< spacing, origin and direction
    vtkMatrix4x4* DataSetToWorld;  ///< the prop's matrix
    double Step;                   ///< between samples, in the data set's unit of length
    bool LinearInterpolation;      ///< nearest sample otherwise
  };

  /**
   * Counts what is allocated from now on.
   */
  void SetMemoryCounter(flatblock::MemoryCounter* counter);

  /**
   * Releases what the next Draw() will allocate in another size, so that its memory is free before.
   */
  void ReleaseStale(vtkRenderer* renderer, const flatblock::TransferTable& table);

  /**
   * Sends a transfer function to the graphics card, where Draw() finds it.
   */
  void SetTransferTable(vtkOpenGLRenderWindow* window, const flatblock::TransferTable& table);
  bool HasTransferTable() const;

  /**
   * Blends the volume over what the renderer's window shows already. Leaves the OpenGL state as it
   * found it.
   * @return whether the shader could be built; VTK has said why not
   */
  bool Draw(vtkRenderer* renderer, const Scene& scene);

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkOpenGLFlatBlockRayCaster();
  ~vtkOpenGLFlatBlockRayCaster() override;

private:
  vtkOpenGLFlatBlockRayCaster(const vtkOpenGLFlatBlockRayCaster&) = delete;
  void operator=(const vtkOpenGLFlatBlockRayCaster&) = delete;

  void SetGeometry(vtkShaderProgram* program, const Scene& scene, vtkMatrix4x4* sampleToClip);
  void SetBlocks(vtkShaderProgram* program, const Scene& scene);
  void SetClassification(vtkShaderProgram* program, const Scene& scene);
  void DrawBox(vtkOpenGLRenderWindow* window, bool mirrored);

  vtkNew<vtkTextureObject> TransferTexture;
  vtkNew<vtkOpenGLFlatBlockSceneDepth> SceneDepth;
  flatblock::CountedBytes TableBytes;
  double TableLowest = 0.0;
  double TableHighest = 0.0;
};

#endif
