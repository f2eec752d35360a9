// Levels chosen by how wrong the classified volume would look.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace flatblock::testing;

namespace
{
// Half of it smooth, half of it fine ripples: near and far say nothing of where detail is.
vtkSmartPointer<vtkImageData> HalfRipples()
{
  return MakeVolume({ 97, 97, 97 }, VTK_UNSIGNED_SHORT,
    [](int x, int y, int z)
    {
      const double ripple = x > 48 ? 300.0 * std::sin(1.3 * x) * std::sin(1.1 * y) : 0.0;
      return 1000.0 + 2.0 * (x + y + z) + ripple;
    });
}

void ShowHalfRipples(Scene& scene, vtkTypeInt64 limit)
{
  scene.SetVolume(HalfRipples(), 0.5);
  scene.SetOpacity({ { 900.0, 0.0 }, { 1400.0, 0.4 } });
  scene.SetColor(
    { { 800.0, 0.1, 0.2, 0.8 }, { 1200.0, 0.9, 0.9, 0.2 }, { 1600.0, 0.9, 0.1, 0.1 } });
  scene.Property->SetScalarOpacityUnitDistance(5.0);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetMaxMemoryInBytes(limit);
  scene.LookFrom(-60.0, 30.0, 1.2);
}

void EditAtRandom(Scene& scene, std::mt19937& random)
{
  const auto uniform = [&random](double from, double to)
  { return std::uniform_real_distribution<double>(from, to)(random); };
  switch (random() % 4)
  {
  case 0:
    scene.SetOpacity({ { uniform(700.0, 1000.0), 0.0 }, { uniform(1100.0, 1700.0), 0.4 } });
    break;
  case 1:
    scene.Property->GetScalarOpacity()->AddPoint(uniform(800.0, 1800.0), uniform(0.0, 0.6));
    break;
  case 2:
    scene.Property->GetRGBTransferFunction()->AddRGBPoint(
      uniform(800.0, 1800.0), uniform(0.0, 1.0), uniform(0.0, 1.0), uniform(0.0, 1.0));
    break;
  default: // a step
    const double at = uniform(900.0, 1500.0);
    scene.Property->GetScalarOpacity()->AddPoint(at, 0.1, 0.5, 1.0);
    scene.Property->GetScalarOpacity()->AddPoint(at + 1e-3, 0.5);
  }
}

void CopyFunctions(Scene& from, Scene& to)
{
  to.Property->GetScalarOpacity()->DeepCopy(from.Property->GetScalarOpacity());
  to.Property->GetRGBTransferFunction()->DeepCopy(from.Property->GetRGBTransferFunction());
}
} // namespace

TEST(Distortion, FindsWhereDetailIs)
{
  Scene scene;
  ShowHalfRipples(scene, 256 << 20);
  const auto full = scene.Draw();
  EXPECT_EQ(scene.Mapper->GetTotalDistortion(), 0.0); // all blocks are at their finest level
  scene.Mapper->SetMaxMemoryInBytes(288000 + scene.Mapper->GetUsedAtlasBytes() / 4);
  const double byDistance = PSNR(scene.Draw(), full);
  const double totalByDistance = scene.Mapper->GetTotalDistortion();
  const double meanByDistance = scene.Mapper->GetMeanDistortionOfUnrefinedBlocks();
  EXPECT_GT(meanByDistance, 0.0);
  EXPECT_LT(meanByDistance, totalByDistance);
  scene.Mapper->SetSelectionCriterionToDistortion();
  const double byDistortion = PSNR(scene.Draw(), full);
  EXPECT_TRUE(MatchesBaseline(scene.Window, "DistortionHalfRipples"));
  EXPECT_LT(scene.Mapper->GetTotalDistortion(), 0.8 * totalByDistance);
  scene.Mapper->SetSelectionCriterionToDistortionAndDistance();
  const double byBoth = PSNR(scene.Draw(), full);
  std::cout << "by distance " << byDistance << " dB, by distortion " << byDistortion
            << " dB, by both " << byBoth << " dB\n";
  EXPECT_GE(byDistortion, byDistance + 3.0);
  EXPECT_GE(byBoth, byDistance + 3.0);
}

