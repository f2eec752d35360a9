// Dimensions far from what is usual.
#include "Extremes.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace flatblock::testing;

namespace
{
const char* const Group = "dimensions";

std::string Text(const std::array<int, 3>& n)
{
  return std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
}
} // namespace

TEST(ExtremeSizes, OfEveryKind)
{
  for (const std::array<int, 3>& samples :
    { std::array<int, 3>{ 2, 2, 2 }, { 2, 3, 40 }, { 4097, 3, 3 }, { 3, 4097, 3 }, { 3, 3, 4097 },
      { 31, 37, 41 }, { 33, 33, 33 }, { 34, 34, 34 }, { 33, 34, 35 }, { 65, 66, 17 } })
  {
    Scene scene;
    ShowWaves(scene, samples);
    if (*std::max_element(samples.begin(), samples.end()) > 4000)
    {
      scene.LookFrom(33.0, 21.0, 300.0); // a needle: only its middle
    }
    ExpectRight(scene, Group, Text(samples), 0.01);
  }
}

// So many steps that a small part of one is nothing in single precision, and an edge of many
// colours that asks for small parts.
TEST(ExtremeSizes, LongRaysEnd)
{
  Scene scene;
  ShowWaves(scene, { 4097, 3, 3 });
  scene.Window->SetSize(16, 16);
  scene.SetVolume(
    MakeVolume({ 4097, 3, 3 }, VTK_FLOAT, [](int x, int, int) { return x > 100 ? 0.0 : 1.0; }),
    1.0 / 32.0);
  scene.SetOpacity({ { 0.0, 0.0 }, { 0.1, 0.0 }, { 0.2, 0.99 }, { 1.0, 0.99 } });
  std::vector<std::array<double, 4>> colors;
  for (int i = 0; i <= 1000; ++i)
  {
    colors.push_back({ 0.001 * i, i % 2 ? 1.0 : 0.0, i % 3 ? 0.0 : 1.0, 0.001 * i });
  }
  scene.SetColor(colors);
  scene.Property->SetScalarOpacityUnitDistance(0.02);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(90.0, 0.0);
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.9);
  ExpectRight(scene, Group, "an edge behind 128000 steps along a ray", 0.02);
}

// A sheet has no thickness, so it has no opacity either: nothing can be drawn.
TEST(ExtremeSizes, WithoutThicknessThereIsAnErrorThatSaysSo)
{
  for (const std::array<int, 3>& samples :
    { std::array<int, 3>{ 1, 1, 1 }, { 1, 20, 30 }, { 20, 1, 30 }, { 20, 30, 1 } })
  {
    Scene scene;
    ShowWaves(scene, samples);
    Picture picture;
    const auto messages = Listen(
      [&]
      {
        picture = DrawFloats(scene);
        picture = DrawFloats(scene);
      });
    ASSERT_EQ(messages.Errors.size(), 1U);
    EXPECT_NE(messages.Errors[0].find(Text(samples)), std::string::npos);
    EXPECT_EQ(LargestDifference(picture, Picture(picture.size())), 0.0);
    Record(Group, Text(samples), "nothing is drawn, one error says why", 0.0);
  }
}
