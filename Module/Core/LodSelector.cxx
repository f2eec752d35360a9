#include "LodSelector.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>

namespace flatblock
{
namespace
{
// How much of the atlas is taken.
class Occupancy
{
public:
  Occupancy(const AtlasShape& shape, int coarsest, std::int64_t blocks)
    : Shape(&shape), Bricks(shape.GetNumberOfLevels(), 0), Slabs(Bricks)
  {
    this->Add(coarsest, blocks);
  }

  bool Fits() const { return this->Depth <= this->Shape->GetDepth(); }

  std::int64_t GetDepth() const { return this->Depth; }

  // Whether it fits whatever slabs are begun, and however it came about.
  bool FitsForSure() const
  {
    double depth = 0.0;
    for (int level = 0; level < this->Shape->GetNumberOfLevels(); ++level)
    {
      const auto perSlab = static_cast<double>(this->Shape->GetBricksPerSlab(level));
      const double slabs = static_cast<double>(this->Bricks[level]) / perSlab + 1.0;
      depth += slabs * this->Shape->GetSide(level);
    }
    return depth <= this->Shape->GetDepth();
  }

  void Add(int level, std::int64_t bricks)
  {
    this->Bricks[level] += bricks;
    const std::int64_t perSlab = this->Shape->GetBricksPerSlab(level);
    const std::int64_t slabs = (this->Bricks[level] + perSlab - 1) / perSlab;
    this->Depth += (slabs - this->Slabs[level]) * this->Shape->GetSide(level);
    this->Slabs[level] = slabs;
  }

  void Refine(int level, std::int64_t blocks)
  {
    this->Add(level, -blocks);
    this->Add(level - 1, blocks);
  }

  bool RefineIfFits(int level)
  {
    this->Refine(level, 1);
    if (this->Fits())
    {
      return true;
    }
    this->Refine(level, -1);
    return false;
  }

private:
  const AtlasShape* Shape;
  std::vector<std::int64_t> Bricks;
  std::vector<std::int64_t> Slabs;
  std::int64_t Depth = 0;
};

// The coarsest level that is needed for all visible blocks to fit; none if there is no such level.
std::optional<int> FindCoarsest(const AtlasShape& shape, std::int64_t blocks, int numberOfLevels)
{
  const int levels = shape.GetNumberOfLevels();
  for (int level = std::clamp(numberOfLevels, 1, levels) - 1; level < levels; ++level)
  {
    if (Occupancy(shape, level, blocks).Fits())
    {
      return level;
    }
  }
  return {};
}

// Blocks in their order, read where they are needed.
class BlockQueue
{
public:
  BlockQueue(const std::vector<std::uint16_t>& numbers, const std::vector<std::int32_t>& counts)
    : Numbers(numbers), Counts(counts), First(counts.size(), -1)
  {
  }

  // The blocks that have this number, in the order of the grid.
  const std::int64_t* GetBlocks(int number)
  {
    if (this->First[number] < 0)
    {
      this->Read(number);
    }
    return this->Blocks.data() + this->First[number];
  }

  int GetCount(int number) const { return this->Counts[number]; }
  int GetNumber(std::int64_t block) const { return this->Numbers[block]; }

private:
  // Reads on from this number, each time more.
  void Read(int number)
  {
    const auto begin = static_cast<std::int64_t>(this->Blocks.size());
    const std::int64_t wanted = std::max<std::int64_t>(16384, begin);
    std::int64_t end = begin;
    int last = number;
    for (; last < RefinementOrder::Never && this->First[last] < 0 && end - begin < wanted; ++last)
    {
      this->First[last] = static_cast<std::int32_t>(end);
      end += this->Counts[last];
    }
    this->Blocks.resize(static_cast<std::size_t>(end));
    std::vector<std::int32_t> next(this->First.begin() + number, this->First.begin() + last);
    const std::uint16_t* numbers = this->Numbers.data();
    const auto blocks = static_cast<std::int64_t>(this->Numbers.size());
    const auto range = static_cast<unsigned int>(last - number);
    for (std::int64_t block = 0; block < blocks; ++block)
    {
      const unsigned int i = numbers[block] - static_cast<unsigned int>(number);
      if (i < range)
      {
        this->Blocks[next[i]++] = block;
      }
    }
  }

