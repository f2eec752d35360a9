/**
 * @class   vtkFlatBlockGradientFunction
 * @brief   gradient opacity, or the 2D transfer function, of a property as a table
 *
 * Does nothing when its inputs have not changed.
 */

#ifndef vtkFlatBlockGradientFunction_h
#define vtkFlatBlockGradientFunction_h

#include "BlockRanges.h"
#include "FunctionTable.h"
#include "vtkObject.h"

#include <array>
#include <vector>

class vtkImageData;
class vtkVolumeProperty;

namespace flatblock
{
/// Whether opacity of one of the first components depends on gradients; and whether colours do,
/// too.
bool HasGradientOpacity(vtkVolumeProperty* property, int components = 1);
bool HasTwoDimensions(vtkVolumeProperty* property);

/// Red, green, blue and opacity of a 2D function, x fastest: from 0 to 1, which unsigned char are
/// scaled to.
/// @throws std::runtime_error where it is no image of them
std::vector<std::array<float, 4>> GetTwoDimensionalColors(vtkImageData* image);
} // namespace flatblock

class vtkFlatBlockGradientFunction : public vtkObject
{
public:
  static vtkFlatBlockGradientFunction* New();
  vtkTypeMacro(vtkFlatBlockGradientFunction, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * @param ranges        of all components
   * @param isForEach      whether each component has its own function, or all have the first one
   * @param unitOfLength   of extinctions
   * @throws std::runtime_error where the 2D function is none that can be drawn
   */
  void Update(vtkVolumeProperty* property, const std::vector<flatblock::ValueRange>& ranges,
    bool isForEach, double unitOfLength);

  const flatblock::FunctionTable& GetTable() const { return this->Table; }

protected:
  vtkFlatBlockGradientFunction() = default;
  ~vtkFlatBlockGradientFunction() override = default;

private:
  vtkFlatBlockGradientFunction(const vtkFlatBlockGradientFunction&) = delete;
  void operator=(const vtkFlatBlockGradientFunction&) = delete;

  flatblock::FunctionTable Table;

  vtkVolumeProperty* BuiltProperty = nullptr; // only compared with
  vtkMTimeType BuiltTime = 0;
  double BuiltUnit = 0.0;
  std::vector<double> BuiltSpans;
  bool BuiltForEach = false;
};

#endif