TEST(Distortion, BackendsAgreeToTheLastBit)
{
  Scene scene;
  ShowHalfRipples(scene, 600000);
  scene.Mapper->SetSelectionCriterionToDistortion();
  scene.Mapper->SetDistortionBackendToSerial();
  const auto serial = scene.Draw();
  const double total = scene.Mapper->GetTotalDistortion();
  EXPECT_GT(total, 0.0);
  for (int threads : { 0, 1, 2, 5 })
  {
    Scene other;
    ShowHalfRipples(other, 600000);
    other.Mapper->SetSelectionCriterionToDistortion();
    other.Mapper->SetDistortionBackendToOpenMP();
    other.Mapper->SetNumberOfThreads(threads);
    EXPECT_EQ(LargestDifference(other.Draw(), serial), 0.0) << threads;
    EXPECT_EQ(other.Mapper->GetTotalDistortion(), total) << threads;
  }
}

// One clear warning where there is no device, and what OpenMP finds in any case.
TEST(Distortion, CudaIsReplacedWhereThereIsNone)
{
  Scene scene;
  ShowHalfRipples(scene, 600000);
  scene.Mapper->SetSelectionCriterionToDistortion();
  const auto picture = scene.Draw();
  const double total = scene.Mapper->GetTotalDistortion();
  Scene other;
  ShowHalfRipples(other, 600000);
  other.Mapper->SetSelectionCriterionToDistortion();
  other.Mapper->SetDistortionBackendToCUDA();
  const auto messages = Listen(
    [&]
    {
      other.Draw();
      EXPECT_GE(PSNR(other.Draw(), picture), 60.0);
    });
  EXPECT_LE(messages.Warnings.size(), 1U);
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_NEAR(other.Mapper->GetTotalDistortion(), total, 1e-3 * total);
}

// A thousand edits, with interactive frames that leave some of the work, end where one edit does.
TEST(Distortion, EditsEndLikeAFreshMapper)
{
  std::mt19937 random(31);
  Scene edited;
  ShowHalfRipples(edited, 600000);
  edited.Window->SetSize(40, 40);
  edited.Mapper->SetSelectionCriterionToDistortion();
  edited.Mapper->SetDistortionBlocksPerFrame(20);
  bool wasIncomplete = false;
  for (int edit = 1; edit <= 1000; ++edit)
  {
    EditAtRandom(edited, random);
    if (edit % 3 == 0)
    {
      edited.Window->SetDesiredUpdateRate(15.0);
      edited.Window->Render();
      wasIncomplete = wasIncomplete || !edited.Mapper->GetDistortionComplete();
    }
    if (edit % 100 == 0)
    {
      edited.Window->SetDesiredUpdateRate(0.0001);
      const auto picture = edited.Draw();
      EXPECT_TRUE(edited.Mapper->GetDistortionComplete());
      Scene fresh;
      ShowHalfRipples(fresh, 600000);
      fresh.Window->SetSize(40, 40);
      fresh.LookFrom(-60.0, 30.0, 1.2);
      edited.LookFrom(-60.0, 30.0, 1.2);
      fresh.Mapper->SetSelectionCriterionToDistortion();
      CopyFunctions(edited, fresh);
      EXPECT_EQ(LargestDifference(edited.Draw(), fresh.Draw()), 0.0) << edit;
      EXPECT_EQ(edited.Mapper->GetTotalDistortion(), fresh.Mapper->GetTotalDistortion()) << edit;
      ShowHalfRipples(edited, 600000);
    }
  }
  EXPECT_TRUE(wasIncomplete);
}