  const std::vector<std::uint16_t>& Numbers;
  const std::vector<std::int32_t>& Counts;
  std::vector<std::int32_t> First; // in Blocks, -1: not read yet
  std::vector<std::int64_t> Blocks;
};

// The first block in the order that was not refined from a level.
struct Front
{
  int Number = 0;
  int Index = 0; // among the blocks of that number
};

class Greedy
{
public:
  Greedy(const RefinementOrder& order, const AtlasShape& shape, int coarsest, std::int64_t blocks,
    const std::vector<std::vector<std::int32_t>>& counts)
    : Order(order), Coarsest(coarsest), Taken(shape, coarsest, blocks)
  {
    for (int sequence = 0; sequence < order.GetNumberOfSequences(); ++sequence)
    {
      this->Queues.emplace_back(order.GetNumbers(sequence), counts[sequence]);
    }
  }

  // Up to the last time before which everything fits for sure.
  void RefineAtOnce(const std::vector<std::vector<std::int32_t>>& counts)
  {
    Sums before;
    for (const auto& sequence : counts)
    {
      before.emplace_back(sequence.size(), 0);
      std::partial_sum(sequence.begin(), sequence.end() - 1, before.back().begin() + 1);
    }
    int time = this->FindLast(0,
      [&](int t)
      {
        Occupancy taken = this->Taken;
        this->RefineUntil(t, before, taken);
        return taken.FitsForSure();
      });
    for (int last = -1; last < time;)
    {
      this->Taken = this->Start;
      this->RefineUntil(time, before, this->Taken);
      last = time;
      time = this->FindLast(time,
        [&](int t)
        {
          // Bricks come to a level before any leaves it.
          Occupancy most = this->Taken;
          for (int level = this->Coarsest; level > 0; --level)
          {
            most.Add(level - 1,
              this->CountBefore(t, level, before) - this->CountBefore(time, level, before));
          }
          return most.Fits();
        });
    }
    for (int level = 1; level <= this->Coarsest; ++level)
    {
      this->Fronts[level] = { this->GetFirstNumber(time, level), 0 };
    }
  }

  void RefineOneByOne()
  {
    std::array<bool, MostLevels + 1> waits = {};
    while (const int level = this->FindNext(waits))
    {
      const std::int64_t depth = this->Taken.GetDepth();
      waits[level] = !this->Taken.RefineIfFits(level);
      if (!waits[level])
      {
        ++this->Fronts[level].Index;
        // There is room for a brick of this level, and one more may leave a slab of the next.
        waits[level + 1] = waits[level - 1] = false;
      }
      if (this->Taken.GetDepth() < depth)
      {
        waits = {};
      }
    }
  }

  void Write(std::vector<std::int8_t>& levels)
  {
    levels.resize(this->Order.GetNumbers(0).size());
    const auto coarsest = static_cast<std::int8_t>(this->Coarsest);
    std::transform(this->Order.GetNumbers(0).begin(), this->Order.GetNumbers(0).end(),
      levels.begin(),
      [coarsest](std::uint16_t number)
      { return number == RefinementOrder::Never ? NoLevel : coarsest; });
    for (int level = this->Coarsest; level > 0; --level)
    {
      const std::uint16_t* number = this->Order.GetNumbers(this->Order.GetSequence(level)).data();
      const int first = this->Fronts[level].Number;
      for (std::int8_t& written : levels)
      {
        written = static_cast<std::int8_t>(written - (*number++ < first ? 1 : 0));
      }
      for (int i = 0; i < this->Fronts[level].Index; ++i)
      {
        --levels[this->GetQueue(level).GetBlocks(first)[i]];
      }
    }
  }

private:
  static constexpr int MostLevels = 8;
  using Sums = std::vector<std::vector<std::int32_t>>; // by sequence and number

  BlockQueue& GetQueue(int level) { return this->Queues[this->Order.GetSequence(level)]; }

