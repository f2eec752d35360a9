#include "Refinement.h"

#include <algorithm>

namespace flatblock
{
std::vector<std::int64_t> CountBricks(
  const std::vector<std::int8_t>& levels, const AtlasShape& shape)
{
  std::vector<std::int64_t> bricks(shape.GetNumberOfLevels(), 0);
  for (const std::int8_t level : levels)
  {
    if (level != NoLevel)
    {
      ++bricks[level];
    }
  }
  return bricks;
}

class Refiner::Step
{
public:
  Step(const Refiner& refiner, const std::vector<std::int8_t>& target,
    const std::vector<std::int8_t>& current, const std::vector<std::uint16_t>& order,
    const RefinementBudget& budget)
    : Own(refiner), Target(target), Order(order), Budget(budget), Levels(current),
      Bricks(CountBricks(current, refiner.Shape))
  {
  }

  std::vector<std::int8_t> Take()
  {
    this->ShowAndHide();
    this->SortChanges();
    this->CollapseUntilItFits();
    if (!this->Fits())
    {
      return this->Target;
    }
    this->Refine();
    while (this->CollapseWithinBudget())
    {
    }
    // A coarser brick may have begun a slab before the finer ones left theirs.
    this->CollapseUntilItFits();
    return this->Fits() ? this->Levels : this->Target;
  }

private:
  void SetLevel(std::size_t block, std::int8_t level)
  {
    if (this->Levels[block] != NoLevel)
    {
      --this->Bricks[this->Levels[block]];
    }
    if (level != NoLevel)
    {
      ++this->Bricks[level];
    }
    this->Levels[block] = level;
  }

  bool Fits() const { return this->Own.Shape.GetDepthOf(this->Bricks) <= this->Own.Depth; }

  // Of the brick, and of the borders that follow it.
  std::int64_t GetTexels(std::size_t block)
  {
    const std::int8_t level = this->Target[block];
    std::int64_t texels = CountTexels(WholeBrick, this->Own.Grid.GetTexelSide(level));
    if (this->Own.Borders == Continuity::Off)
    {
      return texels;
    }
    const std::int8_t before = this->Levels[block];
    const std::int8_t coarser = std::max(level, before);
    const Index3 p = this->Own.Grid.GetPosition(static_cast<std::int64_t>(block));
    const Index3& blocks = this->Own.Grid.GetBlocks();
    for (int z = std::max(p[2] - 1, 0); z <= std::min(p[2] + 1, blocks[2] - 1); ++z)
    {
      for (int y = std::max(p[1] - 1, 0); y <= std::min(p[1] + 1, blocks[1] - 1); ++y)
      {
        for (int x = std::max(p[0] - 1, 0); x <= std::min(p[0] + 1, blocks[0] - 1); ++x)
        {
          const std::int64_t other = this->Own.Grid.GetBlock({ x, y, z });
          const bool isFiner = this->Levels[other] != NoLevel && this->Levels[other] < coarser;
          if (isFiner && other != static_cast<std::int64_t>(block))
          {
            const BlockBorder old = this->GetBorder(other);
            this->Levels[block] = level;
            const BrickParts parts = GetChangedParts(old, this->GetBorder(other));
            this->Levels[block] = before;
            texels += CountTexels(parts, this->Own.Grid.GetBrickSide(this->Levels[other]));
          }
        }
      }
    }
    return texels;
  }

  BlockBorder GetBorder(std::int64_t block) const
  {
    return GetBlockBorder(this->Own.Grid, this->Levels, block, this->Own.Borders);
  }

  // False where that is beyond the budget, unless it is to be exceeded.
  bool Change(std::size_t block, bool mayExceed)
  {
    const std::int64_t texels = this->GetTexels(block);
    const bool isAffordable = this->Budget.Blocks > 0 && texels <= this->Budget.Texels;
    if (!isAffordable && !this->IsFirst && !mayExceed)
    {
      return false;
    }
    --this->Budget.Blocks;
    this->Budget.Texels -= texels;
    this->IsFirst = false;
    this->SetLevel(block, this->Target[block]);
    return true;
  }

  void ShowAndHide()
  {
    const std::vector<std::int8_t> before = this->Levels;
    std::vector<std::size_t> shown;
    for (std::size_t block = 0; block < this->Target.size(); ++block)
    {
      if (this->Target[block] == NoLevel)
      {
        this->SetLevel(block, NoLevel);
      }
      else if (this->Levels[block] == NoLevel)
      {
        shown.push_back(block);
      }
    }
    this->Show(shown);
    this->SpendOnBorders(before);
  }

