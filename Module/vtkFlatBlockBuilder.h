/**
 * @class   vtkFlatBlockBuilder
 * @brief   turns a volume's samples into blocks, their value ranges and a source of bricks
 *
 * Holds a reference to the samples, not a copy. Does nothing when its inputs have not changed.
 */

#ifndef vtkFlatBlockBuilder_h
#define vtkFlatBlockBuilder_h

#include "BlockRanges.h"
#include "BrickSource.h"
#include "CellRanges.h"
#include "CudaDistortion.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkFlatBlockScalars;

class vtkFlatBlockBuilder : public vtkObject
{
public:
  static vtkFlatBlockBuilder* New();
  vtkTypeMacro(vtkFlatBlockBuilder, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What the bricks of blocks are.
   */
  struct Bricks
  {
    flatblock::LevelFilter Filter = flatblock::LevelFilter::Subsample;
    int Bits = 0; ///< of a texel on its brick's scale; 0, and if samples aren't finite: as they are
    int Apron = 0;                ///< samples around the border
    bool MayBeSpline = false;     ///< values between samples reach for those around,
    bool MayInterpolate = false;  ///< and overshoot them
    bool AreCoefficients = false; ///< of the spline that interpolates; if all samples are finite

    bool operator==(const Bricks& other) const
    {
      return this->Filter == other.Filter && this->Bits == other.Bits &&
             this->Apron == other.Apron && this->HasRangesOf(other) &&
             this->AreCoefficients == other.AreCoefficients;
    }
    bool HasRangesOf(const Bricks& other) const
    {
      return this->MayBeSpline == other.MayBeSpline && this->MayInterpolate == other.MayInterpolate;
    }
  };

  /**
   * Cuts the image's scalars, one component and one tuple a point, into blocks. Other bricks of the
   * same blocks leave the time of modification.
   * @return whether anything was built anew
   */
  bool Update(vtkFlatBlockScalars* scalars, int blockSize, const Bricks& bricks);

  /**
   * Valid after Update(), until the image's samples change.
   */
  /// So that the next Update() builds everything.
  void Forget()
  {
    this->Quantized.reset();
    this->Source.reset();
  }

  const flatblock::BrickSource& GetSource() const
  {
    return this->Quantized ? *this->Quantized : *this->Source;
  }
  /// Of the texels that a block may show; a block without a finite sample has an extent below 0.
  std::vector<flatblock::TexelRange> GetTexelRanges() const;

  bool HasIntegers() const;
  /// Of finite samples.
  const std::vector<flatblock::ValueRange>& GetBlockRanges() const { return this->BlockRanges; }
  /// Of what is between them, too; and when these last changed.
  const std::vector<flatblock::ValueRange>& GetShownRanges() const { return this->ShownRanges; }
  vtkMTimeType GetShownTime() const { return this->ShownTime; }

  /**
   * Range of all finite samples; [0, 0] if there is none.
   */
  const flatblock::ValueRange& GetRange() const { return this->Range; }

  /**
   * Ranges of cubes of so many cells a side, and of what between their samples reaches for others,
   * on a scale. Computed where they are first asked for, and kept until another size is.
   */
  const std::vector<flatblock::CellRange>& GetCellRanges(int cells);

  /**
   * How far beyond the samples of a range, as a share of it, values between them may lie.
   */
  double GetOvershoot() const;
  const flatblock::CellScale& GetCellScale() const { return this->CellScale; }

  /**
   * Samples that are NaN or infinite.
   */
  vtkTypeInt64 GetNumberOfNonFiniteSamples() const { return this->NonFiniteSamples; }

  /**
   * How wrong some blocks look at the levels 1 to `levels`, as Distortion.h has it: `levels` values
   * for each of the blocks. By all threads where `threads` is 0.
   * @param useCuda  where that fails, the threads do it
   * @param summaries  one for each of the blocks, or none; the threads make them
   * @return empty, or why CUDA failed
   */
  std::string ComputeDistortion(const std::vector<std::int64_t>& blocks, int levels,
    const flatblock::ClassifiedTable& table, int threads, bool useCuda, float* distortion,
    flatblock::BlockSummary* summaries);

protected:
  vtkFlatBlockBuilder() = default;
  ~vtkFlatBlockBuilder() override = default;

private:
  vtkFlatBlockBuilder(const vtkFlatBlockBuilder&) = delete;
  void operator=(const vtkFlatBlockBuilder&) = delete;

  template <typename T>
  std::string ComputeDistortionOf(const T* samples, const std::vector<std::int64_t>& blocks,
    int levels, const flatblock::ClassifiedTable& table, int threads, bool useCuda,
    float* distortion, flatblock::BlockSummary* summaries);
  std::vector<flatblock::ValueRange> WidenRanges(int blocksAround, double overshoot) const;
  bool AreBlocksCurrent(vtkFlatBlockScalars* scalars, int blockSize) const;
  void BuildBlocks(vtkFlatBlockScalars* scalars, int blockSize);

  template <typename T>
  void BuildRanges(const T* samples);

  template <typename T>
  void BuildSource(const T* samples);

  void Quantize();

  template <typename T>
  void BuildCellRanges(const T* samples, int cells, const flatblock::Index3& count);

  vtkSmartPointer<vtkDataArray> Scalars;
  flatblock::BlockGrid Grid;
  std::unique_ptr<flatblock::BrickSource> Source;
  std::unique_ptr<flatblock::BrickSource> Quantized; // of it
  std::vector<flatblock::ValueRange> BlockRanges;
  std::vector<flatblock::ValueRange> ShownRanges;
  vtkTimeStamp ShownTime;
  flatblock::ValueRange Range;
  std::vector<flatblock::CellRange> CellRanges;
  flatblock::CellScale CellScale;
  int CellsPerRange = 0; // 0: there are none
  vtkTypeInt64 NonFiniteSamples = 0;
  flatblock::CudaDistortion Cuda;

  const vtkFlatBlockScalars* BuiltScalars = nullptr; // only compared with
  vtkMTimeType BuiltTime = 0;
  int BuiltBlockSize = 0;
  Bricks BuiltBricks;
};

#endif
