/**
 * @class   vtkFlatBlockVolumeRepresentation
 * @brief   ParaView's representation "Flat-block Volume"
 *
 * The stock volume representation of image data with vtkFlatBlockVolumeMapper in place of its
 * mapper.
 */

#ifndef vtkFlatBlockVolumeRepresentation_h
#define vtkFlatBlockVolumeRepresentation_h

#include "vtkFlatBlockVolumeRepresentationModule.h" // for the export macro
#include "vtkImageVolumeRepresentation.h"

class vtkDataArray;

class VTKFLATBLOCKVOLUMEREPRESENTATION_EXPORT vtkFlatBlockVolumeRepresentation
  : public vtkImageVolumeRepresentation
{
public:
  static vtkFlatBlockVolumeRepresentation* New();
  vtkTypeMacro(vtkFlatBlockVolumeRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Forwarded to vtkFlatBlockVolumeMapper.
   */
  void SetBlockSize(int samples);
  void SetSampleDistance(double distance);
  ///@}

protected:
  vtkFlatBlockVolumeRepresentation();
  ~vtkFlatBlockVolumeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  /**
   * Draws the point scalars, or the first point array, in gray where no array is chosen.
   */
  void UpdateMapperParameters() override;

private:
  vtkFlatBlockVolumeRepresentation(const vtkFlatBlockVolumeRepresentation&) = delete;
  void operator=(const vtkFlatBlockVolumeRepresentation&) = delete;

  vtkNew<vtkVolumeProperty> GrayProperty;
  vtkDataArray* ShownInGray = nullptr; // only compared with
};

#endif
