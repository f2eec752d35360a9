// Data that changes from frame to frame.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>

using namespace flatblock::testing;

namespace
{
constexpr int Steps = 100;

double WaveAt(int step, int x, int y, int z)
{
  return std::round(127.0 + 60.0 * std::sin(0.21 * x + 0.1 * step) +
                    60.0 * std::cos(0.17 * y - 0.12 * z + 0.07 * step));
}

vtkSmartPointer<vtkImageData> MakeStep(int step)
{
  return MakeVolume({ 49, 49, 49 }, VTK_UNSIGNED_CHAR,
    [step](int x, int y, int z) { return WaveAt(step, x, y, z); });
}

void Show(Scene& scene, vtkImageData* image)
{
  scene.SetVolume(image, 0.5);
  scene.SetOpacity({ { 0.0, 0.0 }, { 255.0, 0.2 } });
  scene.SetColor({ { 0.0, 0.8, 0.3, 0.2 }, { 255.0, 0.9, 0.9, 0.7 } });
  scene.Window->SetSize(64, 64);
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0);
}

// Of this process, resident.
double GetMegabytes()
{
  constexpr double PagesPerMegabyte = 256.0;
  std::ifstream file("/proc/self/statm");
  double size = 0.0;
  double resident = 0.0;
  file >> size >> resident;
  return resident / PagesPerMegabyte;
}

// Memory stays what it was after the first tenth of the steps.
void ExpectNoGrowth(Scene& scene, const std::function<void(int)>& advance)
{
  constexpr int WarmUp = Steps / 10;
  constexpr double MostMegabytes = 8.0; // some steps of such data
  vtkTypeInt64 card = 0;
  double megabytes = 0.0;
  for (int step = 0; step < Steps; ++step)
  {
    advance(step);
    scene.Window->Render();
    if (step == WarmUp)
    {
      card = scene.Mapper->GetMemoryInBytes();
      megabytes = GetMegabytes();
    }
    if (step > WarmUp)
    {
      ASSERT_EQ(scene.Mapper->GetMemoryInBytes(), card) << step;
      ASSERT_EQ(scene.Mapper->GetPeakMemoryInBytes(), card) << step; // nothing beside the last
    }
  }
  EXPECT_GT(card, 0);
  EXPECT_LE(GetMegabytes() - megabytes, MostMegabytes);
}
} // namespace

TEST(TimeSeries, OfNewImagesKeepsTheMemory)
{
  Scene scene;
  Show(scene, MakeStep(0));
  ExpectNoGrowth(scene, [&](int step) { scene.Mapper->SetInputData(MakeStep(step)); });
  const Picture last = DrawFloats(scene);
  Scene fresh;
  Show(fresh, MakeStep(Steps - 1));
  fresh.Renderer->GetActiveCamera()->DeepCopy(scene.Renderer->GetActiveCamera());
  EXPECT_EQ(LargestDifference(DrawFloats(fresh), last), 0.0);
}

TEST(TimeSeries, OfOneImageKeepsTheMemory)
{
  Scene scene;
  const auto image = MakeStep(0);
  Show(scene, image);
  scene.Property->ShadeOn();
  scene.Mapper->SetMaxMemoryInBytes(Beside + 60000);
  scene.Mapper->SetSelectionCriterionToDistortion();
  ExpectNoGrowth(scene,
    [&](int step)
    {
      image->GetPointData()->GetScalars()->DeepCopy(MakeStep(step)->GetPointData()->GetScalars());
      image->Modified();
    });
}
