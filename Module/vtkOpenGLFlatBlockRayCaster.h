/**
 * @class   vtkOpenGLFlatBlockRayCaster
 * @brief   draws the bricks of an atlas: one box, one pass
 */

#ifndef vtkOpenGLFlatBlockRayCaster_h
#define vtkOpenGLFlatBlockRayCaster_h

#include "BrickSource.h"
#include "ComponentTable.h"
#include "FlatBlockComponents.h"
#include "FlatBlockRayLookups.h"
#include "FlatBlockSelection.h"
#include "MemoryCounter.h"
#include "RaySampling.h"
#include "ViewRegion.h"
#include "vtkNew.h"
#include "vtkObject.h"

class vtkImageData;
class vtkMatrix4x4;
class vtkOpenGLFlatBlockAtlas;
class vtkOpenGLFlatBlockRayImage;
class vtkOpenGLFlatBlockSceneDepth;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkVolumeProperty;
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
    vtkMatrix4x4* SampleToDataSet;     ///< spacing, origin and direction
    vtkMatrix4x4* DataSetToWorld;      ///< the prop's matrix
    flatblock::ComponentTables Tables; ///< of all components
    vtkVolumeProperty* Material;       ///< where the sampling is shaded
    bool LinearInterpolation;          ///< nearest sample otherwise
    flatblock::MaskOptions Mask;
    bool HasHoles; ///< cells with a corner that is not finite
    flatblock::RaySampling Sampling;
    flatblock::Clipping Clipping;
    bool IsOnlyImage = false;                      ///< rays stay in their image
    std::optional<flatblock::Selection> Selection; ///< ids are drawn in place of colours
  };

  /**
   * Counts what is allocated from now on.
   */
  void SetMemoryCounter(flatblock::MemoryCounter* counter);

  /**
   * Releases what the next Draw() will allocate in another size, so that its memory is free before.
   */
  void ReleaseStale(vtkRenderer* renderer, const flatblock::ComponentTables& tables,
    const flatblock::LookupBytes& bytes, const flatblock::RaySampling& sampling);

  /**
   * What Draw() finds on the graphics card.
   */
  flatblock::RayLookups& GetLookups() { return this->Lookups; }

  /**
   * Bytes of the image of rays where one is drawn.
   */
  static vtkTypeInt64 GetImageBytes(vtkRenderer* renderer, const flatblock::RaySampling& sampling);

  /**
   * Blends the volume over what the renderer's window shows already. Leaves the OpenGL state as it
   * found it.
   * @return whether the shader could be built; VTK has said why not
   */
  bool Draw(vtkRenderer* renderer, const Scene& scene);

  /**
   * Waits until what was drawn is there.
   */
  static void Finish();

  /**
   * Of the last Draw() with a sampling that has counts.
   */
  const flatblock::RayCounts& GetCounts() const;

  /**
   * Of the last Draw() with a sampling that stays in its image: see vtkOpenGLFlatBlockRayImage.
   */
  void GetImages(vtkImageData* color, vtkImageData* depth) const;

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkOpenGLFlatBlockRayCaster();
  ~vtkOpenGLFlatBlockRayCaster() override;

private:
  vtkOpenGLFlatBlockRayCaster(const vtkOpenGLFlatBlockRayCaster&) = delete;
  void operator=(const vtkOpenGLFlatBlockRayCaster&) = delete;

  void SetRays(vtkRenderer* renderer, vtkShaderProgram* program, const Scene& scene);
  void SetBlocks(vtkShaderProgram* program, const Scene& scene);
  enum class Cover
  {
    Box,
    MirroredBox,
    Viewport
  };
  bool Cast(vtkRenderer* renderer, const Scene& scene);
  bool DrawRays(vtkRenderer* renderer, const Scene& scene, Cover cover);
  void DrawCover(vtkOpenGLState* state, Cover cover);

  flatblock::RayLookups Lookups;
  vtkNew<vtkOpenGLFlatBlockSceneDepth> SceneDepth;
  vtkNew<vtkOpenGLFlatBlockRayImage> RayImage;
};

#endif
