/**
 * @class   vtkPVMReader
 * @brief   reads S. Roettger's volume files (.pvm)
 *
 * PVM, PVM2 and PVM3, plain or compressed to a differential data stream (DDS v3d and v3e), samples
 * of 8 and 16 bit as unsigned integers of as many. Of plain files extents are read as they are
 * asked for; compressed ones are decoded wholly. Texts that follow the samples are left out. A file
 * that is not as it should be gives one error that names it, the byte and what was expected there,
 * and no data.
 *
 * @sa vtkPVMWriter
 */

#ifndef vtkPVMReader_h
#define vtkPVMReader_h

#include "vtkFlatBlockVolumeIOModule.h" // for the export macro
#include "vtkImageReader2.h"

class VTKFLATBLOCKVOLUMEIO_EXPORT vtkPVMReader : public vtkImageReader2
{
public:
  static vtkPVMReader* New();
  vtkTypeMacro(vtkPVMReader, vtkImageReader2);

  /**
   * 3 where the file has a header of the kind, else 0.
   */
  int CanReadFile(const char* file) override;

  /**
   * vtkErrorCode::FileFormatError after an error, which a pipeline then has nothing to add to.
   */
  unsigned long GetErrorCode() override;

  const char* GetFileExtensions() override { return ".pvm"; }
  const char* GetDescriptiveName() override { return "PVM volume"; }

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkPVMReader();
  ~vtkPVMReader() override;

  void ExecuteInformation() override;
  void ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* info) override;

private:
  vtkPVMReader(const vtkPVMReader&) = delete;
  void operator=(const vtkPVMReader&) = delete;

  void Fail(const char* problem);
  void Decode(vtkDataObject* output, vtkInformation* info);

  bool HasFailed = false;
  bool IsCompressed = false;
};

#endif
