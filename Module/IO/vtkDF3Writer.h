/**
 * @class   vtkDF3Writer
 * @brief   writes POV-Ray's density files (.df3)
 *
 * Of image data with scalars of one component: unsigned integers of 8, 16 or 32 bit, up to 65535
 * along an axis. Spacing and origin are left out.
 * An error leaves a file that was there as it was.
 *
 * @sa vtkDF3Reader
 */

#ifndef vtkDF3Writer_h
#define vtkDF3Writer_h

#include "vtkFlatBlockVolumeIOModule.h" // for the export macro
#include "vtkWriter.h"

class VTKFLATBLOCKVOLUMEIO_EXPORT vtkDF3Writer : public vtkWriter
{
public:
  static vtkDF3Writer* New();
  vtkTypeMacro(vtkDF3Writer, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where to write to.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkDF3Writer();
  ~vtkDF3Writer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkDF3Writer(const vtkDF3Writer&) = delete;
  void operator=(const vtkDF3Writer&) = delete;

  char* FileName = nullptr;
};

#endif
