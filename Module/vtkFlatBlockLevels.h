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
    vtkTypeInt64 MaxAtlasBytes;    ///< that the graphics card turned out to have
    int LargestTexture;            ///< texels a side that the driver allows
    int NumberOfLevels;            ///< levels that a block may have
  };

  enum class Criterion
  {
    Distance,
    Distortion,
    DistortionAndDistance
  };

  struct Blocks
  {
    const std::vector<std::uint8_t>* Visible; ///< for every block whether anything of it is drawn
    vtkMTimeType VisibleTime;                 ///< when that last changed
    flatblock::BlockDistortion Distortion;    ///< where the criterion asks for it
    vtkMTimeType DistortionTime;
    vtkMTimeType WeightsTime; ///< of its weights, 0 where there are none
  };

  /**
   * Finds the shape of the atlas.
   * @return whether not all visible blocks fit it at their finest level
   */
  bool UpdateShape(const flatblock::BrickSource& source, const std::vector<std::uint8_t>& visible,
    const Limits& limits);

  /**
   * Chooses the levels, after UpdateShape().
   * @throws std::runtime_error where not even the coarsest levels fit
   */
  void Update(const flatblock::BrickSource& source, const Blocks& blocks, Criterion criterion,
    const flatblock::VolumeView& view, const Limits& limits);

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

  bool UpdateOrder(const flatblock::BlockGrid& grid, const Blocks& blocks, Criterion criterion,
    const flatblock::VolumeView& view);

  flatblock::AtlasShape::Request ShapeRequest;
  flatblock::AtlasShape Shape;
  flatblock::VolumeView View;
  std::vector<flatblock::BlockRank> Ranks;
  flatblock::RefinementOrder Order;
  flatblock::LodSelector Selector;
  Blocks Ordered = {}; // what Order was made of; only compared with
  Criterion OrderCriterion = Criterion::Distance;
  bool IsNewShape = true;
  int NumberOfLevels = 0;
};

#endif