  void Show(const std::vector<std::size_t>& shown)
  {
    const std::int8_t first = this->GetFirstLevel(static_cast<std::int64_t>(shown.size()));
    for (const std::size_t block : shown)
    {
      this->SetLevel(block, std::max(first, this->Target[block]));
      const std::int64_t side = this->Own.Grid.GetTexelSide(this->Levels[block]);
      this->Budget.Texels -= side * side * side;
      this->IsFirst = false;
    }
  }

  // Borders that follow blocks that are new or gone.
  void SpendOnBorders(const std::vector<std::int8_t>& before)
  {
    const std::vector<std::uint8_t> touched = FindTouched(this->Own.Grid, before, this->Levels);
    for (std::size_t i = 0; this->Own.Borders != Continuity::Off && i < touched.size(); ++i)
    {
      if (touched[i] && before[i] == this->Levels[i] && before[i] != NoLevel)
      {
        const auto block = static_cast<std::int64_t>(i);
        const BrickParts parts = GetChangedParts(
          GetBlockBorder(this->Own.Grid, before, block, this->Own.Borders), this->GetBorder(block));
        this->Budget.Texels -= CountTexels(parts, this->Own.Grid.GetBrickSide(before[i]));
      }
    }
  }

  // Fine enough to be recognized, where so many can be afforded.
  std::int8_t GetFirstLevel(std::int64_t blocks) const
  {
    constexpr int Recognizable = 3;
    const int coarsest = this->Own.Shape.GetNumberOfLevels() - 1;
    int level = std::min(coarsest, Recognizable);
    const auto texels = [this, blocks](int l)
    {
      const std::int64_t side = this->Own.Grid.GetTexelSide(l);
      return blocks * side * side * side;
    };
    while (level < coarsest && texels(level) > this->Budget.Texels)
    {
      ++level;
    }
    return static_cast<std::int8_t>(level);
  }

  // Both in the order in which they are taken from the back.
  void SortChanges()
  {
    for (std::size_t block = 0; block < this->Target.size(); ++block)
    {
      if (this->Target[block] > this->Levels[block])
      {
        this->Collapses.push_back(block);
      }
      else if (this->Target[block] < this->Levels[block])
      {
        this->Refinements.push_back(block);
      }
    }
    std::stable_sort(this->Collapses.begin(), this->Collapses.end(),
      [this](std::size_t a, std::size_t b) { return this->Order[a] < this->Order[b]; });
    std::reverse(this->Refinements.begin(), this->Refinements.end());
    std::stable_sort(this->Refinements.begin(), this->Refinements.end(),
      [this](std::size_t a, std::size_t b) { return this->Order[a] > this->Order[b]; });
  }

  void CollapseUntilItFits()
  {
    while (!this->Fits() && !this->Collapses.empty())
    {
      this->Change(this->Collapses.back(), true);
      this->Collapses.pop_back();
    }
  }

  bool CollapseWithinBudget()
  {
    if (this->Collapses.empty() || !this->Change(this->Collapses.back(), false))
    {
      return false;
    }
    this->Collapses.pop_back();
    return true;
  }

  void Refine()
  {
    while (!this->Refinements.empty())
    {
      const std::size_t block = this->Refinements.back();
      const std::int8_t before = this->Levels[block];
      this->SetLevel(block, this->Target[block]);
      const bool fits = this->Fits();
      this->SetLevel(block, before);
      if (fits)
      {
        if (!this->Change(block, false))
        {
          return;
        }
        this->Refinements.pop_back();
      }
      else if (this->Collapses.empty())
      {
        // Slabs of many levels, each begun: only all changes together fit, in a frame of their own.
        this->Levels = this->IsFirst ? this->Target : this->Levels;
        return;
      }
      else if (!this->CollapseWithinBudget())
      {
        return;
      }
    }
  }

  const Refiner& Own;
  const std::vector<std::int8_t>& Target;
  const std::vector<std::uint16_t>& Order;
  RefinementBudget Budget;
  std::vector<std::int8_t> Levels;
  std::vector<std::int64_t> Bricks;
  std::vector<std::size_t> Collapses;
  std::vector<std::size_t> Refinements;
  bool IsFirst = true; // change of this frame, which needs no budget
};

std::vector<std::int8_t> Refiner::StepTowards(const std::vector<std::int8_t>& target,
  const std::vector<std::int8_t>& current, const std::vector<std::uint16_t>& order,
  const RefinementBudget& budget) const
{
  return Step(*this, target, current, order, budget).Take();
}
} // namespace flatblock