namespace
{
// Values grow along x: an interval of values is a layer of blocks, eight by two by two in all.
void ShowLayers(Scene& scene)
{
  scene.SetVolume(
    MakeVolume({ 129, 33, 33 }, VTK_UNSIGNED_CHAR,
      [](int x, int y, int z) { return x + (x * 7 + y * 5 + z * 3) % 4 * (x < 125 ? 1 : 0); }),
    0.5);
  scene.SetColor({ { 0.0, 0.9, 0.2, 0.1 }, { 128.0, 0.1, 0.9, 0.9 } });
  scene.SetOpacity({ { 0.0, 0.1 }, { 128.0, 0.9 } });
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetMaxMemoryInBytes(350000);
  scene.Mapper->SetSelectionCriterionToDistortion();
  scene.LookFrom(20.0, 30.0);
}
} // namespace

// As many blocks as the edit touches, and not one more: it could not be done in one frame.
TEST(Distortion, OnlyWhatAnEditTouchesIsComputedAgain)
{
  Scene scene;
  ShowLayers(scene);
  scene.Draw();
  ASSERT_GT(scene.Mapper->GetNumberOfBricks(1) + scene.Mapper->GetNumberOfBricks(2), 0);
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Property->GetScalarOpacity()->AddPoint(38.0, 0.37);
  scene.Property->GetScalarOpacity()->AddPoint(44.0, 0.41);
  scene.Mapper->SetDistortionBlocksPerFrame(32);
  scene.Window->Render();
  EXPECT_TRUE(scene.Mapper->GetDistortionComplete()); // 128 at first, at both sides of the nodes
  scene.Mapper->SetDistortionBlocksPerFrame(4);
  scene.Property->GetScalarOpacity()->AddPoint(40.0, 0.9); // between the two, in one layer
  scene.Window->Render();
  EXPECT_TRUE(scene.Mapper->GetDistortionComplete());
  scene.Property->GetScalarOpacity()->AddPoint(48.0, 0.9); // where two layers meet
  scene.Window->Render();
  EXPECT_FALSE(scene.Mapper->GetDistortionComplete());
}

// The same range and functions, but another type: another table.
TEST(Distortion, AnotherTypeOfTheSameRangeIsComputedAnew)
{
  const auto make = [](int type)
  {
    return MakeVolume({ 65, 49, 49 }, type,
      [](int x, int y, int z)
      { return x + y + z == 0 ? 0 : (x == 64 ? 255 : (x * 31 + y * 17 + z * 7) % 256); });
  };
  const auto prepare = [&](Scene& scene, int type)
  {
    scene.SetVolume(make(type), 0.5);
    scene.Mapper->SetBlockSize(17);
    scene.Mapper->SetMaxMemoryInBytes(500000);
    scene.Mapper->SetSelectionCriterionToDistortion();
    scene.LookFrom(20.0, 30.0);
  };
  Scene walked;
  walked.SetRamp(0.0, 255.0, 0.3);
  prepare(walked, VTK_FLOAT);
  walked.Draw();
  prepare(walked, VTK_UNSIGNED_CHAR);
  Scene fresh;
  fresh.SetRamp(0.0, 255.0, 0.3);
  prepare(fresh, VTK_UNSIGNED_CHAR);
  walked.Mapper->SetMaxMemoryInBytes(400000);
  fresh.Mapper->SetMaxMemoryInBytes(400000);
  EXPECT_EQ(LargestDifference(walked.Draw(), fresh.Draw()), 0.0);
  EXPECT_GT(fresh.Mapper->GetTotalDistortion(), 0.0);
  EXPECT_EQ(walked.Mapper->GetTotalDistortion(), fresh.Mapper->GetTotalDistortion());
}

TEST(Distortion, BlocksOfOneColorAreNotVisited)
{
  Scene scene;
  ShowLayers(scene);
  scene.SetColor({ { 0.0, 0.9, 0.2, 0.1 } });
  scene.SetOpacity({ { 0.0, 0.5 }, { 128.0, 0.5 } });
  scene.Mapper->SetDistortionBlocksPerFrame(1);
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Window->Render();
  EXPECT_TRUE(scene.Mapper->GetDistortionComplete());
  EXPECT_EQ(scene.Mapper->GetTotalDistortion(), 0.0);
}

