// Levels of detail within a limit of memory.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkCallbackCommand.h"
#include "vtkExtractVOI.h"
#include "vtkPlane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>

using namespace flatblock::testing;

TEST(Levels, ErrorFallsAsTheLimitRises)
{
  Scene scene;
  ShowShell(scene, 256 << 20);
  scene.Mapper->SetSkippingToNothing(); // its map would leave more to the bricks at low limits
  const auto full = scene.Draw();
  const vtkTypeInt64 beside = scene.Mapper->GetMemoryInBytes() - scene.Mapper->GetAtlasBytes();
  const vtkTypeInt64 bricks = scene.Mapper->GetUsedAtlasBytes();
  EXPECT_EQ(scene.Mapper->GetNumberOfBricks(0), scene.Mapper->GetNumberOfVisibleBlocks());
  double last = 100.0;
  for (int part : { 2, 8, 32 })
  {
    const vtkTypeInt64 limit = beside + bricks / part;
    scene.Mapper->SetMaxMemoryInBytes(limit);
    const double psnr = PSNR(scene.Draw(), full);
    std::cout << "1/" << part << " of the bricks: " << psnr << " dB\n";
    EXPECT_LE(scene.Mapper->GetMemoryInBytes(), limit);
    EXPECT_GE(scene.Mapper->GetUsedAtlasBytes(), bricks / part * 7 / 10);
    EXPECT_EQ(CountBricks(scene.Mapper), scene.Mapper->GetNumberOfVisibleBlocks());
    EXPECT_LT(psnr, last);
    EXPECT_GE(psnr, 15.0);
    EXPECT_TRUE(MatchesBaseline(scene.Window, "LevelsAt" + std::to_string(part)));
    last = psnr;
  }
  scene.Mapper->SetMaxMemoryInBytes(256 << 20);
  EXPECT_EQ(LargestDifference(scene.Draw(), full), 0.0);
}

namespace
{
// Everything that a walk changes, so that a fresh scene can be brought to the same place.
struct Inputs
{
  double Azimuth = 30.0;
  double Elevation = 40.0;
  double Zoom = 1.3;
  bool IsCameraOfInterest = true;
  double Point[3] = { 0.0, 0.0, 0.0 };
  vtkTypeInt64 Limit = 800000;
  double Ramp[3] = { 90.0, 200.0, 0.5 };
  int Size = 200;
  int BlockSize = 17;
  bool IsContinuous = true;
  bool IsFiltered = false;
  int Criterion = 0;
  bool IsWeighted = false;

  void ApplyTo(Scene& scene) const
  {
    scene.Window->SetSize(this->Size, this->Size);
    scene.Mapper->SetBlockSize(this->BlockSize);
    scene.Mapper->SetMaxMemoryInBytes(this->Limit);
    scene.Mapper->SetInterblockContinuity(this->IsContinuous);
    scene.Mapper->SetLevelFilter(this->IsFiltered);
    scene.Mapper->SetSelectionCriterion(this->Criterion);
    scene.Mapper->SetDistortionBlocksPerFrame(40);
    scene.Mapper->SetVisibilityWeighting(this->IsWeighted);
    scene.Mapper->SetUseCameraAsPointOfInterest(this->IsCameraOfInterest);
    scene.Mapper->SetPointOfInterest(this->Point[0], this->Point[1], this->Point[2]);
    scene.SetRamp(this->Ramp[0], this->Ramp[1], this->Ramp[2]);
    scene.LookFrom(this->Azimuth, this->Elevation, this->Zoom);
  }

  void ChangeOne(std::mt19937& random)
  {
    const auto uniform = [&random](double from, double to)
    { return std::uniform_real_distribution<double>(from, to)(random); };
    switch (random() % 14)
    {
    case 0:
      this->Limit = Beside + vtkTypeInt64(uniform(1e5, 3e6));
      break;
    case 1:
      this->Ramp[0] = uniform(0.0, 120.0);
      this->Ramp[1] = uniform(130.0, 255.0);
      this->Ramp[2] = uniform(0.1, 0.9);
      break;
    case 2:
    case 3:
    case 4:
      this->IsCameraOfInterest = random() % 4 == 0;
      std::generate(this->Point, this->Point + 3, [&] { return uniform(-1.0, 1.0); });
      break;
    case 5:
      this->Size = 100 + int(random() % 150);
      break;
    case 6:
      this->BlockSize = random() % 2 == 0 ? 17 : 33;
      break;
    case 7:
      this->IsContinuous = !this->IsContinuous;
      break;
    case 8:
      this->IsFiltered = !this->IsFiltered;
      break;
    case 9:
    case 10:
      this->Criterion = int(random() % 3);
      this->IsWeighted = random() % 2 == 0;
      break;
    default:
      this->Azimuth = uniform(0.0, 360.0);
      this->Elevation = uniform(-80.0, 80.0);
      this->Zoom = uniform(0.8, 2.0);
    }
  }
};
} // namespace

