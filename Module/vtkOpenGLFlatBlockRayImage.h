/**
 * @class   vtkOpenGLFlatBlockRayImage
 * @brief   a picture of rays of another size than the viewport, and which of them were cut off
 *
 * Colours have half floats; whether a ray was cut off takes a byte.
 */

#ifndef vtkOpenGLFlatBlockRayImage_h
#define vtkOpenGLFlatBlockRayImage_h

#include "MemoryCounter.h"
#include "RaySampling.h"
#include "vtkImageData.h" // for its smart pointer
#include "vtkNew.h"
#include "vtkObject.h"

#include <array>
#include <functional>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkOpenGLFlatBlockRayImage : public vtkObject
{
public:
  static vtkOpenGLFlatBlockRayImage* New();
  vtkTypeMacro(vtkOpenGLFlatBlockRayImage, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Counts what is allocated from now on.
   */
  void SetMemoryCounter(flatblock::MemoryCounter* counter) { this->Bytes.SetCounter(counter); }

  /**
   * Rays along both axes of a viewport, with so many pixels from one to the next.
   */
  static std::array<int, 2> GetSize(vtkRenderer* renderer, double pixelsPerRay);
  static vtkTypeInt64 GetBytes(vtkRenderer* renderer, double pixelsPerRay, bool hasCounts);

  struct Content
  {
    double PixelsPerRay = 1.0;
    bool HasCounts = false;   ///< or depths
    bool KeepsImages = false; ///< buffer 1 has depths
  };

  /**
   * While the function runs, the image is drawn to, and shows nothing at first. Draw buffer 0 takes
   * colours. Where there are counts, buffer 1 takes the samples of a ray, negative where it was cut
   * off, and its fetches. They are added up, or else both images are kept. What was drawn to before
   * is drawn to again, also after an exception.
   */
  void DrawInto(vtkRenderer* renderer, const Content& content, const std::function<void()>& draw);

  /**
   * What was kept: RGBA of 8 bit, multiplied by opacity, and depths in floats, from 0 at the
   * camera's near plane to 1 at the far one or where there is nothing. Null is passed by.
   */
  void GetImages(vtkImageData* color, vtkImageData* depth) const;

  /**
   * Blends the image over the renderer's viewport, with the blend function that is set.
   * @return whether the shader could be built
   */
  bool Draw(vtkRenderer* renderer);

  /**
   * For a program that reads the image as in_CoarseRays.
   */
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  const flatblock::RayCounts& GetCounts() const { return this->RayCounts; }

  /**
   * Releases what the next Begin() will allocate in another size.
   */
  void ReleaseIfStale(vtkRenderer* renderer, double pixelsPerRay, bool hasCounts);
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkOpenGLFlatBlockRayImage();
  ~vtkOpenGLFlatBlockRayImage() override;

private:
  vtkOpenGLFlatBlockRayImage(const vtkOpenGLFlatBlockRayImage&) = delete;
  void operator=(const vtkOpenGLFlatBlockRayImage&) = delete;

  void Clear(vtkOpenGLState* state, const std::array<int, 2>& size, bool hasCounts);
  void Allocate(vtkOpenGLRenderWindow* window, const std::array<int, 2>& size, bool hasCounts);
  bool HasSize(const std::array<int, 2>& size, bool hasCounts) const;

  vtkNew<vtkTextureObject> Colors;
  vtkNew<vtkTextureObject> Counts;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  void CountRays();
  void KeepImages();

  vtkNew<vtkImageData> ColorImage;
  vtkNew<vtkImageData> DepthImage;
  flatblock::CountedBytes Bytes;
  flatblock::RayCounts RayCounts;
};

#endif