// Nodes at the same value, and far beyond the data.
TEST(Distortion, OddFunctionsAreTaken)
{
  Scene scene;
  ShowLayers(scene);
  scene.Mapper->SetMaxMemoryInBytes(850000); // nodes this close have a table of 512 KiB
  scene.Property->GetScalarOpacity()->AllowDuplicateScalarsOn();
  for (const double opacity : { 0.1, 0.8, 0.3 })
  {
    scene.Property->GetScalarOpacity()->AddPoint(64.0, opacity);
  }
  scene.Draw();
  const double total = scene.Mapper->GetTotalDistortion();
  EXPECT_TRUE(std::isfinite(total));
  EXPECT_GT(total, 0.0);
  scene.SetOpacity({ { -1e9, 0.0 }, { 1e9, 1.0 } });
  scene.SetColor({ { -1e30, 0.0, 0.0, 0.0 }, { 1e30, 1.0, 1.0, 1.0 } });
  EXPECT_TRUE(ShowsSomething(scene.Draw()));
  EXPECT_LT(scene.Mapper->GetTotalDistortion(), 1e-3);
}

TEST(Distortion, InteractiveFramesFinishInTheEnd)
{
  Scene scene;
  ShowHalfRipples(scene, 600000);
  scene.Mapper->SetSelectionCriterionToDistortion();
  scene.Mapper->SetDistortionBlocksPerFrame(30);
  scene.Window->SetDesiredUpdateRate(15.0);
  EXPECT_TRUE(ShowsSomething(scene.Draw()));
  EXPECT_FALSE(scene.Mapper->GetDistortionComplete());
  EXPECT_FALSE(scene.Mapper->GetConverged());
  EXPECT_GT(scene.Mapper->RenderUntilConverged(scene.Window), 3);
  EXPECT_TRUE(scene.Mapper->GetDistortionComplete());
  Scene still;
  ShowHalfRipples(still, 600000);
  still.Mapper->SetSelectionCriterionToDistortion();
  const auto picture = still.Draw();
  scene.Window->SetDesiredUpdateRate(0.0001);
  EXPECT_EQ(LargestDifference(scene.Draw(), picture), 0.0);
}

TEST(Distortion, NothingVisibleIsNothingWrong)
{
  Scene scene;
  ShowHalfRipples(scene, 600000);
  scene.Mapper->SetSelectionCriterionToDistortion();
  EXPECT_EQ(scene.Mapper->GetTotalDistortion(), 0.0);
  scene.SetOpacity({ { 0.0, 0.0 }, { 5000.0, 0.0 } });
  EXPECT_FALSE(ShowsSomething(scene.Draw()));
  EXPECT_EQ(scene.Mapper->GetTotalDistortion(), 0.0);
  EXPECT_EQ(scene.Mapper->GetMeanDistortionOfUnrefinedBlocks(), 0.0);
}

TEST(Distortion, SamplesThatAreNotFiniteAreCountedOnce)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 49, 49, 49 }, VTK_FLOAT,
                    [](int x, int y, int z)
                    {
                      return x == 20 && y < 3 && z == 30 ? std::numeric_limits<double>::quiet_NaN()
                                                         : x + 10.0 * std::sin(y) + z;
                    }),
    0.5);
  scene.SetRamp(0.0, 100.0, 0.1);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetMaxMemoryInBytes(400000);
  scene.Mapper->SetSelectionCriterionToDistortion();
  scene.LookFrom(30.0, 30.0);
  const auto messages = Listen(
    [&]
    {
      scene.Draw();
      scene.SetRamp(0.0, 90.0, 0.2);
      scene.Draw();
    });
  ASSERT_EQ(messages.Warnings.size(), 1U);
  EXPECT_NE(messages.Warnings[0].find("3 samples are not finite"), std::string::npos);
  EXPECT_TRUE(std::isfinite(scene.Mapper->GetTotalDistortion()));
}

