// Levels of detail within a limit of memory.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkCallbackCommand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

using namespace flatblock::testing;

namespace
{
constexpr vtkTypeInt64 Beside = 1 << 19; // index, table, depth: all that is not atlas, at most

void Prepare(Scene& scene, vtkTypeInt64 limit)
{
  scene.SetVolume(MarschnerLobb(128), 0.5 * 2.0 / 127.0);
  scene.SetOpacity({ { 90.0, 0.0 }, { 125.0, 0.6 }, { 160.0, 0.0 } });
  scene.SetColor({ { 90.0, 0.2, 0.4, 0.9 }, { 125.0, 0.9, 0.9, 0.7 }, { 160.0, 0.9, 0.3, 0.1 } });
  scene.Property->SetScalarOpacityUnitDistance(0.01);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetMaxMemoryInBytes(limit);
  scene.LookFrom(30.0, 40.0, 1.3);
}

vtkTypeInt64 CountBricks(vtkFlatBlockVolumeMapper* mapper)
{
  vtkTypeInt64 bricks = 0;
  for (int level = 0; level < 7; ++level)
  {
    bricks += mapper->GetNumberOfBricks(level);
  }
  return bricks;
}
} // namespace

TEST(Levels, ErrorFallsAsTheLimitRises)
{
  Scene scene;
  Prepare(scene, 256 << 20);
  const auto full = scene.Draw();
  const vtkTypeInt64 all = scene.Mapper->GetMemoryInBytes();
  const vtkTypeInt64 atlas = scene.Mapper->GetAtlasBytes();
  EXPECT_EQ(scene.Mapper->GetNumberOfBricks(0), scene.Mapper->GetNumberOfVisibleBlocks());
  double last = 100.0;
  for (int part : { 2, 8, 32 })
  {
    const vtkTypeInt64 limit = all - atlas + atlas / part;
    scene.Mapper->SetMaxMemoryInBytes(limit);
    const double psnr = PSNR(scene.Draw(), full);
    std::cout << "1/" << part << " of the atlas: " << psnr << " dB\n";
    EXPECT_LE(scene.Mapper->GetMemoryInBytes(), limit);
    EXPECT_GE(scene.Mapper->GetAtlasBytes(), atlas / part * 8 / 10);
    EXPECT_EQ(CountBricks(scene.Mapper), scene.Mapper->GetNumberOfVisibleBlocks());
    EXPECT_LT(psnr, last);
    EXPECT_GE(psnr, 15.0);
    EXPECT_TRUE(MatchesBaseline(scene.Window, "LevelsAt" + std::to_string(part)));
    last = psnr;
  }
  scene.Mapper->SetMaxMemoryInBytes(256 << 20);
  EXPECT_LE(LargestDifference(scene.Draw(), full), 1.0);
}

TEST(Levels, LimitHoldsUnderRandomChanges)
{
  std::mt19937 random(5);
  const auto uniform = [&random](double from, double to)
  { return std::uniform_real_distribution<double>(from, to)(random); };
  Scene scene;
  Prepare(scene, 256 << 20);
  for (int change = 0; change < 60; ++change)
  {
    const vtkTypeInt64 limitBefore = scene.Mapper->GetMaxMemoryInBytes();
    switch (random() % 6)
    {
    case 0:
      scene.Mapper->SetMaxMemoryInBytes(Beside + vtkTypeInt64(uniform(5e4, 3e6)));
      break;
    case 1:
    {
      const int sizes[] = { 17, 33, 65 };
      scene.Mapper->SetBlockSize(sizes[random() % 3]);
      break;
    }
    case 2:
      scene.SetRamp(uniform(0.0, 120.0), uniform(130.0, 255.0), uniform(0.1, 0.9));
      break;
    case 3:
      scene.Mapper->SetUseCameraAsPointOfInterest(random() % 2 == 0);
      scene.Mapper->SetPointOfInterest(uniform(-1.0, 1.0), uniform(-1.0, 1.0), 0.5);
      break;
    case 4:
      scene.Window->SetSize(int(uniform(60.0, 300.0)), int(uniform(60.0, 300.0)));
      break;
    default:
      scene.LookFrom(uniform(0.0, 360.0), uniform(-80.0, 80.0));
    }
    const auto messages = Listen([&] { scene.Window->Render(); });
    ASSERT_TRUE(messages.Errors.empty()) << change << ": " << messages.Errors[0];
    const vtkTypeInt64 limit = scene.Mapper->GetMaxMemoryInBytes();
    ASSERT_LE(scene.Mapper->GetMemoryInBytes(), limit) << "change " << change;
    ASSERT_LE(scene.Mapper->GetPeakMemoryInBytes(), std::max(limit, limitBefore)) << change;
    ASSERT_EQ(CountBricks(scene.Mapper), scene.Mapper->GetNumberOfVisibleBlocks());
  }
  EXPECT_TRUE(ShowsSomething(Grab(scene.Window)));
}

