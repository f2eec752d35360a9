#include "Extremes.h"

#include "Volumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace flatblock::testing
{
double WaveAt(double x, double y, double z)
{
  return 0.5 + 0.2 * std::sin(0.7 * x + 0.3) * std::cos(0.5 * y) +
         0.3 * std::sin(0.4 * z - 0.2 * x);
}

void ShowWaves(Scene& scene, const std::array<int, 3>& samples, double step)
{
  scene.SetVolume(MakeVolume(samples, VTK_FLOAT, WaveAt), step);
  scene.SetRamp(0.0, 1.0, 0.3);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Window->SetSize(64, 64);
  scene.LookFrom(33.0, 21.0, 1.2);
}

Outcome CompareWithReference(Scene& scene, int stride)
{
  Outcome outcome;
  Picture drawn;
  outcome.Said = Listen([&] { drawn = DrawFloats(scene); });
  EXPECT_TRUE(IsSound(drawn));
  EXPECT_TRUE(outcome.Said.Errors.empty())
    << (outcome.Said.Errors.empty() ? "" : outcome.Said.Errors.front());
  const Picture expected = DrawReference(scene, stride);
  outcome.Error = LargestDifference(TakeEvery(drawn, scene.Window->GetSize()[0], stride), expected);
  for (const auto& pixel : expected)
  {
    outcome.Brightest = std::max(outcome.Brightest, *std::max_element(pixel.begin(), pixel.end()));
  }
  return outcome;
}

void ExpectRight(Scene& scene, const std::string& group, const std::string& what, double bound,
  const std::string& came)
{
  const Outcome outcome = CompareWithReference(scene);
  std::cout << group << ", " << what << ": error " << outcome.Error << " of " << outcome.Brightest
            << "\n";
  EXPECT_LE(outcome.Error, bound) << group << ", " << what;
  std::string result = came;
  for (const std::string& warning : outcome.Said.Warnings)
  {
    const auto colon = warning.find("): ");
    std::string text = warning.substr(colon == std::string::npos ? 0 : colon + 3);
    text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
    result += (result.empty() ? "warning: " : "; warning: ") + text;
  }
  Record(group, what, result.empty() ? "right" : result, outcome.Error);
}

std::string ToText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

void Record(
  const std::string& group, const std::string& what, const std::string& came, double error)
{
  if (const char* file = std::getenv("FLATBLOCK_EXTREMES"))
  {
    std::ofstream(file, std::ios::app)
      << group << "\t" << what << "\t" << came << "\t" << error << "\n";
  }
}
} // namespace flatblock::testing
