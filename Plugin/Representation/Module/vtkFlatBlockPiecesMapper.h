/**
 * @class   vtkFlatBlockPiecesMapper
 * @brief   draws images that don't overlap, each with a mapper of its own
 *
 * From the farthest to the nearest, so that their colours are blended as those of one volume.
 */

#ifndef vtkFlatBlockPiecesMapper_h
#define vtkFlatBlockPiecesMapper_h

#include "vtkFlatBlockVolumeRepresentationModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkVolumeMapper.h"

#include <vector> // for the mappers

class vtkFlatBlockVolumeMapper;
class vtkImageData;

class VTKFLATBLOCKVOLUMEREPRESENTATION_EXPORT vtkFlatBlockPiecesMapper : public vtkVolumeMapper
{
public:
  static vtkFlatBlockPiecesMapper* New();
  vtkTypeMacro(vtkFlatBlockPiecesMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The images to draw. Mappers of those that were there before stay.
   */
  void SetImages(const std::vector<vtkImageData*>& images);

  /**
   * Gives all mappers the settings of another, and of MaxMemoryInBytes shares that go with the
   * samples that they draw.
   */
  void CopySettings(vtkFlatBlockVolumeMapper* settings);

  const std::vector<vtkSmartPointer<vtkFlatBlockVolumeMapper>>& GetMappers() const
  {
    return this->Mappers;
  }

  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkFlatBlockPiecesMapper();
  ~vtkFlatBlockPiecesMapper() override;

private:
  vtkFlatBlockPiecesMapper(const vtkFlatBlockPiecesMapper&) = delete;
  void operator=(const vtkFlatBlockPiecesMapper&) = delete;

  std::vector<vtkSmartPointer<vtkFlatBlockVolumeMapper>> Mappers;
  std::vector<vtkSmartPointer<vtkImageData>> Images; // that they were given
};

#endif
