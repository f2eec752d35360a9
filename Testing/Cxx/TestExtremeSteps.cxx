// Steps, opacities and unit distances far from what is usual.
#include "Extremes.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace flatblock::testing;

namespace
{
const char* const Group = "steps and opacities";
} // namespace

TEST(ExtremeSteps, TooSmallOnesAreLengthenedAndSaid)
{
  for (double step : { 1e-30, 1e-6, 1e-3, 1.0 / 256.0, 0.01, 0.1 })
  {
    Scene scene;
    ShowWaves(scene, { 9, 8, 10 }, step);
    scene.Window->SetSize(32, 32);
    const Outcome outcome = CompareWithReference(scene);
    EXPECT_EQ(outcome.Said.Warnings.size(), step < 1.0 / 256.0 ? 1U : 0U) << step;
    Scene recorded;
    ShowWaves(recorded, { 9, 8, 10 }, step);
    recorded.Window->SetSize(32, 32);
    ExpectRight(recorded, Group, "sample distance of " + ToText(step) + " voxels", 2e-4);
  }
}

// Values are taken as linear from sample to sample: so this is no small error, but no wrong field.
TEST(ExtremeSteps, LongOnesSeeTheEndsOfARay)
{
  for (double step : { 1.0, 4.0, 1e2, 1e6, 1e30 })
  {
    Scene scene;
    ShowWaves(scene, { 9, 8, 10 }, step);
    ExpectRight(scene, Group, "sample distance of " + ToText(step) + " voxels",
      step > 1.0 ? 0.2 : 0.01, step > 1.0 ? "coarse" : "");
  }
  // A linear field is exact for any step.
  Scene scene;
  ShowWaves(scene, { 9, 8, 10 }, 1e6);
  scene.SetVolume(
    MakeVolume({ 9, 8, 10 }, VTK_FLOAT, [](int x, int y, int z) { return (x + y + z) / 24.0; }),
    1e6);
  ExpectRight(scene, Group, "sample distance of 1e6 voxels, linear field", 2e-4);
}

TEST(ExtremeSteps, OpacitiesOfEverySize)
{
  for (double opacity : { 1e-7, 1e-5, 1e-3, 0.5, 0.999, 0.9999999, 1.0 })
  {
    Scene scene;
    ShowWaves(scene, { 17, 18, 19 }, 0.25);
    scene.SetOpacity({ { 0.0, opacity }, { 1.0, opacity } });
    scene.Mapper->SetEarlyTerminationThreshold(1.0);
    const Outcome outcome = CompareWithReference(scene);
    ExpectRight(scene, Group, "opacity " + ToText(opacity), opacity < 0.9 ? 1e-3 : 0.02);
    EXPECT_LE(outcome.Error, std::max(0.02 * outcome.Brightest, 1e-9)) << opacity;
  }
}

TEST(ExtremeSteps, UnitDistancesOfEverySize)
{
  const double diagonal = std::hypot(16.0, 17.0, 18.0);
  for (double unit : { 1e-6, 1e-3, 1.0, 1e3, 1e6 })
  {
    Scene scene;
    ShowWaves(scene, { 17, 18, 19 }, 0.25);
    scene.Property->SetScalarOpacityUnitDistance(unit * diagonal);
    scene.Mapper->SetEarlyTerminationThreshold(1.0);
    const Outcome outcome = CompareWithReference(scene);
    ExpectRight(scene, Group, "opacity unit distance of " + ToText(unit) + " diagonals", 0.02);
    EXPECT_LE(outcome.Error, 0.02 * outcome.Brightest) << unit;
  }
}
