/**
 * @class   vtkDF3Reader
 * @brief   reads POV-Ray's density files (.df3)
 *
 * Samples of 8, 16 or 32 bit become unsigned integers of as many; the width follows from the size
 * of the file. Extents are read as they are asked for. A file that is not as it should be gives one
 * error that names it, the byte and what was expected there, and no data.
 *
 * @sa vtkDF3Writer
 */

#ifndef vtkDF3Reader_h
#define vtkDF3Reader_h

#include "vtkFlatBlockVolumeIOModule.h" // for the export macro
#include "vtkImageReader2.h"

class VTKFLATBLOCKVOLUMEIO_EXPORT vtkDF3Reader : public vtkImageReader2
{
public:
  static vtkDF3Reader* New();
  vtkTypeMacro(vtkDF3Reader, vtkImageReader2);

  /**
   * 3 where the file's header and size fit each other, else 0.
   */
  int CanReadFile(const char* file) override;

  /**
   * vtkErrorCode::FileFormatError after an error, which a pipeline then has nothing to add to.
   */
  unsigned long GetErrorCode() override;

  const char* GetFileExtensions() override { return ".df3"; }
  const char* GetDescriptiveName() override { return "POV-Ray density file"; }

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkDF3Reader();
  ~vtkDF3Reader() override;

  void ExecuteInformation() override;
  void ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* info) override;

private:
  vtkDF3Reader(const vtkDF3Reader&) = delete;
  void operator=(const vtkDF3Reader&) = delete;

  bool HasFailed = false;
};

#endif
