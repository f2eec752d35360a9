/**
 * @class   vtkFlatBlockShadingMapper
 * @brief   abstract superclass of a volume mapper: what light does where the property shades
 *
 * @sa vtkFlatBlockVolumeMapper
 */

#ifndef vtkFlatBlockShadingMapper_h
#define vtkFlatBlockShadingMapper_h

#include "vtkFlatBlockDataMapper.h"
#include "vtkFlatBlockVolumeRenderingModule.h" // for the export macro
#include "vtkVersionMacros.h"                  // for what VTK has itself

class VTKFLATBLOCKVOLUMERENDERING_EXPORT vtkFlatBlockShadingMapper : public vtkFlatBlockDataMapper
{
public:
  vtkTypeMacro(vtkFlatBlockShadingMapper, vtkFlatBlockDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  void ShallowCopy(vtkAbstractMapper* other) override;

  ///@{
  /**
   * Opacity, as far as it is seen, that a piece of a ray must have for its light to be computed
   * where the property shades, from 0 to 1: below it the light of the piece before is taken.
   * Default: 0, exact.
   */
  vtkSetClampMacro(ShadingOpacityThreshold, double, 0.0, 1.0);
  vtkGetMacro(ShadingOpacityThreshold, double);
  ///@}

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  ///@{
  /**
   * Whether light falls on surfaces of the same opacity, and not of the same value: in a composite
   * of one component. Default: off. From VTK 9.2 on, vtkVolumeMapper has this.
   */
  vtkSetMacro(ComputeNormalFromOpacity, bool);
  vtkGetMacro(ComputeNormalFromOpacity, bool);
  vtkBooleanMacro(ComputeNormalFromOpacity, bool);
  ///@}
#else
  ///@{
  /**
   * How much of the light the volume scatters itself, by the property's ScatteringAnisotropy
   * (Henyey and Greenstein 1941), as vtkGPUVolumeRayCastMapper of VTK 9.2 has it: from 0 (default),
   * where only surfaces reflect it, by way of 1, where surfaces stand out only by steep gradients,
   * to 2, where there are none. Such light is absorbed on its way to where it is scattered, as far
   * from there as GlobalIlluminationReach says: from 0 (default), nowhere, to 1, where the volume's
   * box is 1 long along each axis. In a composite of one component with one function, without a
   * mask. What is clipped or cropped away absorbs nothing; what is out of view does. All of a
   * ray's pieces are lit, whatever ShadingOpacityThreshold says.
   */
  vtkSetClampMacro(VolumetricScatteringBlending, float, 0.0F, 2.0F);
  vtkGetMacro(VolumetricScatteringBlending, float);
  vtkSetClampMacro(GlobalIlluminationReach, float, 0.0F, 1.0F);
  vtkGetMacro(GlobalIlluminationReach, float);
  ///@}
#endif

protected:
  vtkFlatBlockShadingMapper();
  ~vtkFlatBlockShadingMapper() override;

  double ShadingOpacityThreshold = 0.0;
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  bool ComputeNormalFromOpacity = false;
#else
  float VolumetricScatteringBlending = 0.0F;
  float GlobalIlluminationReach = 0.0F;
#endif

private:
  vtkFlatBlockShadingMapper(const vtkFlatBlockShadingMapper&) = delete;
  void operator=(const vtkFlatBlockShadingMapper&) = delete;
};

#endif
