// Scenes drawn at random from everything that is extreme, each compared with the reference.
#include "Dice.h"
#include "Extremes.h"
#include "Volumes.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace flatblock::testing;

namespace
{
constexpr int Scenes = 300;
// Most are right to 1e-5. Functions that jump are off where values stay within 1/8191 of their
// range beside the jump, for so finely the table tells them.
constexpr double Bound = 0.05;

// Waves or noise, over any range, with a few samples that are not finite.
void SetField(Scene& scene, Dice& dice)
{
  const auto side = [&dice] { return dice.OneOf({ 2, 3, 5, 8, 13, 17, 18, 19 }); };
  const std::array<int, 3> samples = { side(), side(), side() };
  const int type =
    dice.OneOf({ VTK_FLOAT, VTK_DOUBLE, VTK_UNSIGNED_SHORT, VTK_SHORT, VTK_INT, VTK_LONG_LONG });
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  const double scale = isReal ? dice.Power(-28.0, 28.0) : 30000.0;
  const double offset = isReal && dice.Chance(0.5) ? scale * dice.Between(-5.0, 5.0) : 0.0;
  const double noise = dice.OneOf({ 0.0, 0.0, 0.3 });
  const bool hasHoles = isReal && dice.Chance(0.3);
  const double gap = dice.OneOf({ std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() });
  const auto image = MakeVolume(samples, type,
    [&](int x, int y, int z)
    {
      const double value = std::clamp(WaveAt(x, y, z) + noise * dice.Between(-1.0, 1.0), 0.0, 1.0);
      return hasHoles && dice.Chance(0.01) ? gap : offset + scale * value;
    });
  const double size = dice.Power(-6.0, 6.0);
  image->SetSpacing(size * dice.Power(0.0, 0.5),
    size * dice.Power(0.0, dice.Chance(0.2) ? 3.0 : 0.5), size * dice.Power(0.0, 0.5));
  if (dice.Chance(0.3))
  {
    image->SetOrigin(size * dice.Power(0.0, 7.0), -size * dice.Power(0.0, 7.0), 0.0);
  }
  if (dice.Chance(0.3))
  {
    image->SetDirectionMatrix(0, 1, 0, dice.OneOf({ -1, 1 }), 0, 0, 0, 0, 1);
  }
  const double* spacing = image->GetSpacing();
  const double smallest = std::min({ spacing[0], spacing[1], spacing[2] });
  scene.SetVolume(image, smallest / 16.0);
  scene.Property->SetScalarOpacityUnitDistance(smallest * dice.Power(-1.0, 2.0));

  // Functions of a few nodes, some of them in one place or beyond the data.
  auto* opacity = scene.Property->GetScalarOpacity();
  std::vector<std::pair<double, double>> opacities;
  std::vector<std::array<double, 4>> colors;
  const int nodes = dice.OneOf({ 1, 2, 3, 5, 8 });
  for (int i = 0; i < nodes; ++i)
  {
    const double value = offset + scale * dice.Between(-0.3, 1.3);
    const double alpha =
      dice.OneOf({ 0.0, 0.0, 1.0, dice.Power(-7.0, 0.0), dice.Between(0.0, 0.9) });
    opacities.emplace_back(value, alpha);
    colors.push_back(
      { value, dice.Between(0.0, 1.0), dice.Between(0.0, 1.0), dice.Between(0.0, 1.0) });
  }
  scene.SetOpacity(opacities);
  scene.SetColor(colors);
  opacity = scene.Property->GetScalarOpacity();
  if (dice.Chance(0.3))
  {
    opacity->AllowDuplicateScalarsOn();
    opacity->AddPoint(opacities[0].first, dice.Between(0.0, 0.9));
  }
}

void SetMatrix(Scene& scene, Dice& dice)
{
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(dice.Between(0.0, 360.0), dice.Between(-1.0, 1.0), 1.0, 0.3);
  if (dice.Chance(0.3))
  {
    transform->Scale(dice.OneOf({ -1.0, 1.0 }), dice.Power(-1.0, 1.0), 1.0);
  }
  vtkNew<vtkMatrix4x4> shear;
  shear->SetElement(0, 1, dice.Chance(0.3) ? dice.Between(-0.8, 0.8) : 0.0);
  transform->Concatenate(shear);
  scene.Volume->SetUserMatrix(transform->GetMatrix());
}

void SetCamera(Scene& scene, Dice& dice)
{
  scene.Window->SetSize(24, 24);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetParallelProjection(dice.Chance(0.3));
  camera->SetViewAngle(dice.OneOf({ 0.05, 30.0, 30.0, 90.0, 170.0 }));
  scene.LookFrom(dice.Between(0.0, 360.0), dice.Between(-80.0, 80.0), dice.Power(-0.3, 1.0));
  if (dice.Chance(0.2))
  {
    const double* center = scene.Volume->GetCenter();
    const double* bounds = scene.Volume->GetBounds();
    camera->SetPosition(center[0] + dice.Between(-0.4, 0.4) * (bounds[1] - bounds[0]),
      center[1] + dice.Between(-0.4, 0.4) * (bounds[3] - bounds[2]), center[2]);
    scene.Renderer->ResetCameraClippingRange();
  }
  if (dice.Chance(0.2))
  {
    const double* range = camera->GetClippingRange();
    camera->SetClippingRange(range[0] + dice.Between(0.0, 0.6) * (range[1] - range[0]), range[1]);
  }
}

void SetSampling(Scene& scene, Dice& dice)
{
  scene.Mapper->SetBlockSize(dice.OneOf({ 17, 33 }));
  scene.Mapper->SetUseJittering(dice.Chance(0.3));
  scene.Mapper->SetAdaptiveSampling(dice.Chance(0.7));
  scene.Mapper->SetEarlyTerminationThreshold(dice.OneOf({ 1.0, 1.0 - 1.0 / 255.0 }));
}
} // namespace

TEST(RandomScenes, LookLikeTheReference)
{
  const char* only = std::getenv("FLATBLOCK_SEED");
  const unsigned first = only ? static_cast<unsigned>(std::atoi(only)) : 0;
  const unsigned last = only ? first + 1 : Scenes;
  std::vector<double> errors;
  double largest = 0.0;
  int visible = 0;
  for (unsigned seed = first; seed < last; ++seed)
  {
    Dice dice(seed);
    Scene scene;
    SetField(scene, dice);
    SetMatrix(scene, dice);
    SetCamera(scene, dice);
    SetSampling(scene, dice);
    const Outcome outcome = CompareWithReference(scene, 3);
    errors.push_back(outcome.Error);
    visible += outcome.Brightest > 0.05 ? 1 : 0;
    largest = std::max(largest, outcome.Error);
    EXPECT_LE(outcome.Error, Bound) << "FLATBLOCK_SEED=" << seed << " draws this one alone";
  }
  std::sort(errors.begin(), errors.end());
  std::cout << errors.size() << " scenes, " << visible << " of them visible: median error "
            << errors[errors.size() / 2] << ", 95 % below " << errors[errors.size() * 95 / 100]
            << ", largest " << largest << "\n";
  EXPECT_GE(visible, only ? 0 : Scenes / 2);
  Record("random scenes", std::to_string(errors.size()) + " scenes of all of the above", "right",
    largest);
}
