/**
 * @class   vtkFlatBlockStatus
 * @brief   what the last frame of a Flat-block Volume was made of, where it is drawn
 *
 * Lives on the processes that render, and not on a client: so that what a client asks for is what
 * the first of these tells.
 */

#ifndef vtkFlatBlockStatus_h
#define vtkFlatBlockStatus_h

#include "vtkFlatBlockVolumeRepresentationModule.h" // for the export macro
#include "vtkObject.h"
#include "vtkWeakPointer.h" // for what is drawn

#include <string> // for the text

class vtkFlatBlockPiecesMapper;

class VTKFLATBLOCKVOLUMEREPRESENTATION_EXPORT vtkFlatBlockStatus : public vtkObject
{
public:
  static vtkFlatBlockStatus* New();
  vtkTypeMacro(vtkFlatBlockStatus, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetPieces(vtkFlatBlockPiecesMapper* pieces);

  /**
   * 1 where all blocks have the level that is wanted, or nothing is drawn; else 0.
   */
  int GetConverged();

  /**
   * Of visible blocks those that have it, in percent.
   */
  int GetProgress();

  /**
   * Lines for people: memory, levels, distortion, time.
   */
  const char* GetText();

protected:
  vtkFlatBlockStatus();
  ~vtkFlatBlockStatus() override;

private:
  vtkFlatBlockStatus(const vtkFlatBlockStatus&) = delete;
  void operator=(const vtkFlatBlockStatus&) = delete;

  vtkWeakPointer<vtkFlatBlockPiecesMapper> Pieces;
  std::string Text;
};

#endif
