#include "BenchScenes.h"

#include <array>
#include <random>

namespace flatblock::benchmarks
{
namespace
{
using Point = std::array<double, 3>;

class Tree
{
public:
  Tree(int n, unsigned int seed)
    : Count(n), Random(seed),
      Image(testing::MakeVolume({ n, n, n }, VTK_UNSIGNED_SHORT, [](int, int, int) { return 0.0; }))
  {
  }

  /// Lengths and radii in samples; a branch wanders and splits at its end.
  void Grow(Point at, Point direction, double length, double radius, int depth)
  {
    for (double along = 0.0; along < length; along += 0.5)
    {
      for (int i = 0; i < 3; ++i)
      {
        direction[i] += 0.08 * this->Draw();
        at[i] += 0.5 * direction[i];
      }
      this->Normalize(direction);
      this->Stamp(at, radius);
    }
    for (int branch = 0; branch < 2 && depth > 0; ++branch)
    {
      Point turned = direction;
      for (double& component : turned)
      {
        component += 0.9 * this->Draw();
      }
      this->Normalize(turned);
      this->Grow(at, turned, 0.75 * length, std::max(0.9, 0.78 * radius), depth - 1);
    }
  }

  vtkSmartPointer<vtkImageData> Get() { return this->Image; }

private:
  // Uniform in [-1, 1], on every platform the same.
  double Draw() { return double(this->Random()) / 2147483647.5 - 1.0; }

  static void Normalize(Point& direction)
  {
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    for (double& component : direction)
    {
      component /= length;
    }
  }

  void Stamp(const Point& at, double radius)
  {
    std::array<int, 3> low;
    std::array<int, 3> high;
    for (int i = 0; i < 3; ++i)
    {
      low[i] = std::max(0, int(std::floor(at[i] - radius - 1.0)));
      high[i] = std::min(this->Count - 1, int(std::ceil(at[i] + radius + 1.0)));
    }
    for (int k = low[2]; k <= high[2]; ++k)
    {
      for (int j = low[1]; j <= high[1]; ++j)
      {
        for (int i = low[0]; i <= high[0]; ++i)
        {
          const double depth = radius + 0.5 - std::hypot(i - at[0], j - at[1], k - at[2]);
          auto* sample = static_cast<unsigned short*>(this->Image->GetScalarPointer(i, j, k));
          *sample =
            std::max(*sample, static_cast<unsigned short>(1000.0 * std::clamp(depth, 0.0, 1.0)));
        }
      }
    }
  }

  int Count;
  std::mt19937 Random;
  vtkSmartPointer<vtkImageData> Image;
};
} // namespace

vtkSmartPointer<vtkImageData> MakeVesselTree(int n, unsigned int seed)
{
  Tree tree(n, seed);
  tree.Grow({ 0.5 * n, 0.05 * n, 0.5 * n }, { 0.0, 1.0, 0.0 }, 0.28 * n, 0.02 * n, 6);
  return tree.Get();
}
} // namespace flatblock::benchmarks
