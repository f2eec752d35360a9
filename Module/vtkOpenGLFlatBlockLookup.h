/**
 * @class   vtkOpenGLFlatBlockLookup
 * @brief   a texture that the ray caster looks things up in: whose bytes count, and that may be
 * none
 */

#ifndef vtkOpenGLFlatBlockLookup_h
#define vtkOpenGLFlatBlockLookup_h

#include "MemoryCounter.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <functional>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkOpenGLFlatBlockLookup : public vtkObject
{
public:
  vtkTypeMacro(vtkOpenGLFlatBlockLookup, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Counts what is allocated from now on.
   */
  void SetMemoryCounter(flatblock::MemoryCounter* counter) { this->Bytes.SetCounter(counter); }

  bool IsUploaded() const;

  /**
   * For a program that reads it. Active until Deactivate().
   */
  virtual void Activate(vtkShaderProgram* program) = 0;
  void Deactivate();

  /**
   * Releases what the next upload will allocate in another size, `bytes`.
   */
  void ReleaseIfStale(vtkWindow* window, vtkTypeInt64 bytes);
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkOpenGLFlatBlockLookup();
  ~vtkOpenGLFlatBlockLookup() override;

  /**
   * @param create  allocates and fills Texture, and says whether it could
   * @return whether the driver had memory for it; it is released otherwise
   */
  bool Create(
    vtkOpenGLRenderWindow* window, vtkTypeInt64 bytes, const std::function<bool()>& create);

  vtkNew<vtkTextureObject> Texture;

private:
  vtkOpenGLFlatBlockLookup(const vtkOpenGLFlatBlockLookup&) = delete;
  void operator=(const vtkOpenGLFlatBlockLookup&) = delete;

  flatblock::CountedBytes Bytes;
};

#endif
