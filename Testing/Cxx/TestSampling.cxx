// How rays are sampled: steps, levels, limits, images of rays.
#include "FloatPicture.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace flatblock::testing;

namespace
{
double Waves(int x, int y, int z)
{
  return 0.5 + 0.2 * std::sin(0.3 * x + 0.3) * std::cos(0.25 * y) + 0.3 * std::sin(0.2 * z);
}

void ShowWaves(Scene& scene, double step)
{
  scene.SetVolume(MakeVolume({ 65, 65, 65 }, VTK_FLOAT, Waves), step);
  scene.SetRamp(0.0, 1.0, 0.1);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Mapper->SetBlockSize(17);
  scene.Window->SetSize(128, 128);
  scene.LookFrom(33.0, 21.0, 1.3);
}

// A uniform medium; its values are not, so that blocks have something to choose their levels by.
void ShowFog(Scene& scene)
{
  ShowWaves(scene, 0.5);
  scene.SetOpacity({ { -1.0, 0.02 }, { 2.0, 0.02 } });
  scene.SetColor({ { 0.0, 1.0, 0.5, 0.25 } });
  scene.Mapper->SetEarlyTerminationThreshold(1.0);
}
} // namespace

// Levels at random, by random points of interest in little memory: rays change their step at each
// border, and no pixel shows it.
TEST(Sampling, StepsThatFollowLevelsLeaveNoSeam)
{
  for (int classification = 0; classification < 3; ++classification)
  {
    for (const auto& point : std::vector<std::array<double, 3>>{
           { 0, 0, 0 }, { 64, 10, 30 }, { 32, 32, 32 }, { 20, 60, 60 } })
    {
      Scene scene;
      ShowFog(scene);
      scene.Mapper->SetClassification(classification);
      scene.Mapper->SetMaxMemoryInBytes(600000);
      scene.Mapper->UseCameraAsPointOfInterestOff();
      scene.Mapper->SetPointOfInterest(point[0], point[1], point[2]);
      scene.Mapper->SetUseJittering(point[0] > 40.0);
      const Picture drawn = TakeEvery(DrawFloats(scene), 128, 2);
      int levels = 0;
      for (int level = 0; level < 5; ++level)
      {
        levels += scene.Mapper->GetNumberOfBricks(level) > 0 ? 1 : 0;
      }
      EXPECT_GE(levels, 3);
      EXPECT_LE(LargestDifference(drawn, DrawReference(scene, 2)), 1.0 / 1024.0);
    }
  }
}

TEST(Sampling, AdaptiveStepsHardlyDiffer)
{
  Scene scene;
  ShowWaves(scene, 0.5);
  scene.Mapper->SetMaxMemoryInBytes(600000);
  const Picture adaptive = DrawFloats(scene);
  scene.Mapper->AdaptiveSamplingOff();
  const Picture fixed = DrawFloats(scene);
  const double psnr = PeakSignalToNoise(adaptive, fixed);
  std::cout << "adaptive against fixed steps: " << psnr << " dB\n";
  EXPECT_GE(psnr, 50.0);
  EXPECT_GT(LargestDifference(adaptive, fixed), 0.0);
  // At the finest level there is nothing to adapt.
  scene.Mapper->SetMaxMemoryInBytes(100 << 20);
  const Picture finest = DrawFloats(scene);
  scene.Mapper->AdaptiveSamplingOn();
  EXPECT_EQ(LargestDifference(DrawFloats(scene), finest), 0.0);
}

TEST(Sampling, JitteringMovesSamplesAndRepeats)
{
  Scene scene;
  ShowWaves(scene, 3.0);
  scene.Mapper->SetClassificationToPostInterpolation();
  const Picture plain = DrawFloats(scene);
  scene.Mapper->UseJitteringOn();
  const Picture jittered = DrawFloats(scene);
  EXPECT_GT(LargestDifference(plain, jittered), 1e-3);
  EXPECT_GE(PeakSignalToNoise(plain, jittered), 30.0);
  EXPECT_EQ(LargestDifference(DrawFloats(scene), jittered), 0.0);
}

TEST(Sampling, ImagesOfRaysOfAnotherSize)
{
  Scene scene;
  ShowWaves(scene, 0.5);
  scene.Renderer->SetBackground(0.2, 0.3, 0.4);
  const auto whole = scene.Draw();
  const vtkTypeInt64 bytes = scene.Mapper->GetMemoryInBytes();
  for (const auto& [distance, least] : std::vector<std::pair<double, double>>{
         { 0.5, 38.0 }, { 0.25, 38.0 }, { 2.0, 29.0 }, { 3.7, 24.0 }, { 100.0, 5.0 } })
  {
    scene.Mapper->SetImageSampleDistance(distance);
    const double psnr = PSNR(scene.Draw(), whole);
    std::cout << distance << " pixels a ray: " << psnr << " dB\n";
    EXPECT_GE(psnr, least) << distance;
    const double rays = std::pow(std::ceil(128.0 / distance), 2.0);
    EXPECT_EQ(scene.Mapper->GetMemoryInBytes() - bytes, static_cast<vtkTypeInt64>(8.0 * rays));
    EXPECT_EQ(scene.Mapper->GetUsedImageSampleDistance(), distance);
  }
  scene.Mapper->SetImageSampleDistance(1.0);
  EXPECT_EQ(LargestDifference(scene.Draw(), whole), 0.0);
  EXPECT_EQ(scene.Mapper->GetMemoryInBytes(), bytes) << "what is not used takes no memory";
}