TEST(Levels, StillsDependOnTheirInputsAlone)
{
  std::mt19937 random(14);
  Inputs inputs;
  Scene walked;
  ShowShell(walked, inputs.Limit);
  vtkTypeInt64 moved = 0;
  for (int step = 0; step < 60; ++step)
  {
    walked.Window->SetDesiredUpdateRate(15.0);
    for (int frame = int(random() % 4); frame > 0; --frame)
    {
      inputs.ChangeOne(random);
      inputs.ApplyTo(walked);
      walked.Window->Render();
      moved += walked.Mapper->GetMovedBytes();
    }
    walked.Window->SetDesiredUpdateRate(0.0001);
    const vtkTypeInt64 limitBefore = walked.Mapper->GetMaxMemoryInBytes();
    inputs.ChangeOne(random);
    inputs.ApplyTo(walked);
    const auto picture = walked.Draw();
    moved += walked.Mapper->GetMovedBytes();
    ASSERT_LE(walked.Mapper->GetMemoryInBytes(), inputs.Limit);
    ASSERT_LE(walked.Mapper->GetPeakMemoryInBytes(), std::max(inputs.Limit, limitBefore));
    Scene fresh;
    ShowShell(fresh, inputs.Limit);
    inputs.ApplyTo(fresh);
    ASSERT_EQ(LargestDifference(picture, fresh.Draw()), 0.0) << "step " << step;
    ASSERT_EQ(walked.Mapper->GetAtlasBytes(), fresh.Mapper->GetAtlasBytes()) << "step " << step;
  }
  EXPECT_GT(moved, 1000000);
}

TEST(Levels, PointOfInterestIsFinest)
{
  Scene scene;
  ShowShell(scene, 500000);
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
  ShowShell(still, 800000);
  const auto converged = still.Draw();
  EXPECT_TRUE(still.Mapper->GetConverged());

  Scene scene;
  ShowShell(scene, 800000);
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
    const vtkTypeInt64 pending = scene.Mapper->GetNumberOfPendingChanges();
    scene.Draw();
    EXPECT_LE(scene.Mapper->GetUploadedBytes(), 100000);
    EXPECT_LE(scene.Mapper->GetMovedBytes(), 100000);
    EXPECT_LE(scene.Mapper->GetPeakMemoryInBytes(), 800000);
    EXPECT_LT(scene.Mapper->GetNumberOfPendingChanges(), pending);
    EXPECT_GE(scene.Mapper->GetNumberOfPendingChanges(), pending - 512 / 20);
  }
  EXPECT_GT(scene.Mapper->RenderUntilConverged(scene.Window), 2);
  EXPECT_EQ(scene.Mapper->GetNumberOfPendingChanges(), 0);
  // The same levels at other places of the atlas, where texture units round differently.
  EXPECT_GE(PSNR(Grab(scene.Window), converged), 60.0);
  scene.Window->SetDesiredUpdateRate(0.0001);
  EXPECT_EQ(LargestDifference(scene.Draw(), converged), 0.0);
  ASSERT_GT(progress.size(), 4U);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1.0);
}

TEST(Levels, HiddenVolumesAreNotWaitedFor)
{
  Scene scene;
  ShowShell(scene, 800000);
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
  ShowShell(scene, 800000);
  scene.Mapper->SetRefinementFraction(0.01);
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Draw();
  EXPECT_FALSE(scene.Mapper->GetConverged());
  scene.Window->SetDesiredUpdateRate(0.0001);
  const auto picture = scene.Draw();
  EXPECT_TRUE(scene.Mapper->GetConverged());
  Scene fresh;
  ShowShell(fresh, 800000);
  EXPECT_EQ(LargestDifference(picture, fresh.Draw()), 0.0);
}

TEST(Levels, StillsMayConvergeStepByStep)
{
  Scene scene;
  ShowShell(scene, 800000);
  const auto converged = scene.Draw();
  Scene steps;
  ShowShell(steps, 800000);
  steps.Mapper->ProgressiveStillsOn();
  steps.Mapper->SetRefinementFraction(0.05);
  EXPECT_LT(PSNR(steps.Draw(), converged), 40.0);
  EXPECT_FALSE(steps.Mapper->GetConverged());
  EXPECT_GT(steps.Mapper->RenderUntilConverged(steps.Window), 4);
  EXPECT_GE(PSNR(steps.Draw(), converged), 60.0);
  steps.Mapper->ProgressiveStillsOff();
  EXPECT_EQ(LargestDifference(steps.Draw(), converged), 0.0);
}

