/**
 * @class   vtkFlatBlockSkipMap
 * @brief   how far rays may leap in the volume, as a transfer function shows it
 *
 * Does nothing when its inputs have not changed.
 */

#ifndef vtkFlatBlockSkipMap_h
#define vtkFlatBlockSkipMap_h

#include "SkipMap.h"
#include "vtkObject.h"

class vtkFlatBlockBuilder;
class vtkFlatBlockTransferFunction;

class vtkFlatBlockSkipMap : public vtkObject
{
public:
  static vtkFlatBlockSkipMap* New();
  vtkTypeMacro(vtkFlatBlockSkipMap, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Cells of a cube's side: the fewest, from `fewest` on and by powers of two, that make a map
   * within some bytes and a texture's largest side; those of a block at most, or 0 where that is
   * too many cubes, too.
   */
  static int ChooseCells(
    const flatblock::BlockGrid& grid, int fewest, vtkTypeInt64 mostBytes, int largestTexture);
  static vtkTypeInt64 GetBytes(const flatblock::BlockGrid& grid, int cells);

  struct Settings
  {
    int Cells = 4;           ///< of a cube's side, as above
    int Coarsest = 0;        ///< level of detail that a brick has
    bool IsFiltered = false; ///< levels are means, not samples at a stride
    bool IsSpline = false;   ///< values between samples reach for those around
    bool LeapsMatter = true; ///< what is the same all over a cube is one leap
    double Tolerance = 0.0;  ///< values that are no further apart count as the same

    bool operator==(const Settings& other) const
    {
      return this->Cells == other.Cells && this->Coarsest == other.Coarsest &&
             this->IsFiltered == other.IsFiltered && this->IsSpline == other.IsSpline &&
             this->LeapsMatter == other.LeapsMatter && this->Tolerance == other.Tolerance;
    }
  };

  /**
   * A component that may be seen.
   */
  struct Part
  {
    vtkFlatBlockBuilder* Builder;
    vtkFlatBlockTransferFunction* Function;

    bool operator==(const Part& other) const
    {
      return this->Builder == other.Builder && this->Function == other.Function;
    }
  };

  /**
   * @param parts    of one grid, with settings that make no leaps over matter where they are
   * several
   * @param visible  of all blocks, 0: it has no brick
   * @param visibleTime  when that last changed
   */
  void Update(const std::vector<Part>& parts, const std::vector<std::uint8_t>& visible,
    vtkMTimeType visibleTime, const Settings& settings);

  const flatblock::SkipMap& Get() const { return this->Map; }

protected:
  vtkFlatBlockSkipMap() = default;
  ~vtkFlatBlockSkipMap() override = default;

private:
  vtkFlatBlockSkipMap(const vtkFlatBlockSkipMap&) = delete;
  void operator=(const vtkFlatBlockSkipMap&) = delete;

  void UpdateReach(vtkFlatBlockBuilder* builder, const Settings& settings,
    const flatblock::CubeGrid& grid, const flatblock::Coarsening& coarsening);

  flatblock::SkipMap Map;
  std::vector<Part> UsedParts; // only compared with
  Settings Used;
  std::vector<std::uint8_t> Reach; // of cubes, within the tolerance
  Settings ReachUsed;
  vtkTimeStamp ReachTime;
};

#endif
