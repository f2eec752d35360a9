/**
 * @class   vtkFlatBlockScalars
 * @brief   the samples of a volume as blocks are built from them: one value after the other
 *
 * Point data of one component is handed on as it is. All else is copied: chosen components, values
 * of cells, with those of the outer ones repeated around, and points or cells that are blanked,
 * which become NaN. Does nothing when its inputs have not changed.
 */

#ifndef vtkFlatBlockScalars_h
#define vtkFlatBlockScalars_h

#include "BlockGrid.h"
#include "vtkDataArray.h" // for its smart pointer
#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace flatblock
{
struct VolumeInput;
}

class vtkFlatBlockScalars : public vtkObject
{
public:
  static vtkFlatBlockScalars* New();
  vtkTypeMacro(vtkFlatBlockScalars, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The norm of all components instead of one of them.
   */
  static constexpr int Magnitude = -1;

  /**
   * @param array      of the input
   * @param component  of the array, or Magnitude
   */
  void Update(const flatblock::VolumeInput& input, vtkDataArray* array, int component);

  /**
   * The input's mask: bytes, 0 where it is 0 or has a label that is not among these, and from 1 on
   * the place of the label; of a binary mask 1 where it is not 0.
   */
  void UpdateMask(const flatblock::VolumeInput& input, const std::vector<int>& labels);

  /**
   * Valid after Update(): the values, x fastest, and how many an axis.
   */
  vtkDataArray* GetValues() const { return this->Values; }
  const flatblock::Index3& GetSamples() const { return this->Samples; }

  /**
   * Values that were replaced by NaN.
   */
  vtkTypeInt64 GetNumberOfBlanked() const { return this->Blanked; }

  /**
   * Whether cells of point data are blanked, which takes no effect.
   */
  bool HasIgnoredBlanks() const { return this->IgnoredBlanks; }

protected:
  vtkFlatBlockScalars();
  ~vtkFlatBlockScalars() override;

private:
  vtkFlatBlockScalars(const vtkFlatBlockScalars&) = delete;
  void operator=(const vtkFlatBlockScalars&) = delete;

  vtkSmartPointer<vtkDataArray> Values;
  flatblock::Index3 Samples = { 0, 0, 0 };
  vtkTypeInt64 Blanked = 0;
  bool IgnoredBlanks = false;

  const void* BuiltSamples = nullptr; // only compared with
  vtkMTimeType BuiltImageTime = 0;
  int BuiltComponent = 0;
  std::vector<int> BuiltLabels;
  bool BuiltWithLabels = false;
};

#endif