TEST(Levels, ConvergedPicturesDependOnTheirInputsAlone)
{
  Scene walked;
  Prepare(walked, 500000);
  for (double azimuth : { 0.0, 90.0, 200.0 })
  {
    walked.LookFrom(azimuth, 10.0);
    walked.Draw();
  }
  walked.LookFrom(30.0, 40.0, 1.3);
  Scene fresh;
  Prepare(fresh, 500000);
  // Bricks at other places of the atlas round differently in the last bit.
  EXPECT_LE(LargestDifference(walked.Draw(), fresh.Draw()), 1.0);
  for (int level = 0; level < 5; ++level)
  {
    EXPECT_EQ(walked.Mapper->GetNumberOfBricks(level), fresh.Mapper->GetNumberOfBricks(level));
  }
}

// Bricks that move within the atlas must show what they showed before.
TEST(Levels, CompactionIsNotSeen)
{
  vtkTypeInt64 moved = 0;
  Scene walked;
  Prepare(walked, 900000);
  walked.Mapper->UseCameraAsPointOfInterestOff();
  std::mt19937 random(4);
  for (int step = 0; step < 40; ++step)
  {
    std::uniform_real_distribution<double> anywhere(-1.5, 1.5);
    const double point[3] = { anywhere(random), anywhere(random), anywhere(random) };
    walked.Mapper->SetPointOfInterest(point[0], point[1], point[2]);
    const auto picture = walked.Draw();
    moved += walked.Mapper->GetMovedBytes();
    if (walked.Mapper->GetMovedBytes() > 0)
    {
      Scene fresh;
      Prepare(fresh, 900000);
      fresh.Mapper->UseCameraAsPointOfInterestOff();
      fresh.Mapper->SetPointOfInterest(point[0], point[1], point[2]);
      // Single pixels differ, since bricks at other places round differently.
      ASSERT_GE(PSNR(picture, fresh.Draw()), 75.0) << "step " << step;
    }
  }
  EXPECT_GT(moved, 0);
}

TEST(Levels, PointOfInterestIsFinest)
{
  Scene scene;
  Prepare(scene, 500000);
  const auto nearCamera = scene.Draw();
  scene.Mapper->UseCameraAsPointOfInterestOff();
  scene.Mapper->SetPointOfInterest(-1.0, -1.0, -1.0);
  EXPECT_LT(PSNR(scene.Draw(), nearCamera), 50.0);
  EXPECT_GT(scene.Mapper->GetUploadedBytes(), 0);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);
}

TEST(Levels, InteractiveFramesRefineWithinTheirBudget)
{
  Scene still;
  Prepare(still, 800000);
  const auto converged = still.Draw();
  EXPECT_TRUE(still.Mapper->GetConverged());

  Scene scene;
  Prepare(scene, 800000);
  scene.Mapper->SetRefinementFraction(0.05);
  scene.Mapper->SetUploadBytesPerFrame(100000);
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> onProgress;
  onProgress->SetClientData(&progress);
  onProgress->SetCallback([](vtkObject*, unsigned long, void* list, void* amount)
    { static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(amount)); });
  scene.Window->SetDesiredUpdateRate(15.0);
  const auto first = scene.Draw(); // in which the pipeline reports its own progress
  scene.Mapper->AddObserver(vtkCommand::ProgressEvent, onProgress);
  EXPECT_TRUE(ShowsSomething(first));
  EXPECT_FALSE(scene.Mapper->GetConverged());
  EXPECT_LT(PSNR(first, converged), 40.0);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Draw();
    // Bricks that only get a new border come on top.
    EXPECT_LE(scene.Mapper->GetUploadedBytes(), 400000);
    EXPECT_LE(scene.Mapper->GetPeakMemoryInBytes(), 800000);
  }
  EXPECT_GT(scene.Mapper->RenderUntilConverged(scene.Window), 2);
  EXPECT_LE(LargestDifference(Grab(scene.Window), converged), 1.0);
  ASSERT_GT(progress.size(), 4U);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1.0);
}

