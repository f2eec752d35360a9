#include "Refinement.h"

#include <algorithm>

namespace flatblock
{
namespace
{
class Step
{
public:
  Step(const BlockGrid& grid, const AtlasShape& shape, const std::vector<std::int8_t>& current,
    const std::vector<std::int8_t>& target, const RefinementBudget& budget)
    : Grid(grid), Shape(shape), Target(target), Budget(budget), Levels(current),
      Bricks(shape.GetNumberOfLevels(), 0)
  {
    this->Levels.resize(target.size(), NoLevel);
    for (const std::int8_t level : this->Levels)
    {
      this->Count(level, 1);
    }
  }

  std::vector<std::int8_t> Take()
  {
    this->ShowAndHide();
    this->SortChanges();
    while (!this->Fits() && !this->Collapses.empty())
    {
      this->CollapseOne();
    }
    if (!this->Fits())
    {
      return this->Target;
    }
    this->Refine();
    while (!this->Collapses.empty() && this->HasBudget())
    {
      this->CollapseOne();
    }
    return this->Levels;
  }

private:
  void Count(std::int8_t level, int change)
  {
    if (level != NoLevel)
    {
      this->Bricks[level] += change;
    }
  }

  void SetLevel(std::size_t block, std::int8_t level)
  {
    this->Count(this->Levels[block], -1);
    this->Count(level, 1);
    this->Levels[block] = level;
  }

  bool Fits() const { return this->Shape.GetDepthOf(this->Bricks) <= this->Shape.GetDepth(); }
  bool HasBudget() const { return this->Budget.Blocks > 0 && this->Budget.Texels > 0; }

  void Change(std::size_t block, std::int8_t level)
  {
    const std::int64_t side = this->Grid.GetBrickSide(level);
    --this->Budget.Blocks;
    this->Budget.Texels -= side * side * side;
    this->SetLevel(block, level);
  }

  void ShowAndHide()
  {
    const int coarsest = this->Shape.GetNumberOfLevels() - 1;
    const auto first = static_cast<std::int8_t>(std::min(coarsest, FirstShownLevel));
    for (std::size_t block = 0; block < this->Target.size(); ++block)
    {
      if (this->Target[block] == NoLevel)
      {
        this->SetLevel(block, NoLevel);
      }
      else if (this->Levels[block] == NoLevel)
      {
        this->SetLevel(block, std::max(first, this->Target[block]));
      }
    }
  }

  // Both in the order in which they are taken from the back.
  void SortChanges()
  {
    for (std::size_t block = this->Target.size(); block-- > 0;)
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
    std::stable_sort(this->Refinements.begin(), this->Refinements.end(),
      [this](std::size_t a, std::size_t b) { return this->Target[a] > this->Target[b]; });
  }

  void CollapseOne()
  {
    const std::size_t block = this->Collapses.back();
    this->Collapses.pop_back();
    this->Change(block, this->Target[block]);
  }

  void Refine()
  {
    while (!this->Refinements.empty() && this->HasBudget())
    {
      const std::size_t block = this->Refinements.back();
      const std::int8_t before = this->Levels[block];
      const RefinementBudget budget = this->Budget;
      this->Change(block, this->Target[block]);
      if (this->Fits())
      {
        this->Refinements.pop_back();
        continue;
      }
      this->SetLevel(block, before);
      this->Budget = budget;
      if (this->Collapses.empty())
      {
        // Slabs of many levels, each begun: only all changes together fit.
        this->Levels = this->Target;
        return;
      }
      this->CollapseOne();
    }
  }

  // A block that comes into view is small at first, so that many can come at once.
  static constexpr int FirstShownLevel = 3;

  const BlockGrid& Grid;
  const AtlasShape& Shape;
  const std::vector<std::int8_t>& Target;
  RefinementBudget Budget;
  std::vector<std::int8_t> Levels;
  std::vector<std::int64_t> Bricks;
  std::vector<std::size_t> Collapses;
  std::vector<std::size_t> Refinements;
};
} // namespace

std::vector<std::int8_t> StepTowards(const BlockGrid& grid, const AtlasShape& shape,
  const std::vector<std::int8_t>& current, const std::vector<std::int8_t>& target,
  RefinementBudget budget)
{
  budget.Blocks = std::max<std::int64_t>(budget.Blocks, 1);
  budget.Texels = std::max<std::int64_t>(budget.Texels, 1);
  return Step(grid, shape, current, target, budget).Take();
}
} // namespace flatblock
