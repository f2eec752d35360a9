/**
 * @class   vtkOpenGLFlatBlockTransferTable
 * @brief   a transfer function on the graphics card, with its integrals where they are asked for
 */

#ifndef vtkOpenGLFlatBlockTransferTable_h
#define vtkOpenGLFlatBlockTransferTable_h

#include "ComponentTable.h"
#include "MemoryCounter.h"
#include "vtkNew.h"
#include "vtkObject.h"

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkOpenGLFlatBlockTransferTable : public vtkObject
{
public:
  static vtkOpenGLFlatBlockTransferTable* New();
  vtkTypeMacro(vtkOpenGLFlatBlockTransferTable, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Counts what is allocated from now on.
   */
  void SetMemoryCounter(flatblock::MemoryCounter* counter) { this->Bytes.SetCounter(counter); }

  /**
   * Bytes that tables take, one after the other; only a single one may have integrals.
   */
  static vtkTypeInt64 GetBytes(const flatblock::ComponentTables& tables, bool hasIntegrals);

  /**
   * Sends tables to the graphics card.
   * @return whether it takes so many entries
   */
  bool Upload(
    vtkOpenGLRenderWindow* window, const flatblock::ComponentTables& tables, bool hasIntegrals);

  /**
   * Whether there is one, with integrals or without.
   */
  bool IsUploaded(bool hasIntegrals) const;

  /**
   * Whether sums of one float are too coarse for pieces of a ray of this length, in the unit of
   * length of the extinctions.
   */
  bool NeedsLongSums(double length) const;

  /**
   * The tables that were sent. Active until Deactivate().
   */
  void Activate(vtkShaderProgram* program, const flatblock::ComponentTables& tables);
  void Deactivate();

  /**
   * Releases what the next Upload() will allocate in another size.
   */
  void ReleaseIfStale(
    vtkWindow* window, const flatblock::ComponentTables& tables, bool hasIntegrals);
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkOpenGLFlatBlockTransferTable();
  ~vtkOpenGLFlatBlockTransferTable() override;

private:
  vtkOpenGLFlatBlockTransferTable(const vtkOpenGLFlatBlockTransferTable&) = delete;
  void operator=(const vtkOpenGLFlatBlockTransferTable&) = delete;

  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  flatblock::CountedBytes Bytes;
  bool HasIntegrals = false;
  double TotalDepth = 0.0; // over all entries
};

#endif
