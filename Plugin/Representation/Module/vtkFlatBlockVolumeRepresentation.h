/**
 * @class   vtkFlatBlockVolumeRepresentation
 * @brief   ParaView's representation "Flat-block Volume"
 *
 * The stock volume representation of image data with vtkFlatBlockVolumeMapper in place of its
 * mapper, and of partitioned or multi-block data sets of image data: one image where they make up
 * one grid, else a mapper for each, drawn from the farthest to the nearest.
 */

#ifndef vtkFlatBlockVolumeRepresentation_h
#define vtkFlatBlockVolumeRepresentation_h

#include "vtkFlatBlockVolumeRepresentationModule.h" // for the export macro
#include "vtkImageVolumeRepresentation.h"
#include "vtkNew.h"         // for mappers
#include "vtkWeakPointer.h" // for the view

class vtkColorTransferFunction;
class vtkDataArray;
class vtkFlatBlockPiecesMapper;
class vtkFlatBlockStatus;
class vtkFlatBlockVolumeMapper;
class vtkImageData;
class vtkPiecewiseFunction;
class vtkPVRenderView;

class VTKFLATBLOCKVOLUMEREPRESENTATION_EXPORT vtkFlatBlockVolumeRepresentation
  : public vtkImageVolumeRepresentation
{
public:
  static vtkFlatBlockVolumeRepresentation* New();
  vtkTypeMacro(vtkFlatBlockVolumeRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The settings of what is drawn, in a mapper that draws nothing itself.
   */
  void SetSettings(vtkFlatBlockVolumeMapper* settings);

  enum Qualities
  {
    CUSTOM = 0,
    INTERACTIVE,
    BALANCED,
    ACCURATE,
    REFERENCE,
    AUTOMATIC
  };

  ///@{
  /**
   * What trades accuracy for speed: Custom (default), as the settings say, or a preset of the
   * mapper in place of them.
   */
  vtkSetClampMacro(Quality, int, CUSTOM, AUTOMATIC);
  vtkGetMacro(Quality, int);
  ///@}

  ///@{
  /**
   * Graphics memory, in MiB, that is never exceeded; of each rank. Default: 256.
   */
  vtkSetClampMacro(MemoryLimit, int, 1, VTK_INT_MAX);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  ///@{
  /**
   * A blend mode that the stock representation does not have, in place of its own: none (0,
   * default), or vtkVolumeMapper's Maximum (1), Minimum (2), Average (3) or Additive (4).
   */
  vtkSetClampMacro(Projection, int, 0, 4);
  vtkGetMacro(Projection, int);
  ///@}

  ///@{
  /**
   * Colours of the function of curvature, and whether they, and not the mapper's own (default),
   * are shown.
   */
  void SetCurvatureColor(vtkColorTransferFunction* color);
  vtkSetMacro(UseCurvatureColor, bool);
  vtkGetMacro(UseCurvatureColor, bool);
  ///@}

  ///@{
  /**
   * Opacity over the function of curvature, and whether it is used (default: off).
   */
  void SetCurvatureOpacity(vtkPiecewiseFunction* opacity);
  vtkSetMacro(UseCurvatureOpacity, bool);
  vtkGetMacro(UseCurvatureOpacity, bool);
  ///@}

  ///@{
  /**
   * Whether stills that are not screenshots take one step towards the levels that are wanted, and
   * not all: for a view that renders until vtkFlatBlockStatus says that it has converged. Of
   * several ranks none does. Default: off.
   */
  vtkSetMacro(Progressive, bool);
  vtkGetMacro(Progressive, bool);
  ///@}

  /**
   * What tells of the last frame, on processes that draw.
   */
  void SetStatus(vtkFlatBlockStatus* status);

  /**
   * What draws an image, the first one where there are several; nullptr where there is none.
   */
  vtkFlatBlockVolumeMapper* GetMapper(int piece = 0);

  void SetVisibility(bool isVisible) override;

protected:
  vtkFlatBlockVolumeRepresentation();
  ~vtkFlatBlockVolumeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  /**
   * Draws the point scalars, or the first point array, in gray where no array is chosen.
   */
  void UpdateMapperParameters() override;

private:
  vtkFlatBlockVolumeRepresentation(const vtkFlatBlockVolumeRepresentation&) = delete;
  void operator=(const vtkFlatBlockVolumeRepresentation&) = delete;

  vtkFlatBlockVolumeMapper* GetSettings() const;
  void KeepGhosts(vtkImageData* image);
  void ShowChosenArray();
  void ChooseComponent();
  void UpdateWanted();
  void CutGhostsOff();
  void ReleaseMemory();

  int Quality = CUSTOM;
  int MemoryLimit = 256;
  int Projection = 0;
  bool UseCurvatureColor = false;
  bool UseCurvatureOpacity = false;
  bool Progressive = false;
  vtkSmartPointer<vtkColorTransferFunction> CurvatureColor;
  vtkSmartPointer<vtkPiecewiseFunction> CurvatureOpacity;
  vtkNew<vtkFlatBlockVolumeMapper> Wanted; // settings and presets
  vtkNew<vtkFlatBlockPiecesMapper> Pieces; // what draws
  vtkNew<vtkVolumeProperty> GrayProperty;
  vtkDataArray* ShownInGray = nullptr; // only compared with
  vtkWeakPointer<vtkPVRenderView> View;
};

#endif
