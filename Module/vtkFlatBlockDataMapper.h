/**
 * @class   vtkFlatBlockDataMapper
 * @brief   abstract superclass of a volume mapper: what of its input is drawn, and where to
 *
 * Input: vtkImageData with two or more samples along each axis. Which array of it is drawn,
 * vtkAbstractMapper says: ScalarMode, SelectScalarArray(), ArrayAccessMode. Values of cells are
 * those in the cells' middle, linear in between, and the same up to the volume's faces; they are
 * copied, as are chosen components.
 *
 * Integers of 8 and 16 bit are kept as they are. All other types become 32-bit floats over the
 * data's own range: a value is off by at most 2^-24 of that range. Cells that have a NaN or an
 * infinite value at a corner, or a point that is blanked (vtkDataSetAttributes::HIDDENPOINT), are
 * not drawn, all others are unharmed; a warning counts such values once. Of cell data a blanked
 * cell counts as such a value.
 *
 * @sa vtkFlatBlockVolumeMapper
 */

#ifndef vtkFlatBlockDataMapper_h
#define vtkFlatBlockDataMapper_h

#include "vtkFlatBlockVolumeRenderingModule.h" // for the export macro
#include "vtkImageData.h"                      // for its smart pointer
#include "vtkSmartPointer.h"
#include "vtkVolumeMapper.h"

class VTKFLATBLOCKVOLUMERENDERING_EXPORT vtkFlatBlockDataMapper : public vtkVolumeMapper
{
public:
  vtkTypeMacro(vtkFlatBlockDataMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Takes over all settings of another mapper, but not its input.
   */
  void ShallowCopy(vtkAbstractMapper* other) override;

  enum VectorModes
  {
    DISABLED = -1,
    MAGNITUDE = 0,
    COMPONENT = 1
  };

  ///@{
  /**
   * What is drawn of an array of several components, as with vtkSmartVolumeMapper: Disabled
   * (default): all of them, 2 to 4 that are independent, or 2 or 4 that are not, as
   * vtkVolumeProperty::IndependentComponents says; an error where there are more, and for
   * isosurfaces and slices, or sums of dependent ones. They are classified after interpolation.
   * Independent ones have functions, ComponentWeights and materials of their own. Of others the
   * last one has the opacity of the first function; two have its colour, too, and four are colours
   * themselves: up to the largest value of their type where that is of 8 or 16 bit, else from 0
   * to 1. Levels by distortion are chosen by the component that opacity comes from, or that has the
   * most weight. Magnitude: their norm. Component: the one that VectorComponent says, 0 (default)
   * to 8; an error where the array has fewer.
   */
  vtkSetClampMacro(VectorMode, int, DISABLED, COMPONENT);
  vtkGetMacro(VectorMode, int);
  vtkSetClampMacro(VectorComponent, int, 0, 8);
  vtkGetMacro(VectorComponent, int);
  ///@}

  ///@{
  /**
   * Name of an array whose values are the rows of 2D transfer functions, over their range: of
   * points or cells, as the array that is drawn, with one component. None (default): rows are
   * magnitudes of gradients. An error where there is no such array, or the one that is drawn has
   * several components or a mask.
   */
  vtkSetStringMacro(Transfer2DYAxisArray);
  vtkGetStringMacro(Transfer2DYAxisArray);
  ///@}

  enum MaskTypes
  {
    BinaryMaskType,
    LabelMapMaskType
  };

  ///@{
  /**
   * A mask, of one component and as many points as there are values (cells, of cell data); none by
   * default. Its nearest value counts. Binary: where it is 0, nothing is drawn. LabelMap (default):
   * numbers of functions in vtkVolumeProperty::SetLabelColor() and SetLabelScalarOpacity(), up to
   * 255 of them; what has none of either, or is 0, has the default ones. An error with several
   * components, 2D functions or gradient opacities of labels; labels are drawn by composite
   * blending only.
   */
  virtual void SetMaskInput(vtkImageData* mask);
  vtkImageData* GetMaskInput() const { return this->MaskInput; }
  vtkSetClampMacro(MaskType, int, BinaryMaskType, LabelMapMaskType);
  vtkGetMacro(MaskType, int);
  void SetMaskTypeToBinary() { this->SetMaskType(BinaryMaskType); }
  void SetMaskTypeToLabelMap() { this->SetMaskType(LabelMapMaskType); }
  ///@}

  ///@{
  /**
   * How much a label's functions count, against the default ones: 0 to 1 (default).
   */
  vtkSetClampMacro(MaskBlendFactor, float, 0.0F, 1.0F);
  vtkGetMacro(MaskBlendFactor, float);
  ///@}

  ///@{
  /**
   * Whether rays are not drawn to the window, but kept for GetColorImage() and GetDepthImage(), as
   * with vtkGPUVolumeRayCastMapper. Default: off.
   */
  vtkSetMacro(RenderToImage, bool);
  vtkGetMacro(RenderToImage, bool);
  vtkBooleanMacro(RenderToImage, bool);
  ///@}

  ///@{
  /**
   * What the last frame with RenderToImage made of the renderer's viewport: RGBA of 8 bit,
   * multiplied by opacity; and depths as floats, those of the depth buffer, where a ray had
   * gathered an opacity of 3/255, and 1 where none did. Empty before there was one.
   */
  virtual void GetColorImage(vtkImageData* image) = 0;
  virtual void GetDepthImage(vtkImageData* image) = 0;
  ///@}

protected:
  vtkFlatBlockDataMapper();
  ~vtkFlatBlockDataMapper() override;

  int VectorMode = DISABLED;
  int VectorComponent = 0;
  char* Transfer2DYAxisArray = nullptr;
  vtkSmartPointer<vtkImageData> MaskInput;
  int MaskType = LabelMapMaskType;
  float MaskBlendFactor = 1.0F;
  bool RenderToImage = false;

private:
  vtkFlatBlockDataMapper(const vtkFlatBlockDataMapper&) = delete;
  void operator=(const vtkFlatBlockDataMapper&) = delete;
};

#endif