  // Of the blocks that are not refined from this level before that time.
  int GetFirstNumber(int time, int level) const
  {
    return std::min<int>(
      this->Order.GetNumber(time - this->Order.GetDelay(level)), RefinementOrder::Never);
  }

  std::int64_t CountBefore(int time, int level, const Sums& before) const
  {
    return before[this->Order.GetSequence(level)][this->GetFirstNumber(time, level)];
  }

  // All refinements before this time.
  void RefineUntil(int time, const Sums& before, Occupancy& taken) const
  {
    for (int level = this->Coarsest; level > 0; --level)
    {
      taken.Refine(level, this->CountBefore(time, level, before));
    }
  }

  // The last time for which this holds, if it holds for `low`.
  template <typename Condition>
  int FindLast(int low, const Condition& holds) const
  {
    int high = this->Order.GetTime(RefinementOrder::Never) + this->Order.GetDelay(1);
    while (high - low > 1)
    {
      const int middle = low + (high - low) / 2;
      (holds(middle) ? low : high) = middle;
    }
    return low;
  }

  // The level whose refinement comes next, 0 if there is none. Levels that wait are left out.
  int FindNext(const std::array<bool, MostLevels + 1>& waits)
  {
    int next = 0;
    int earliest = std::numeric_limits<int>::max();
    std::int64_t first = 0;
    for (int level = this->Coarsest; level > 0; --level)
    {
      if (waits[level] || !this->HasBlock(level))
      {
        continue;
      }
      const Front& front = this->Fronts[level];
      const int time = this->Order.GetTime(front.Number) + this->Order.GetDelay(level);
      const std::int64_t block = this->GetQueue(level).GetBlocks(front.Number)[front.Index];
      if (time < earliest || (time == earliest && block < first))
      {
        next = level;
        earliest = time;
        first = block;
      }
    }
    return next;
  }

  // Whether the block at the front is there; the front moves on to it.
  bool HasBlock(int level)
  {
    Front& front = this->Fronts[level];
    while (front.Number < RefinementOrder::Never &&
           front.Index >= this->GetQueue(level).GetCount(front.Number))
    {
      front = { front.Number + 1, 0 };
    }
    return front.Number < RefinementOrder::Never &&
           (level == this->Coarsest ||
             this->IsRefined(
               this->GetQueue(level).GetBlocks(front.Number)[front.Index], level + 1));
  }

  // Whether the block has been refined from this level.
  bool IsRefined(std::int64_t block, int level)
  {
    const Front& front = this->Fronts[level];
    const int number = this->GetQueue(level).GetNumber(block);
    return number < front.Number ||
           (number == front.Number && front.Index > 0 &&
             block <= this->GetQueue(level).GetBlocks(number)[front.Index - 1]);
  }

  const RefinementOrder& Order;
  int Coarsest;
  Occupancy Taken;
  Occupancy Start = Taken;
  std::vector<BlockQueue> Queues; // by sequence
  std::array<Front, MostLevels> Fronts = {};
};
} // namespace

bool LodSelector::Select(const RefinementOrder& order, const AtlasShape& shape, int numberOfLevels)
{
  this->Counts.resize(order.GetNumberOfSequences());
  for (int sequence = 0; sequence < order.GetNumberOfSequences(); ++sequence)
  {
    this->Counts[sequence].assign(std::size_t(RefinementOrder::Never) + 1, 0);
    for (const std::uint16_t number : order.GetNumbers(sequence))
    {
      ++this->Counts[sequence][number];
    }
  }
  const auto blocks =
    static_cast<std::int64_t>(order.GetNumbers(0).size()) - this->Counts[0][RefinementOrder::Never];
  const std::optional<int> coarsest = FindCoarsest(shape, blocks, numberOfLevels);
  if (!coarsest)
  {
    return false;
  }
  const bool areAllFinest = Occupancy(shape, 0, blocks).Fits();
  Greedy greedy(order, shape, areAllFinest ? 0 : *coarsest, blocks, this->Counts);
  greedy.RefineAtOnce(this->Counts);
  greedy.RefineOneByOne();
  greedy.Write(this->Levels);
  return true;
}
} // namespace flatblock
