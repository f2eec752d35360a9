/**
 * @class   vtkFlatBlockLevels
 * @brief   the level of detail of every block, and the shape of the atlas that holds them
 *
 * Does nothing when its inputs have not changed.
 */

#ifndef vtkFlatBlockLevels_h
#define vtkFlatBlockLevels_h

#include "BrickSource.h"
#include "LodSelector.h"
#include "vtkObject.h"

#include <string>
#include <vector>

class vtkMatrix4x4;

class vtkFlatBlockLevels : public vtkObject
{
public:
  static vtkFlatBlockLevels* New();
  vtkTypeMacro(vtkFlatBlockLevels, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  struct Limits
  {
    vtkTypeInt64 MaxMemoryInBytes; ///< for everything on the graphics card
    vtkTypeInt64 BytesBesideAtlas; ///< that are taken by all that is not atlas
    int LargestTexture;            ///< texels a side that the driver allows
    int NumberOfLevels;            ///< levels that a block may have
    const double* PointOfInterest; ///< world coordinates
    const double* ViewPlanes;      ///< six in world coordinates, as vtkCamera gives them
    vtkMatrix4x4* SampleToWorld;
  };

  /**
   * @param visible      for every block whether anything of it is drawn
   * @param visibleTime  when `visible` last changed
   * @throws std::runtime_error where not even the coarsest levels fit
   */
  void Update(const flatblock::BrickSource& source, const std::vector<std::uint8_t>& visible,
    vtkMTimeType visibleTime, const Limits& limits);

  /**
   * Of every block, flatblock::NoLevel where nothing is drawn.
   */
  const std::vector<std::int8_t>& GetLevels() const { return this->Levels; }
  const flatblock::AtlasShape& GetShape() const { return this->Shape; }

  /**
   * Share of the visible blocks that have their level in `levels`, from 0 to 1.
   */
  double GetShareReached(const std::vector<std::int8_t>& levels) const;

protected:
  vtkFlatBlockLevels() = default;
  ~vtkFlatBlockLevels() override = default;

private:
  vtkFlatBlockLevels(const vtkFlatBlockLevels&) = delete;
  void operator=(const vtkFlatBlockLevels&) = delete;

  std::string DescribeTooLittleMemory(
    const Limits& limits, vtkTypeInt64 blocks, vtkTypeInt64 bytesPerTexel) const;

  flatblock::AtlasShape::Request ShapeRequest;
  flatblock::AtlasShape Shape;
  flatblock::LodCriteria Criteria;
  std::vector<std::int8_t> Levels;
  vtkMTimeType VisibleTime = 0;
};

#endif
