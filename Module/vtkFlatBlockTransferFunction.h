/**
 * @class   vtkFlatBlockTransferFunction
 * @brief   samples the functions of a vtkVolumeProperty into a table
 *
 * Does nothing when its inputs have not changed.
 */

#ifndef vtkFlatBlockTransferFunction_h
#define vtkFlatBlockTransferFunction_h

#include "Blending.h"
#include "BlockRanges.h"
#include "ClassifiedTable.h"
#include "TransferTable.h"
#include "vtkObject.h"
#include "vtkTimeStamp.h"

class vtkVolumeProperty;

class vtkFlatBlockTransferFunction : public vtkObject
{
public:
  static vtkFlatBlockTransferFunction* New();
  vtkTypeMacro(vtkFlatBlockTransferFunction, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Samples colour and scalar opacity of a component over `range`, as the extinction of
   * `unitOfLength`; where blending is not composite, as that of the length 1. Has entries at every
   * integer of ranges up to 8191, and as many as the nodes of the functions ask for, from 1024 to
   * 8192.
   * @param fewestEntries  that the table has, whatever else
   * @return whether the table was built anew
   * @throws std::runtime_error where a node of the functions is not a number
   */
  bool Update(vtkVolumeProperty* property, int component, const flatblock::ValueRange& range,
    double unitOfLength, const flatblock::Blending& blending, int fewestEntries = 2);

  /**
   * Entries that a table has otherwise.
   */
  static int CountEntries(
    vtkVolumeProperty* property, int component, const flatblock::ValueRange& range);

  /**
   * Samples the same as people see it, with the opacity of the unit distance: so it does not depend
   * on the step. With an entry for every integer of the range, or else with 4096.
   */
  void UpdateClassified(vtkVolumeProperty* property, int component,
    const flatblock::ValueRange& range, bool everyInteger);

  const flatblock::ClassifiedTable& GetClassifiedTable() const { return this->Classified; }
  vtkMTimeType GetClassifiedTime() const { return this->ClassifiedTime.GetMTime(); }

  const flatblock::TransferTable& GetTable() const { return this->Table; }

  /**
   * Which values make a difference.
   */
  const flatblock::TransferTable& GetDecisiveValues() const { return this->DecisiveValues; }

protected:
  vtkFlatBlockTransferFunction() = default;
  ~vtkFlatBlockTransferFunction() override = default;

private:
  vtkFlatBlockTransferFunction(const vtkFlatBlockTransferFunction&) = delete;
  void operator=(const vtkFlatBlockTransferFunction&) = delete;

  flatblock::TransferTable Table;
  flatblock::TransferTable DecisiveValues;

  vtkVolumeProperty* BuiltProperty = nullptr; // only compared with
  int BuiltComponent = 0;
  vtkMTimeType BuiltTime = 0;
  double BuiltUnit = 0.0;
  int BuiltFewest = 0;
  flatblock::Blending BuiltBlending;

  flatblock::ClassifiedTable Classified;
  vtkTimeStamp ClassifiedTime;
  vtkMTimeType ClassifiedEdit = 0;
  vtkVolumeProperty* ClassifiedProperty = nullptr; // only compared with
  int ClassifiedComponent = 0;
};

#endif
