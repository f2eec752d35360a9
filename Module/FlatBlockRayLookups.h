/// What rays look up beside bricks: textures of the transfer function, of the map of leaps, of the
/// bricks' ranges, and of what depends on derivatives.
#pragma once

#include "BrickSource.h"
#include "ComponentTable.h"
#include "FunctionTable.h"
#include "MemoryCounter.h"
#include "RaySampling.h"
#include "SkipMap.h"
#include "vtkIndent.h"
#include "vtkNew.h"
#include "vtkOpenGLFlatBlockBrickRanges.h"
#include "vtkOpenGLFlatBlockFunctionTexture.h"
#include "vtkOpenGLFlatBlockSkipTexture.h"
#include "vtkOpenGLFlatBlockTransferTable.h"
#include "vtkType.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace flatblock
{
/// Bytes of what the next frame uploads.
struct LookupBytes
{
  vtkTypeInt64 SkipMap;
  vtkTypeInt64 OfGradients;
  vtkTypeInt64 OfCurvature;
  vtkTypeInt64 BrickRanges;
};

class RayLookups
{
public:
  RayLookups();
  ~RayLookups();
  RayLookups(const RayLookups&) = delete;
  void operator=(const RayLookups&) = delete;

  /// Counts what is allocated from now on.
  void SetMemoryCounter(MemoryCounter* counter);

  /// Releases what will be allocated in another size, so that its memory is free before.
  void ReleaseStale(vtkWindow* window, const ComponentTables& tables, const LookupBytes& bytes,
    const RaySampling& sampling);

  /// Bytes of transfer functions.
  static vtkTypeInt64 GetTableBytes(const ComponentTables& tables, const RaySampling& sampling);

  /// Sends transfer functions to the graphics card: with their integrals where segments are
  /// integrated.
  /// @return whether the graphics card takes so many entries
  bool SetTransferTable(
    vtkOpenGLRenderWindow* window, const ComponentTables& tables, const RaySampling& sampling);
  bool HasTransferTable(const RaySampling& sampling) const;

  /// The same for a map of leaps, where the sampling has one.
  /// @return whether the driver had memory for it
  bool SetSkipMap(vtkOpenGLRenderWindow* window, const SkipMap& map, const RaySampling& sampling);
  bool HasSkipMap() const;

  /// The same for the scales of bricks, of which a source may have none.
  bool SetBrickRanges(vtkOpenGLRenderWindow* window, const std::vector<TexelRange>& ranges);
  bool HasBrickRanges() const;

  /// The same for what depends on gradients, or on curvature, which may be nothing.
  enum Function
  {
    OF_GRADIENTS,
    OF_CURVATURE
  };
  bool SetFunction(vtkOpenGLRenderWindow* window, Function function, const FunctionTable& table);
  bool HasFunction(Function function) const;

  /// Whether the transfer function's sums need more digits than one float has, for such pieces.
  bool NeedsLongSums(const RaySampling& sampling) const;

  /// For a program of that sampling.
  void Activate(
    vtkShaderProgram* program, const ComponentTables& tables, const RaySampling& sampling);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);
  void Print(ostream& os, vtkIndent indent) const;

private:
  vtkNew<vtkOpenGLFlatBlockTransferTable> TransferTable;
  vtkNew<vtkOpenGLFlatBlockSkipTexture> SkipTexture;
  vtkNew<vtkOpenGLFlatBlockBrickRanges> BrickRanges;
  vtkNew<vtkOpenGLFlatBlockFunctionTexture> Functions[2];
};
} // namespace flatblock
