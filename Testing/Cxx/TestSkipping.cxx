// Leaps show nothing else than steps do.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace flatblock::testing;

namespace
{
constexpr double OneStep = 1.0 / 255.0;
constexpr vtkTypeInt64 MapBytes = 16 * 18 * 16; // of cubes of 4^3 cells
using Mapper = vtkFlatBlockVolumeMapper;

double NoiseAt(int, int, int)
{
  static std::mt19937 random(3);
  return static_cast<double>(random() % 1001);
}

double SphereAt(int x, int y, int z)
{
  const double radius =
    std::sqrt(std::pow(x - 30.0, 2) + std::pow(y - 34.0, 2) + std::pow(z - 28.0, 2));
  return std::clamp(40.0 * (26.0 - radius), 0.0, 1000.0);
}

double SlowWavesAt(int x, int y, int z)
{
  return 500.0 + 160.0 * (std::sin(0.21 * x) + std::cos(0.17 * y - 0.12 * x) + std::sin(0.19 * z));
}

double TubesAt(int x, int y, int z)
{
  const double first = std::hypot(x - 20.0 - 0.3 * z, y - 40.0 + 0.2 * z);
  const double second = std::hypot(y - 12.0 - 0.5 * x, z - 30.0);
  return 1000.0 * std::exp(-0.3 * std::min(first, second) * std::min(first, second));
}

void Show(Scene& scene, double (*field)(int, int, int), int type = VTK_UNSIGNED_SHORT)
{
  scene.SetVolume(MakeVolume({ 65, 70, 62 }, type, field), 0.5);
  scene.Window->SetSize(96, 96);
  scene.LookFrom(35.0, 25.0, 1.3);
}

// Flat parts, transparent parts, slopes and steps.
void SetRandomFunction(Scene& scene, std::mt19937& random)
{
  std::uniform_real_distribution<double> value(0.0, 1000.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<std::pair<double, double>> opacity;
  std::vector<std::array<double, 4>> color;
  const int nodes = 2 + static_cast<int>(random() % 6);
  for (int i = 0; i < nodes; ++i)
  {
    const double at = value(random);
    const double alpha = share(random) < 0.5 ? 0.0 : std::pow(share(random), 3.0);
    opacity.emplace_back(at, alpha);
    if (share(random) < 0.6)
    {
      opacity.emplace_back(at + 0.4 * value(random), alpha);
    }
    color.push_back({ at, share(random), share(random), share(random) });
  }
  scene.SetOpacity(opacity);
  scene.SetColor(color);
}

double GetDifference(Scene& scene, int skipping, const Picture& expected)
{
  scene.Mapper->SetSkipping(skipping);
  return LargestDifference(DrawFloats(scene), expected);
}

double GetMass(const Picture& picture)
{
  double sum = 0.0;
  for (const auto& pixel : picture)
  {
    sum += pixel[3];
  }
  return sum / static_cast<double>(picture.size());
}
} // namespace

class Skipping : public testing::TestWithParam<int>
{
};

TEST_P(Skipping, ShowsTheSameForRandomFunctions)
{
  unsigned seed = 0;
  int visible = 0;
  for (auto* field : { SphereAt, SlowWavesAt, TubesAt, NoiseAt })
  {
    Scene scene;
    Show(scene, field);
    scene.Mapper->SetClassification(GetParam());
    scene.Mapper->SetBlockSize(17);
    for (int function = 0; function < 13; ++function)
    {
      std::mt19937 random(++seed);
      SetRandomFunction(scene, random);
      scene.Mapper->SetSkipping(Mapper::SKIP_NOTHING);
      const Picture expected = DrawFloats(scene);
      visible += GetMass(expected) > 0.02 ? 1 : 0;
      EXPECT_LE(GetDifference(scene, Mapper::SKIP_BLOCKS, expected), OneStep) << seed;
      EXPECT_LE(GetDifference(scene, Mapper::SKIP_CELLS, expected), OneStep) << seed;
    }
  }
  EXPECT_GT(visible, 30);
}

TEST_P(Skipping, ShowsTheSameAtMixedLevels)
{
  constexpr vtkTypeInt64 Limit = 400000;
  unsigned seed = 100;
  int mixed = 0;
  for (const int filter : { Mapper::SUBSAMPLE, Mapper::TENT })
  {
    for (auto* field : { SphereAt, TubesAt, NoiseAt })
    {
      Scene scene;
      Show(scene, field);
      scene.Mapper->SetClassification(GetParam());
      scene.Mapper->SetBlockSize(17);
      scene.Mapper->SetLevelFilter(filter);
      for (int function = 0; function < 4; ++function)
      {
        std::mt19937 random(++seed);
        SetRandomFunction(scene, random);
        scene.Mapper->SetSkipping(Mapper::SKIP_CELLS);
        scene.Mapper->SetMaxMemoryInBytes(Limit + MapBytes);
        const Picture leapt = DrawFloats(scene);
        const vtkTypeInt64 finest = scene.Mapper->GetNumberOfBricks(0);
        mixed += finest > 0 && finest < CountBricks(scene.Mapper) ? 1 : 0;
        scene.Mapper->SetSkipping(Mapper::SKIP_NOTHING);
        scene.Mapper->SetMaxMemoryInBytes(Limit);
        EXPECT_LE(LargestDifference(leapt, DrawFloats(scene)), OneStep) << seed;
        EXPECT_EQ(scene.Mapper->GetNumberOfBricks(0), finest);
      }
    }
  }
  EXPECT_GT(mixed, 10);
}

INSTANTIATE_TEST_SUITE_P(Classifications, Skipping,
  testing::Values(Mapper::PRE_INTEGRATED, Mapper::POST_INTERPOLATION, Mapper::PRE_INTERPOLATION));

// exp(-tau * length) has a closed form.
TEST(HomogeneousLeaps, AreExact)
{
  Scene scene;
  Show(scene, [](int, int, int) { return 500.0; });
  scene.SetOpacity({ { 0.0, 0.02 }, { 1000.0, 0.02 } });
  scene.SetColor({ { 0.0, 0.4, 0.6, 0.8 }, { 1000.0, 0.4, 0.6, 0.8 } });
  scene.Mapper->SetEarlyTerminationThreshold(1.0);
  const Picture reference = DrawReference(scene);
  EXPECT_LE(LargestDifference(DrawFloats(scene), reference), 1e-5);
  EXPECT_GT(GetMass(reference), 0.1);
}

TEST(HomogeneousLeaps, ShowTheSameAsSteps)
{
  Scene scene;
  Show(scene, SphereAt);
  scene.SetOpacity({ { 200.0, 0.0 }, { 600.0, 0.03 }, { 1000.0, 0.03 } });
  scene.SetColor({ { 300.0, 0.9, 0.2, 0.1 }, { 600.0, 0.2, 0.6, 0.9 } });
  const Picture leapt = DrawFloats(scene);
  scene.Mapper->HomogeneousLeapsOff();
  EXPECT_LE(LargestDifference(leapt, DrawFloats(scene)), 1e-4);
}

TEST(SkippingMemory, IsWithinTheLimit)
{
  Scene scene;
  Show(scene, TubesAt);
  scene.SetRamp(300.0, 1000.0, 0.4);
  scene.Window->Render();
  const vtkTypeInt64 with = scene.Mapper->GetMemoryInBytes();
  scene.Mapper->SetSkippingToNothing();
  scene.Window->Render();
  EXPECT_EQ(with - scene.Mapper->GetMemoryInBytes(), MapBytes);
  scene.Mapper->SetSkippingToCells();
  scene.Mapper->SetMaxMemoryInBytes(600000);
  scene.Window->Render();
  EXPECT_LE(scene.Mapper->GetMemoryInBytes(), 600000);
  scene.SetRamp(250.0, 1000.0, 0.5);
  scene.Window->Render();
  EXPECT_LE(scene.Mapper->GetPeakMemoryInBytes(), 600000);
}
