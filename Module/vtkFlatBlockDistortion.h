/**
 * @class   vtkFlatBlockDistortion
 * @brief   how wrong each block looks at each level of detail
 *
 * Follows edits of the transfer function: only blocks whose values meet the part that has changed
 * are computed again, as many at a time as is asked for, those first that could be most wrong.
 * Blocks that wait have their last value, or a guess where there is none.
 */

#ifndef vtkFlatBlockDistortion_h
#define vtkFlatBlockDistortion_h

#include "Distortion.h"
#include "RefinementOrder.h"
#include "vtkObject.h"

#include <string>
#include <utility>
#include <vector>

class vtkFlatBlockBuilder;

class vtkFlatBlockDistortion : public vtkObject
{
public:
  static vtkFlatBlockDistortion* New();
  vtkTypeMacro(vtkFlatBlockDistortion, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Takes over a table, and finds out what has to be computed.
   * @param tableTime  when it was built
   * @param levels     how many levels from 1 on have a value, at least 1
   * @param summarize  whether each block is looked at once, and all values are estimates from what
   *                   was kept of it then
   * @param usesCuda   whether it computes: values of two backends are not mixed
   */
  void SetTable(vtkFlatBlockBuilder* builder, const flatblock::ClassifiedTable& table,
    vtkMTimeType tableTime, int levels, bool summarize, bool usesCuda);

  /**
   * Computes up to so many blocks that wait, by all threads where `threads` is 0.
   * @param useCuda  on the first device that answers; where that fails, the threads do it
   * @return empty, or why CUDA failed
   */
  std::string Compute(vtkFlatBlockBuilder* builder, vtkTypeInt64 blocks, int threads, bool useCuda);

  /**
   * Whether no block waits.
   */
  bool IsComplete() const { return this->Waiting.empty(); }

  /**
   * Of all blocks. Valid until anything here changes.
   */
  flatblock::BlockDistortion Get(bool perByte) const
  {
    return { this->Values.data(), this->Levels, perByte };
  }

  /**
   * Of one block at a level; at levels beyond those that have a value, the coarsest that has one.
   */
  float GetValue(std::size_t block, int level) const;

  /**
   * Bytes of what is kept of the blocks.
   */
  vtkTypeInt64 GetSummaryBytes() const;

protected:
  vtkFlatBlockDistortion() = default;
  ~vtkFlatBlockDistortion() override = default;

private:
  vtkFlatBlockDistortion(const vtkFlatBlockDistortion&) = delete;
  void operator=(const vtkFlatBlockDistortion&) = delete;

  void StartAnew(vtkFlatBlockBuilder* builder, int levels, bool summarize);
  void Estimate(std::size_t block);
  void FindWaiting(vtkFlatBlockBuilder* builder, const std::pair<double, double>& changed);

  flatblock::ClassifiedTable Table;
  std::vector<float> Values;                      // by block and level
  std::vector<flatblock::BlockSummary> Summaries; // of each block, or none
  std::vector<float> Bounds;                      // what a block could contribute at most
  std::vector<std::uint8_t> HasValue;  // by block: an exact value, of this table or an older one
  std::vector<vtkTypeInt64> Waiting;   // the one that could be most wrong at the end
  std::vector<std::uint8_t> IsWaiting; // by block
  vtkMTimeType BuilderTime = 0;
  vtkMTimeType TableTime = 0;
  int Levels = 1;
  bool Summarizes = false;
  bool UsesCuda = false;
};

#endif