TEST(Sampling, ImagesOfRaysKeepTheMemoryLimit)
{
  constexpr vtkTypeInt64 Limit = 1'200'000;
  Scene scene;
  ShowWaves(scene, 0.5);
  scene.Mapper->SetMaxMemoryInBytes(Limit);
  for (double distance : { 1.0, 0.5, 2.0, 0.7 })
  {
    for (int samples : { 0, 100 })
    {
      for (bool adjusts : { false, true })
      {
        scene.Mapper->SetImageSampleDistance(distance);
        scene.Mapper->SetMinimumImageSampleDistance(distance);
        scene.Mapper->SetMaximumNumberOfSamples(samples);
        scene.Mapper->SetAutoAdjustSampleDistances(adjusts);
        EXPECT_TRUE(ShowsSomething(scene.Draw()));
        EXPECT_LE(scene.Mapper->GetPeakMemoryInBytes(), Limit) << distance << " " << samples;
      }
    }
  }
}

// Interactive frames that take too long are drawn with fewer rays; stills are not.
TEST(Sampling, InteractiveFramesAdjustThemselves)
{
  Scene scene;
  ShowWaves(scene, 0.25);
  const auto still = scene.Draw();
  scene.Mapper->AutoAdjustSampleDistancesOn();
  scene.Window->SetDesiredUpdateRate(10000.0); // no frame is that quick
  scene.Volume->SetAllocatedRenderTime(1e-4, scene.Renderer);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Draw();
  }
  EXPECT_GE(scene.Mapper->GetUsedImageSampleDistance(), 2.0);
  EXPECT_LE(scene.Mapper->GetUsedImageSampleDistance(), 10.0);
  scene.Mapper->SetMaximumImageSampleDistance(3.0);
  scene.Draw();
  scene.Draw();
  EXPECT_LE(scene.Mapper->GetUsedImageSampleDistance(), 3.0);
  EXPECT_TRUE(ShowsSomething(scene.Draw()));
  scene.Window->SetDesiredUpdateRate(0.001);
  EXPECT_EQ(LargestDifference(scene.Draw(), still), 0.0);
  EXPECT_EQ(scene.Mapper->GetUsedImageSampleDistance(), 1.0);
}

TEST(Sampling, LockedStepsFollowTheSpacing)
{
  Scene scene;
  ShowWaves(scene, 7.0);
  scene.Mapper->LockSampleDistanceToInputSpacingOn();
  const Picture locked = DrawFloats(scene);
  // As vtkVolumeMapper has it, for 65^3 samples.
  const double fraction = std::cbrt(65.0 * 65.0 * 65.0 / 1e6);
  scene.Mapper->LockSampleDistanceToInputSpacingOff();
  scene.Mapper->SetSampleDistance(0.5 * fraction);
  EXPECT_GE(PeakSignalToNoise(locked, DrawFloats(scene)), 60.0);
  scene.Mapper->SetSampleDistance(7.0);
  EXPECT_LE(PeakSignalToNoise(locked, DrawFloats(scene)), 55.0);
}

// Cut off where it is, not darkened; and told.
TEST(Sampling, LimitsOfSamplesAreCounted)
{
  Scene scene;
  ShowFog(scene);
  scene.Mapper->HomogeneousLeapsOff(); // of the fog, which would be one sample
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0, 1.0);
  const Picture whole = DrawFloats(scene);
  vtkTypeInt64 rays = 0;
  for (const auto& pixel : whole)
  {
    rays += pixel[3] > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(scene.Mapper->GetNumberOfRaysCutOff(), 0);

  scene.Mapper->SetMaximumNumberOfSamples(129); // 64 voxels, both ends
  EXPECT_LE(LargestDifference(DrawFloats(scene), whole), 1e-3);
  EXPECT_EQ(scene.Mapper->GetNumberOfRaysCutOff(), 0);

  scene.Mapper->SetMaximumNumberOfSamples(41); // 20 voxels
  const Picture cut = DrawFloats(scene);
  EXPECT_EQ(scene.Mapper->GetNumberOfRaysCutOff(), rays);
  EXPECT_NEAR(cut[64 * 128 + 64][3], 1.0 - std::pow(0.98, 20.0), 1e-3);

  // Rays that are opaque before are not cut off.
  scene.SetOpacity({ { -1.0, 0.9 }, { 2.0, 0.9 } });
  scene.Mapper->SetEarlyTerminationThreshold(0.99);
  DrawFloats(scene);
  EXPECT_EQ(scene.Mapper->GetNumberOfRaysCutOff(), 0);
}

TEST(Sampling, RaysStartBehindTheEye)
{
  for (bool parallel : { false, true })
  {
    Scene scene;
    ShowFog(scene);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetPosition(32.0, 32.0, 44.0);
    camera->SetFocalPoint(32.0, 32.0, 0.0);
    camera->SetParallelScale(5.0);
    camera->SetClippingRange(parallel ? 4.0 : 1e-3, 200.0);
    const double begin = parallel ? 4.0 : 0.0;
    for (double offset : { 0.0, 10.0, 30.0, 100.0 })
    {
      scene.Mapper->SetRayStartOffset(offset);
      const double length = std::max(44.0 - std::max(begin + offset, 1e-3), 0.0);
      EXPECT_NEAR(DrawFloats(scene)[64 * 128 + 64][3], 1.0 - std::pow(0.98, length), 1e-3)
        << offset;
    }
    // In world units: of a prop that is twice as large.
    scene.Volume->SetScale(2.0);
    camera->SetPosition(64.0, 64.0, 88.0);
    camera->SetFocalPoint(64.0, 64.0, 0.0);
    camera->SetClippingRange(parallel ? 8.0 : 1e-3, 400.0);
    scene.Mapper->SetRayStartOffset(20.0);
    EXPECT_NEAR(
      DrawFloats(scene)[64 * 128 + 64][3], 1.0 - std::pow(0.98, 44.0 - 10.0 - begin), 1e-3);
  }
}
