/**
 * @class   vtkOpenGLFlatBlockRayCaster
 * @brief   draws the bricks of an atlas: one box, one pass
 */

#ifndef vtkOpenGLFlatBlockRayCaster_h
#define vtkOpenGLFlatBlockRayCaster_h

#include "BrickSource.h"
#include "ComponentTable.h"
#include "FlatBlockComponents.h"
#include "FlatBlockSelection.h"
#include "GradientTable.h"
#include "MemoryCounter.h"
#include "RaySampling.h"
#include "SkipMap.h"
#include "ViewRegion.h"
#include "vtkNew.h"
#include "vtkObject.h"

class vtkImageData;
class vtkMatrix4x4;
class vtkOpenGLFlatBlockAtlas;
class vtkOpenGLFlatBlockBrickRanges;
class vtkOpenGLFlatBlockGradientTexture;
class vtkOpenGLFlatBlockRayImage;
class vtkOpenGLFlatBlockSceneDepth;
class vtkOpenGLFlatBlockSkipTexture;
class vtkOpenGLFlatBlockTransferTable;
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
  struct LookupBytes
  {
    vtkTypeInt64 SkipMap;
    vtkTypeInt64 GradientTable;
    vtkTypeInt64 BrickRanges;
  };
  void ReleaseStale(vtkRenderer* renderer, const flatblock::ComponentTables& tables,
    const LookupBytes& bytes, const flatblock::RaySampling& sampling);

  /**
   * Sends transfer functions to the graphics card, where Draw() finds it: with its integrals where
   * segments are integrated.
   * @return whether the graphics card takes so many entries
   */
  bool SetTransferTable(vtkOpenGLRenderWindow* window, const flatblock::ComponentTables& tables,
    const flatblock::RaySampling& sampling);
  bool HasTransferTable(const flatblock::RaySampling& sampling) const;

  /**
   * The same for a map of leaps, where the sampling has one.
   * @return whether the driver had memory for it
   */
  bool SetSkipMap(vtkOpenGLRenderWindow* window, const flatblock::SkipMap& map,
    const flatblock::RaySampling& sampling);
  bool HasSkipMap() const;

  /**
   * The same for the scales of bricks, of which a source may have none.
   */
  bool SetBrickRanges(
    vtkOpenGLRenderWindow* window, const std::vector<flatblock::TexelRange>& ranges);
  bool HasBrickRanges() const;

  /**
   * The same for what depends on gradients, which may be nothing.
   */
  bool SetGradientTable(vtkOpenGLRenderWindow* window, const flatblock::GradientTable& table);
  bool HasGradientTable() const;

  /**
   * Bytes of transfer functions, and of the image of rays where one is drawn.
   */
  static vtkTypeInt64 GetTableBytes(
    const flatblock::ComponentTables& tables, const flatblock::RaySampling& sampling);
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

  vtkNew<vtkOpenGLFlatBlockTransferTable> TransferTable;
  vtkNew<vtkOpenGLFlatBlockSkipTexture> SkipTexture;
  vtkNew<vtkOpenGLFlatBlockBrickRanges> BrickRanges;
  vtkNew<vtkOpenGLFlatBlockGradientTexture> GradientTexture;
  vtkNew<vtkOpenGLFlatBlockSceneDepth> SceneDepth;
  vtkNew<vtkOpenGLFlatBlockRayImage> RayImage;
};

#endif