TEST(Levels, HiddenVolumesAreNotWaitedFor)
{
  Scene scene;
  Prepare(scene, 800000);
  scene.Mapper->SetRefinementFraction(0.01);
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Draw();
  ASSERT_FALSE(scene.Mapper->GetConverged());
  scene.Volume->VisibilityOff();
  EXPECT_EQ(scene.Mapper->RenderUntilConverged(scene.Window), 1);
  scene.Volume->VisibilityOn();
  scene.Mapper->RenderUntilConverged(scene.Window);
  EXPECT_TRUE(scene.Mapper->GetConverged());
}

TEST(Levels, StillsConvergeBeforeTheyAreShown)
{
  Scene scene;
  Prepare(scene, 800000);
  scene.Mapper->SetRefinementFraction(0.01);
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Draw();
  EXPECT_FALSE(scene.Mapper->GetConverged());
  scene.Window->SetDesiredUpdateRate(0.0001);
  const auto picture = scene.Draw();
  EXPECT_TRUE(scene.Mapper->GetConverged());
  Scene fresh;
  Prepare(fresh, 800000);
  EXPECT_LE(LargestDifference(picture, fresh.Draw()), 1.0);
}

TEST(Levels, StatisticsAreComplete)
{
  Scene scene;
  Prepare(scene, 800000);
  scene.Draw();
  scene.Draw();
  std::ostringstream printed;
  scene.Mapper->PrintStatistics(printed);
  for (const char* words : { "Blocks: 512", "Visible blocks: ", "Bricks by level: ", "unusable",
         "0 bytes uploaded, 0 moved", "Levels reached: 100 %", "Frames since the last change: 1",
         "Milliseconds: ranges " })
  {
    EXPECT_NE(printed.str().find(words), std::string::npos) << words << "\n" << printed.str();
  }
}

TEST(Levels, TooLittleMemoryIsSaid)
{
  Scene scene;
  Prepare(scene, 1000);
  vtkSmartPointer<vtkImageData> picture;
  const auto messages = Listen(
    [&]
    {
      scene.Draw();
      picture = scene.Draw();
    });
  ASSERT_EQ(messages.Errors.size(), 1U);
  EXPECT_NE(messages.Errors[0].find("bytes are needed"), std::string::npos);
  EXPECT_FALSE(ShowsSomething(picture));
  scene.Mapper->SetMaxMemoryInBytes(256 << 20);
  EXPECT_TRUE(ShowsSomething(scene.Draw()));
}

TEST(Levels, VolumesLongerThanTheLargestTexture)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 5000, 34, 34 }, VTK_UNSIGNED_CHAR,
                    [](int x, int y, int z) { return 128 + 100 * std::sin(0.01 * x) + y - z; }),
    2.0);
  scene.SetRamp(30.0, 240.0, 0.05);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0, 8.0);
  for (double along : { 400.0, 2500.0, 4700.0 })
  {
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(along, 17.0, 1000.0);
    camera->SetFocalPoint(along, 17.0, 0.0);
    camera->SetParallelScale(100.0);
    scene.Renderer->ResetCameraClippingRange();
    scene.Mapper->SetMaxMemoryInBytes(256 << 20);
    const auto full = scene.Draw();
    EXPECT_TRUE(ShowsSomething(full)) << along;
    scene.Mapper->SetMaxMemoryInBytes(Beside + 800000);
    EXPECT_GE(PSNR(scene.Draw(), full), 35.0) << along;
    EXPECT_GT(scene.Mapper->GetNumberOfBricks(1), 0);
  }
}