TEST(Distortion, NodesThatAreNotNumbersAreRefused)
{
  Scene scene;
  ShowHalfRipples(scene, 600000);
  const auto good = scene.Draw();
  vtkPiecewiseFunction* opacity = scene.Property->GetScalarOpacity();
  double node[4] = { 1400.0, std::numeric_limits<double>::quiet_NaN(), 0.5, 0.0 };
  opacity->SetNodeValue(1, node);
  const auto messages = Listen(
    [&]
    {
      scene.Draw();
      scene.Draw();
    });
  ASSERT_EQ(messages.Errors.size(), 1U);
  EXPECT_NE(messages.Errors[0].find("Node 1 of the opacity function"), std::string::npos);
  node[1] = 0.4;
  opacity->SetNodeValue(1, node);
  EXPECT_EQ(LargestDifference(scene.Draw(), good), 0.0);
}

// Summaries choose nearly as well, follow edits at once, and forget their history too.
TEST(Distortion, SummariesFollowEdits)
{
  Scene scene;
  ShowHalfRipples(scene, 256 << 20);
  const auto full = scene.Draw();
  scene.Mapper->SetMaxMemoryInBytes(288000 + scene.Mapper->GetUsedAtlasBytes() / 4);
  scene.Mapper->SetSelectionCriterionToDistortion();
  const double exact = PSNR(scene.Draw(), full);
  scene.Mapper->SetDistortionEstimateToSummary();
  const double estimated = PSNR(scene.Draw(), full);
  std::cout << "exact " << exact << " dB, summaries " << estimated << " dB, "
            << scene.Mapper->GetDistortionSummaryBytes() << " bytes\n";
  EXPECT_GE(estimated, exact - 1.0);
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Mapper->SetDistortionBlocksPerFrame(1);
  std::mt19937 random(3);
  for (int edit = 0; edit < 30; ++edit)
  {
    EditAtRandom(scene, random);
    scene.Window->Render();
    EXPECT_TRUE(scene.Mapper->GetDistortionComplete());
  }
  scene.Window->SetDesiredUpdateRate(0.0001);
  Scene fresh;
  ShowHalfRipples(fresh, scene.Mapper->GetMaxMemoryInBytes());
  fresh.Mapper->SetSelectionCriterionToDistortion();
  fresh.Mapper->SetDistortionEstimateToSummary();
  CopyFunctions(scene, fresh);
  EXPECT_EQ(LargestDifference(scene.Draw(), fresh.Draw()), 0.0);
}

// An opaque body whose inside is full of detail that nobody sees.
TEST(Distortion, WhatIsHiddenLeavesTheMemoryToWhatIsSeen)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 129, 129, 129 }, VTK_UNSIGNED_SHORT,
                    [](int x, int y, int z)
                    {
                      const auto fromSide = [](int i) { return std::min(i, 128 - i); };
                      const bool isSkin = std::min({ fromSide(x), fromSide(y), fromSide(z) }) < 40;
                      const double ripple = std::sin(1.1 * x) * std::sin(1.3 * y + 0.9 * z);
                      return isSkin ? 1000.0 + 60.0 * ripple : 3000.0 + 900.0 * ripple;
                    }),
    0.5);
  scene.SetOpacity({ { 0.0, 0.5 }, { 4000.0, 0.5 } });
  scene.SetColor({ { 900.0, 0.9, 0.5, 0.3 }, { 1100.0, 0.3, 0.6, 0.9 }, { 2000.0, 1.0, 1.0, 1.0 },
    { 3900.0, 0.9, 0.0, 0.0 } });
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetSelectionCriterionToDistortion();
  scene.LookFrom(30.0, 30.0);
  const auto full = scene.Draw();
  scene.Mapper->SetMaxMemoryInBytes(
    scene.Mapper->GetMemoryInBytes() - scene.Mapper->GetAtlasBytes() + 2400000);
  const double without = PSNR(scene.Draw(), full);
  scene.Mapper->VisibilityWeightingOn();
  const double with = PSNR(scene.Draw(), full);
  std::cout << "without " << without << " dB, with visibility " << with << " dB\n";
  EXPECT_GE(with, without + 3.0);
}
