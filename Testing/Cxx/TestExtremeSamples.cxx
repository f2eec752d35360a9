// Samples that are not finite: the cells around them are holes, and nothing else is.
#include "Extremes.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace flatblock::testing;

namespace
{
const char* const Group = "samples that are not finite";
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Those at the blocks' corner, border and inside.
double WithHoles(int x, int y, int z)
{
  if (x == 16 && y == 16 && z == 16)
  {
    return NaN;
  }
  if (x == 5 && y == 6 && z == 7)
  {
    return Infinity;
  }
  return x == 20 && y == 16 && z == 9 ? -Infinity : WaveAt(x, y, z);
}

void ShowHoles(Scene& scene, int type, double step)
{
  ShowWaves(scene, { 33, 33, 33 }, step);
  scene.SetVolume(MakeVolume({ 33, 33, 33 }, type, WithHoles), step);
}
} // namespace

TEST(ExtremeSamples, OnlyTheirOwnCellsAreHoles)
{
  for (int size : { 17, 33 })
  {
    for (int type : { VTK_FLOAT, VTK_DOUBLE })
    {
      Scene scene;
      ShowHoles(scene, type, 0.05);
      scene.Mapper->SetBlockSize(size);
      ExpectRight(scene, Group, "NaN and infinities in blocks of " + std::to_string(size), 0.01);
    }
  }
}

TEST(ExtremeSamples, AreLeftOutByEachClassification)
{
  for (int classification = 0; classification < 3; ++classification)
  {
    Scene scene;
    ShowHoles(scene, VTK_FLOAT, 0.05);
    scene.Mapper->SetClassification(classification);
    // Colours of the samples are not those of what is interpolated between them.
    const bool isPreInterpolation = classification == vtkFlatBlockVolumeMapper::PRE_INTERPOLATION;
    ExpectRight(scene, Group, "each classification", isPreInterpolation ? 0.05 : 0.01);
  }
  Scene nearest;
  ShowHoles(nearest, VTK_FLOAT, 0.1);
  nearest.Property->SetInterpolationTypeToNearest();
  EXPECT_TRUE(IsSound(DrawFloats(nearest)));
}

TEST(ExtremeSamples, AreCountedAndSaidOnce)
{
  Scene scene;
  ShowHoles(scene, VTK_FLOAT, 0.5);
  const auto messages = Listen(
    [&]
    {
      DrawFloats(scene);
      scene.SetRamp(0.0, 1.0, 0.1);
      DrawFloats(scene);
    });
  ASSERT_EQ(messages.Warnings.size(), 1U);
  EXPECT_NE(messages.Warnings[0].find(" 3 samples are not finite"), std::string::npos);
}

TEST(ExtremeSamples, NothingElseIsNothingDrawn)
{
  Scene scene;
  ShowWaves(scene, { 9, 9, 9 });
  scene.SetVolume(MakeVolume({ 9, 9, 9 }, VTK_FLOAT, [](int, int, int) { return NaN; }), 0.5);
  ExpectRight(scene, Group, "all of them", 0.0, "nothing is drawn");
}

// At coarser levels a hole has the cells of its level; all others stay whole.
TEST(ExtremeSamples, CoarserLevelsStaySound)
{
  for (int filter : { vtkFlatBlockVolumeMapper::SUBSAMPLE, vtkFlatBlockVolumeMapper::TENT })
  {
    Scene scene;
    ShowHoles(scene, VTK_FLOAT, 0.5);
    scene.Mapper->SetBlockSize(17);
    scene.Mapper->SetLevelFilter(filter);
    scene.Mapper->SetMaxMemoryInBytes(120000);
    const Picture coarse = DrawFloats(scene);
    EXPECT_TRUE(IsSound(coarse));
    EXPECT_EQ(scene.Mapper->GetNumberOfBricks(0), 0);
    Scene whole;
    ShowWaves(whole, { 33, 33, 33 });
    EXPECT_LE(RootMeanSquare(coarse, DrawFloats(whole)), 0.05);
  }
}