TEST(Levels, StatisticsAreComplete)
{
  Scene scene;
  ShowShell(scene, 800000);
  scene.Draw();
  scene.Draw();
  const vtkFlatBlockVolumeMapper* mapper = scene.Mapper;
  EXPECT_EQ(
    mapper->GetUsedAtlasBytes() + mapper->GetFreeAtlasBytes() + mapper->GetUnusableAtlasBytes(),
    mapper->GetAtlasBytes());
  EXPECT_GT(mapper->GetUsedAtlasBytes(), mapper->GetAtlasBytes() / 2);
  EXPECT_GT(mapper->GetSelectionMilliseconds() + mapper->GetUploadMilliseconds(), 0.0);
  EXPECT_GT(mapper->GetDrawMilliseconds(), 0.0);
  EXPECT_GE(mapper->GetRangeMilliseconds(), 0.0);
  EXPECT_EQ(mapper->GetFramesSinceLastChange(), 1);
  std::ostringstream printed;
  scene.Mapper->PrintStatistics(printed);
  for (const char* words : { "Blocks: 512", "Visible blocks: ", "Bricks by level: ", "unusable",
         "0 bytes uploaded, 0 moved", "Changes pending: 0", "Frames since the last change: 1",
         "Milliseconds: ranges " })
  {
    EXPECT_NE(printed.str().find(words), std::string::npos) << words << "\n" << printed.str();
  }
}

namespace
{
// PSNR of the left and of the right half of two pictures.
std::array<double, 2> ComparedHalves(vtkImageData* a, vtkImageData* b)
{
  std::array<double, 2> psnr;
  const int width = a->GetDimensions()[0];
  for (int half = 0; half < 2; ++half)
  {
    vtkSmartPointer<vtkImageData> parts[2];
    for (int picture = 0; picture < 2; ++picture)
    {
      vtkNew<vtkExtractVOI> extract;
      extract->SetInputData(picture == 0 ? a : b);
      extract->SetVOI(
        half * width / 2, (half + 1) * width / 2 - 1, 0, a->GetDimensions()[1] - 1, 0, 0);
      extract->Update();
      parts[picture] = extract->GetOutput();
    }
    psnr[half] = PSNR(parts[0], parts[1]);
  }
  return psnr;
}
} // namespace

// What is beyond a plane or not in the cropping gives its memory to the rest.
TEST(Levels, ClippedAndCroppedBlocksComeLast)
{
  Scene scene;
  ShowShell(scene, 256 << 20);
  scene.LookFrom(0.0, 60.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Mapper->UseCameraAsPointOfInterestOff();
  scene.Mapper->SetPointOfInterest(0.0, 0.0, 100.0);
  const auto full = scene.Draw();
  scene.Mapper->SetMaxMemoryInBytes(900000);
  const auto before = ComparedHalves(scene.Draw(), full);
  EXPECT_NEAR(before[0], before[1], 1.0);
  scene.Mapper->PrintStatistics(std::cout);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(-1.0, 0.0, 0.0); // keeps the left half
  scene.Mapper->AddClippingPlane(plane);
  const auto clipped = ComparedHalves(scene.Draw(), full);
  scene.Mapper->PrintStatistics(std::cout);
  EXPECT_GE(clipped[0], before[0] + 3.0);
  EXPECT_GE(clipped[0], clipped[1] + 10.0);
  scene.Mapper->RemoveAllClippingPlanes();
  EXPECT_EQ(ComparedHalves(scene.Draw(), full), before);
  const double* bounds = scene.Mapper->GetBounds();
  const double middle = 0.02; // where the fifth block begins
  scene.Mapper->SetCroppingRegionPlanes(
    middle, bounds[1], bounds[2], bounds[3], bounds[4], bounds[5]);
  scene.Mapper->SetCroppingRegionFlagsToSubVolume();
  scene.Mapper->CroppingOn(); // keeps the right half
  const auto cropped = ComparedHalves(scene.Draw(), full);
  EXPECT_GE(cropped[1], before[1] + 3.0);
  EXPECT_GE(cropped[1], cropped[0] + 10.0);
}

TEST(Levels, NothingHasConvergedBeforeTheFirstFrame)
{
  Scene scene;
  ShowShell(scene, 800000);
  EXPECT_FALSE(scene.Mapper->GetConverged());
  scene.Draw();
  EXPECT_TRUE(scene.Mapper->GetConverged());
}

// A ripple of a few samples is gone where it is filtered, and turns into another one where it is
// subsampled.
TEST(Levels, FilteredLevelsAreSmooth)
{
  const auto ripple = MakeVolume({ 129, 65, 65 }, VTK_UNSIGNED_SHORT,
    [](int x, int y, int z) { return 20000.0 + 10000.0 * std::sin(2.9 * x) + 50.0 * (y + z); });
  Scene scene;
  scene.SetVolume(ripple, 0.5);
  scene.SetRamp(10000.0, 40000.0, 0.05);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetMaxMemoryInBytes(379152);
  scene.LookFrom(20.0, 30.0);
  scene.Draw();
  EXPECT_LT(scene.Mapper->GetNumberOfBricks(0), 5);
  EXPECT_TRUE(MatchesBaseline(scene.Window, "LevelsSubsampled"));
  scene.Mapper->SetLevelFilterToTent();
  EXPECT_EQ(scene.Mapper->GetLevelFilter(), vtkFlatBlockVolumeMapper::TENT);
  scene.Draw();
  EXPECT_TRUE(MatchesBaseline(scene.Window, "LevelsFiltered"));
  scene.Mapper->SetLevelFilterToSubsample();
  scene.Draw();
  EXPECT_TRUE(MatchesBaseline(scene.Window, "LevelsSubsampled"));
}
