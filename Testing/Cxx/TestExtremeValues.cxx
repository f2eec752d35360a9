// Values and transfer functions far from what is usual.
#include "Extremes.h"
#include "Volumes.h"

#include "vtkDataArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

using namespace flatblock::testing;

namespace
{
const char* const Group = "values and transfer functions";
constexpr double Bound = 0.01; // a step of half a voxel

// The waves, stretched over [lowest, highest] in a type.
void ShowRange(Scene& scene, int type, double lowest, double highest)
{
  ShowWaves(scene, { 17, 18, 19 });
  scene.SetVolume(
    MakeVolume({ 17, 18, 19 }, type,
      [=](int x, int y, int z) { return lowest + (highest - lowest) * WaveAt(x, y, z); }),
    0.5);
  scene.SetRamp(lowest, highest, 0.3);
}
} // namespace

TEST(ExtremeValues, RangesOfEverySize)
{
  for (const auto& [lowest, highest, name] : std::vector<std::tuple<double, double, std::string>>{
         { 0.0, 1e-30, "0 to 1e-30" }, { 0.0, 1e30, "0 to 1e30" }, { -1e30, 1e30, "-1e30 to 1e30" },
         { 1e-30, 1e30, "1e-30 to 1e30" }, { -7.0, -3.0, "-7 to -3" },
         { 1e6, 1e6 + 1.0, "1e6 to 1e6 + 1" } })
  {
    Scene scene;
    ShowRange(scene, VTK_DOUBLE, lowest, highest);
    ExpectRight(scene, Group, "doubles from " + name, Bound);
  }
}

TEST(ExtremeValues, WholeIntegerTypes)
{
  Scene signedScene;
  ShowRange(signedScene, VTK_LONG_LONG, -9.2e18, 9.2e18);
  ExpectRight(signedScene, Group, "int64 over its whole range", Bound);
  Scene unsignedScene;
  ShowRange(unsignedScene, VTK_UNSIGNED_LONG_LONG, 0.0, 1.8e19);
  ExpectRight(unsignedScene, Group, "uint64 over its whole range", Bound);

  Scene ends;
  ShowWaves(ends, { 17, 18, 19 });
  ends.SetVolume(MakeVolume({ 17, 18, 19 }, VTK_UNSIGNED_SHORT,
                   [](int x, int y, int z) { return (x / 4 + y / 4 + z / 4) % 2 ? 65535.0 : 0.0; }),
    0.1);
  ends.SetRamp(0.0, 65535.0, 0.3);
  ExpectRight(ends, Group, "uint16 with values only at the ends", Bound);
}

TEST(ExtremeValues, OneUnitInTheLastPlace)
{
  const double next = std::nextafter(1.0, 2.0);
  Scene scene;
  ShowWaves(scene, { 9, 9, 9 });
  scene.SetVolume(
    MakeVolume({ 9, 9, 9 }, VTK_DOUBLE, [=](int x, int, int) { return x < 5 ? 1.0 : next; }), 0.05);
  scene.SetOpacity({ { 0.0, 0.2 }, { 2.0, 0.2 } });
  scene.SetColor({ { 0.0, 0.3, 0.6, 0.9 }, { 2.0, 0.3, 0.6, 0.9 } });
  ExpectRight(scene, Group, "doubles one unit in the last place apart", 2e-3);
}

TEST(ExtremeValues, ConstantVolumes)
{
  for (double value : { 0.0, -5.0, 1e30, 1e-30 })
  {
    Scene scene;
    ShowWaves(scene, { 9, 9, 9 });
    scene.SetVolume(MakeVolume({ 9, 9, 9 }, VTK_DOUBLE, [=](int, int, int) { return value; }), 0.5);
    scene.SetOpacity({ { value - 1.0, 0.2 }, { value + 1.0, 0.2 } });
    scene.SetColor({ { value, 0.3, 0.6, 0.9 } });
    ExpectRight(scene, Group, "constant", 2e-3);
  }
}

TEST(ExtremeValues, FunctionsWithCoincidentNodes)
{
  Scene scene;
  ShowWaves(scene, { 17, 18, 19 }, 0.1);
  auto* opacity = scene.Property->GetScalarOpacity();
  opacity->AllowDuplicateScalarsOn();
  opacity->RemoveAllPoints();
  for (const auto& [value, alpha] : std::vector<std::pair<double, double>>{
         { 0.0, 0.0 }, { 0.5, 0.0 }, { 0.5, 0.9 }, { 0.6, 0.2 }, { 0.6, 0.0 }, { 1.0, 0.4 } })
  {
    opacity->AddPoint(value, alpha);
  }
  ExpectRight(scene, Group, "coincident nodes", Bound);
}

TEST(ExtremeValues, FunctionsWithFewNodes)
{
  Scene one;
  ShowWaves(one, { 17, 18, 19 });
  one.SetOpacity({ { 0.4, 0.25 } });
  one.SetColor({ { 0.7, 0.2, 0.5, 0.8 } });
  ExpectRight(one, Group, "one node", Bound);

  Scene none;
  ShowWaves(none, { 17, 18, 19 });
  none.SetOpacity({});
  ExpectRight(none, Group, "no node of opacity", 0.0, "nothing is drawn");

  Scene noColor;
  ShowWaves(noColor, { 17, 18, 19 });
  noColor.SetColor({});
  ExpectRight(noColor, Group, "no node of colour", Bound, "black");

  Scene outside;
  ShowWaves(outside, { 17, 18, 19 });
  outside.SetOpacity({ { -1e9, 0.0 }, { 1e9, 0.5 } });
  outside.SetColor({ { -1e30, 0.0, 0.0, 1.0 }, { 1e30, 1.0, 1.0, 0.0 } });
  ExpectRight(outside, Group, "nodes far outside of the data", Bound);
}
