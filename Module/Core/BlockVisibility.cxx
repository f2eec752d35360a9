#include "BlockVisibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace flatblock
{
namespace
{
// Directions from the eye to the points of a box, along one axis.
struct Interval
{
  double Low;
  double High;

  // Of the absolute value.
  double GetLeast() const
  {
    return this->Low <= 0.0 && this->High >= 0.0
             ? 0.0
             : std::min(std::abs(this->Low), std::abs(this->High));
  }
  double GetMost() const { return std::max(std::abs(this->Low), std::abs(this->High)); }
};

// Signs of a ray's direction along the axis along which it goes farthest, and the two others.
struct Octant
{
  int Axis;
  bool IsUp;
  bool IsUpU;
  bool IsUpV;

  int GetNumber() const
  {
    return this->Axis * 8 + (this->IsUp ? 4 : 0) + (this->IsUpU ? 2 : 0) + (this->IsUpV ? 1 : 0);
  }
};

// Optical depths that the rays of one octant at least have gathered where they enter each block
// through the layer before it.
class Sweep
{
public:
  Sweep(const BlockGrid& grid, const std::vector<float>& extinction, const Octant& octant,
    double layerWidth, double eyeLayer)
    : Blocks(grid.GetBlocks()), Axis(octant.Axis), U((Axis + 1) % 3), V((Axis + 2) % 3),
      FromU(octant.IsUpU ? -1 : 1),
      FromV(octant.IsUpV ? -1 : 1), Strides{ 1, Blocks[0], std::int64_t(Blocks[0]) * Blocks[1] },
      Depths(extinction.size(), 0.0F)
  {
    const int layers = this->Blocks[this->Axis];
    const int step = octant.IsUp ? 1 : -1;
    // The layer of the eye is passed in part only.
    const int eye = static_cast<int>(std::clamp(eyeLayer, -1.0, static_cast<double>(layers)));
    for (int layer = eye + step; layer + step >= 0 && layer + step < layers; layer += step)
    {
      this->CrossLayer(layer, layer + step, extinction, static_cast<float>(layerWidth));
    }
  }

  // Of rays to any point of the block.
  float GetDepth(const Index3& block) const
  {
    return this->GetLeast(block[this->Axis], block[this->U], block[this->V], this->Depths);
  }

private:
  std::int64_t GetBlock(int layer, int u, int v) const
  {
    return layer * this->Strides[this->Axis] + u * this->Strides[this->U] +
           v * this->Strides[this->V];
  }

  // Of the block and those from which a ray may come; beyond the grid nothing takes light away.
  float GetLeast(int layer, int u, int v, const std::vector<float>& values) const
  {
    const int i = u + this->FromU;
    const int j = v + this->FromV;
    if (i < 0 || j < 0 || i >= this->Blocks[this->U] || j >= this->Blocks[this->V])
    {
      return 0.0F;
    }
    return std::min({ values[this->GetBlock(layer, u, v)], values[this->GetBlock(layer, i, v)],
      values[this->GetBlock(layer, u, j)], values[this->GetBlock(layer, i, j)] });
  }

  void CrossLayer(int layer, int next, const std::vector<float>& extinction, float width)
  {
    for (int v = 0; v < this->Blocks[this->V]; ++v)
    {
      for (int u = 0; u < this->Blocks[this->U]; ++u)
      {
        this->Depths[this->GetBlock(next, u, v)] = this->GetLeast(layer, u, v, this->Depths) +
                                                   width * this->GetLeast(layer, u, v, extinction);
      }
    }
  }

  Index3 Blocks;
  int Axis;
  int U;
  int V;
  int FromU;
  int FromV;
  std::array<std::int64_t, 3> Strides;
  std::vector<float> Depths;
};

class Viewer
{
public:
  Viewer(const BlockGrid& grid, const std::vector<float>& extinction,
    const std::array<double, 3>& spacing, const Viewpoint& viewpoint)
    : Grid(grid), Extinction(extinction), Spacing(spacing), View(viewpoint)
  {
  }

  float GetTransmittance(std::int64_t block)
  {
    std::array<Interval, 3> directions;
    const Index3 first = this->Grid.GetFirstSample(block);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double sight = this->View.Sight[axis];
      const double low = first[axis] - this->View.Eye[axis];
      directions[axis] = this->View.IsParallel
                           ? Interval{ sight, sight }
                           : Interval{ low, low + this->Grid.GetCellsPerBlock() };
    }
    float depth = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      const double most = directions[axis].GetMost();
      if (most >= directions[(axis + 1) % 3].GetLeast() &&
          most >= directions[(axis + 2) % 3].GetLeast())
      {
        depth = std::min(depth, this->GetDepth(block, axis, directions));
      }
    }
    return std::exp(-depth);
  }

private:
  // The least of all octants to which rays to the block may belong.
  float GetDepth(std::int64_t block, int axis, const std::array<Interval, 3>& directions)
  {
    if (directions[axis].GetLeast() <= 0.0)
    {
      return 0.0F;
    }
    const Interval& u = directions[(axis + 1) % 3];
    const Interval& v = directions[(axis + 2) % 3];
    float depth = std::numeric_limits<float>::infinity();
    for (const bool isUpU : { false, true })
    {
      for (const bool isUpV : { false, true })
      {
        if ((isUpU ? u.High >= 0.0 : u.Low <= 0.0) && (isUpV ? v.High >= 0.0 : v.Low <= 0.0))
        {
          const Octant octant = { axis, directions[axis].Low > 0.0, isUpU, isUpV };
          depth = std::min(depth, this->GetSweep(octant).GetDepth(this->Grid.GetPosition(block)));
        }
      }
    }
    return depth;
  }

  const Sweep& GetSweep(const Octant& octant)
  {
    auto& sweep = this->Sweeps[octant.GetNumber()];
    if (!sweep)
    {
      const double cells = this->Grid.GetCellsPerBlock();
      const double beyond = octant.IsUp ? -1.0 : this->Grid.GetBlocks()[octant.Axis];
      const double layer =
        this->View.IsParallel ? beyond : std::floor(this->View.Eye[octant.Axis] / cells);
      sweep.emplace(
        this->Grid, this->Extinction, octant, cells * this->Spacing[octant.Axis], layer);
    }
    return *sweep;
  }

  const BlockGrid& Grid;
  const std::vector<float>& Extinction;
  const std::array<double, 3>& Spacing;
  const Viewpoint& View;
  std::array<std::optional<Sweep>, 24> Sweeps;
};
} // namespace

std::vector<float> ComputeTransmittance(const BlockGrid& grid, const std::vector<float>& extinction,
  const std::array<double, 3>& spacing, const Viewpoint& viewpoint)
{
  // Blocks of which a part may take nothing away: cut off by the near plane, or by the volume's
  // end.
  std::vector<float> sure = extinction;
  for (std::size_t i = 0; i < sure.size(); ++i)
  {
    const Index3 first = grid.GetFirstSample(static_cast<std::int64_t>(i));
    const int cells = grid.GetCellsPerBlock();
    double before = viewpoint.NearPlane[3];
    bool isWhole = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double slope = viewpoint.NearPlane[axis];
      before += std::min(slope * first[axis], slope * (first[axis] + cells));
      isWhole = isWhole && first[axis] + cells < grid.GetSamples()[axis];
    }
    sure[i] = isWhole && before >= 0.0 ? sure[i] : 0.0F;
  }
  Viewer viewer(grid, sure, spacing, viewpoint);
  std::vector<float> transmittance(extinction.size());
  for (std::size_t block = 0; block < transmittance.size(); ++block)
  {
    transmittance[block] = viewer.GetTransmittance(static_cast<std::int64_t>(block));
  }
  return transmittance;
}
} // namespace flatblock
