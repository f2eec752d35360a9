/**
 * @class   vtkPVMWriter
 * @brief   writes S. Roettger's volume files (.pvm)
 *
 * Of image data with scalars of one component: unsigned integers of 8 or 16 bit. The origin
 * is left out.
 * An error leaves a file that was there as it was.
 *
 * @sa vtkPVMReader
 */

#ifndef vtkPVMWriter_h
#define vtkPVMWriter_h

#include "vtkFlatBlockVolumeIOModule.h" // for the export macro
#include "vtkWriter.h"

class VTKFLATBLOCKVOLUMEIO_EXPORT vtkPVMWriter : public vtkWriter
{
public:
  static vtkPVMWriter* New();
  vtkTypeMacro(vtkPVMWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where to write to.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Whether samples are compressed to a differential data stream (default: on).
   */
  vtkSetMacro(Compressed, bool);
  vtkGetMacro(Compressed, bool);
  vtkBooleanMacro(Compressed, bool);
  ///@}

protected:
  vtkPVMWriter();
  ~vtkPVMWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkPVMWriter(const vtkPVMWriter&) = delete;
  void operator=(const vtkPVMWriter&) = delete;

  char* FileName = nullptr;
  bool Compressed = true;
};

#endif
