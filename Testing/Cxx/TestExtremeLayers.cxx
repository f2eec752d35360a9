// Many faint layers: what accumulates must not be lost, in the ray or in the window.
#include "Extremes.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace flatblock::testing;

namespace
{
const char* const Group = "accumulation";
constexpr int Layers = 2000;
constexpr double Opacity = 1e-3; // of a layer

// 2,000 steps along z, of which each has the opacity of a layer.
void ShowLayers(Scene& scene)
{
  ShowWaves(scene, { 3, 3, 3 });
  scene.SetVolume(MakeVolume({ 3, 3, 3 }, VTK_FLOAT, [](int x, int, int) { return 0.5 * x; }), 1.0);
  vtkImageData::SafeDownCast(scene.Mapper->GetInputDataObject(0, 0))
    ->SetSpacing(500.0, 500.0, 0.5 * Layers);
  scene.Mapper->SetSampleDistance(1.0);
  scene.SetOpacity({ { 0.0, Opacity }, { 1.0, Opacity } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0, 1.0 } });
  scene.Property->SetScalarOpacityUnitDistance(1.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0);
}
} // namespace

TEST(ExtremeLayers, AccumulateToTheClosedForm)
{
  const double expected = 1.0 - std::pow(1.0 - Opacity, Layers);
  for (int classification = 0; classification < 3; ++classification)
  {
    Scene scene;
    ShowLayers(scene);
    scene.Mapper->SetClassification(classification);
    const auto pixel = DrawFloats(scene)[32 * 64 + 32];
    for (double channel : pixel)
    {
      EXPECT_NEAR(channel, expected, 1.0 / 512.0);
    }
    Record(Group, "2000 layers of opacity 1/1000, float framebuffer", "right",
      std::abs(pixel[3] - expected));
    // A window of 8 bits shows the nearest of its steps.
    const auto picture = scene.Draw();
    const double shown = picture->GetScalarComponentAsDouble(32, 32, 0, 0);
    EXPECT_EQ(shown, std::round(255.0 * expected));
    Record(Group, "2000 layers of opacity 1/1000, 8-bit framebuffer", "right, rounded",
      std::abs(shown / 255.0 - expected));
  }
}

TEST(ExtremeLayers, EarlyTerminationLeavesOutNoMoreThanItSays)
{
  Scene scene;
  ShowLayers(scene);
  scene.Mapper->HomogeneousLeapsOff(); // which leave nothing out of a layer
  scene.Property->SetScalarOpacityUnitDistance(0.1);
  scene.Mapper->SetEarlyTerminationThreshold(1.0);
  const auto whole = DrawFloats(scene);
  for (double threshold : { 0.5, 0.9, 0.99, 1.0 - 1.0 / 255.0, 0.9999 })
  {
    scene.Mapper->SetEarlyTerminationThreshold(threshold);
    const double error = LargestDifference(DrawFloats(scene), whole);
    EXPECT_LE(error, 1.0 - threshold + 1e-6) << threshold;
    EXPECT_GT(error, 0.0) << threshold;
    Record(Group, "early termination at " + std::to_string(threshold), "right", error);
  }
}
