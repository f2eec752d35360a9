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

  /**
   * @param visible       of all blocks, 0: it has no brick; follows from the two before
   * @param cells         of a cube's side, as above, not 0
   * @param coarsest      level of detail that a brick has
   * @param areFiltered   levels are means, not samples at a stride
   * @param skipsMatter   whether what is the same all over a cube is one leap
   */
  void Update(vtkFlatBlockBuilder* builder, vtkFlatBlockTransferFunction* function,
    const std::vector<std::uint8_t>& visible, int cells, int coarsest, bool areFiltered,
    bool skipsMatter);

  const flatblock::SkipMap& Get() const { return this->Map; }
  vtkGetMacro(Cells, int);

protected:
  vtkFlatBlockSkipMap() = default;
  ~vtkFlatBlockSkipMap() override = default;

private:
  vtkFlatBlockSkipMap(const vtkFlatBlockSkipMap&) = delete;
  void operator=(const vtkFlatBlockSkipMap&) = delete;

  flatblock::SkipMap Map;
  int Cells = 0;
  flatblock::Coarsening Coarsening;
  bool SkipsMatter = true;
};

#endif
