/**
 * @class   vtkFlatBlockTransferFunction
 * @brief   samples the functions of a vtkVolumeProperty into a table
 *
 * Does nothing when its inputs have not changed.
 */

#ifndef vtkFlatBlockTransferFunction_h
#define vtkFlatBlockTransferFunction_h

#include "BlockRanges.h"
#include "TransferTable.h"
#include "vtkObject.h"

class vtkVolumeProperty;

class vtkFlatBlockTransferFunction : public vtkObject
{
public:
  static vtkFlatBlockTransferFunction* New();
  vtkTypeMacro(vtkFlatBlockTransferFunction, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Samples colour and scalar opacity of the first component over `range`, with the opacity of one
   * step of length `step`. Has entries at every integer of ranges up to 8191, and as many as the
   * nodes of the functions ask for, from 1024 to 8192.
   * @return whether the table was built anew
   */
  bool Update(vtkVolumeProperty* property, const flatblock::ValueRange& range, double step);

  const flatblock::TransferTable& GetTable() const { return this->Table; }

protected:
  vtkFlatBlockTransferFunction() = default;
  ~vtkFlatBlockTransferFunction() override = default;

private:
  vtkFlatBlockTransferFunction(const vtkFlatBlockTransferFunction&) = delete;
  void operator=(const vtkFlatBlockTransferFunction&) = delete;

  flatblock::TransferTable Table;

  vtkVolumeProperty* BuiltProperty = nullptr; // only compared with
  vtkMTimeType BuiltTime = 0;
  double BuiltStep = 0.0;
};

#endif
