/**
 * @class   vtkFlatBlockLevels
 * @brief   the level of detail of every block, and the shape of the atlas that holds them
 *
 * Does nothing when its inputs have not changed.
 */

#ifndef vtkFlatBlockLevels_h
#define vtkFlatBlockLevels_h

#include "BrickSource.h"
#include "FlatBlockVolumeView.h"
#include "LodSelector.h"
#include "vtkObject.h"

#include <string>
#include <vector>

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
  };

  /**
   * @param visible      for every block whether anything of it is drawn
   * @param visibleTime  when `visible` last changed
   * @throws std::runtime_error where not even the coarsest levels fit
   */
  void Update(const flatblock::BrickSource& source, const std::vector<std::uint8_t>& visible,
    vtkMTimeType visibleTime, const flatblock::VolumeView& view, const Limits& limits);

  /**
   * Of every block, flatblock::NoLevel where nothing is drawn.
   */
  const std::vector<std::int8_t>& GetLevels() const { return this->Selector.GetLevels(); }

  /**
   * Of every block, small for those that matter.
   */
  const std::vector<std::uint16_t>& GetOrder() const { return this->Order.GetBlocks(); }

  const flatblock::AtlasShape& GetShape() const { return this->Shape; }

  /**
   * Visible blocks that have another level in `levels`.
   */
  vtkTypeInt64 CountDifferences(const std::vector<std::int8_t>& levels) const;

protected:
  vtkFlatBlockLevels() = default;
  ~vtkFlatBlockLevels() override = default;

private:
  vtkFlatBlockLevels(const vtkFlatBlockLevels&) = delete;
  void operator=(const vtkFlatBlockLevels&) = delete;

  std::string DescribeTooLittleMemory(
    const Limits& limits, vtkTypeInt64 blocks, vtkTypeInt64 bytesPerTexel) const;

  bool UpdateShape(const flatblock::AtlasShape::Request& request);
  bool UpdateOrder(const flatblock::BlockGrid& grid, const std::vector<std::uint8_t>& visible,
    vtkMTimeType visibleTime, const flatblock::VolumeView& view);

  flatblock::AtlasShape::Request ShapeRequest;
  flatblock::AtlasShape Shape;
  flatblock::VolumeView View;
  std::vector<flatblock::BlockRank> Ranks;
  flatblock::RefinementOrder Order;
  flatblock::LodSelector Selector;
  vtkMTimeType VisibleTime = 0;
  int NumberOfLevels = 0;
};

#endif
