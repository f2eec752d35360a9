// The three classifications: what they are for, and how far they are from the reference.
#include "FloatPicture.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace flatblock::testing;

namespace
{
// A shell of a few of 255 values, in the signal of Marschner and Lobb as floats.
void ShowThinShell(Scene& scene, double voxelsAStep)
{
  constexpr int Samples = 64;
  const auto bytes = MarschnerLobb(Samples);
  const auto floats = MakeVolume({ Samples, Samples, Samples }, VTK_FLOAT,
    [&bytes](int x, int y, int z) { return bytes->GetScalarComponentAsDouble(x, y, z, 0); });
  floats->SetSpacing(bytes->GetSpacing());
  floats->SetOrigin(bytes->GetOrigin());
  const double voxel = bytes->GetSpacing()[0];
  scene.SetVolume(floats, voxelsAStep * voxel);
  scene.SetOpacity({ { 117.0, 0.0 }, { 121.0, 0.9 }, { 125.0, 0.0 } });
  scene.SetColor({ { 117.0, 0.9, 0.3, 0.1 }, { 121.0, 0.9, 0.9, 0.7 }, { 125.0, 0.2, 0.4, 0.9 } });
  scene.Property->SetScalarOpacityUnitDistance(0.3 * voxel);
  scene.LookFrom(30.0, 40.0, 1.3);
}

double ErrorOf(Scene& scene, int classification)
{
  scene.Mapper->SetClassification(classification);
  constexpr int Stride = 12;
  const Picture drawn = TakeEvery(DrawFloats(scene), scene.Window->GetSize()[0], Stride);
  EXPECT_TRUE(IsSound(drawn));
  return RootMeanSquare(drawn, DrawReference(scene, Stride));
}
} // namespace

TEST(Classification, PreIntegrated)
{
  Scene scene;
  ShowThinShell(scene, 1.0);
  scene.Draw();
  EXPECT_TRUE(MatchesBaseline(scene.Window, "ClassificationPreIntegrated"));
}

TEST(Classification, PostInterpolation)
{
  Scene scene;
  ShowThinShell(scene, 1.0);
  scene.Mapper->SetClassificationToPostInterpolation();
  scene.Draw();
  EXPECT_TRUE(MatchesBaseline(scene.Window, "ClassificationPostInterpolation"));
}

TEST(Classification, PreInterpolation)
{
  Scene scene;
  ShowThinShell(scene, 1.0);
  scene.Mapper->SetClassificationToPreInterpolation();
  scene.Draw();
  EXPECT_TRUE(MatchesBaseline(scene.Window, "ClassificationPreInterpolation"));
}

// A thin shell needs few samples where it is integrated, and many where it has to be hit.
TEST(Classification, PreIntegrationNeedsFewerSamples)
{
  Scene scene;
  ShowThinShell(scene, 1.0);
  const double integrated = ErrorOf(scene, vtkFlatBlockVolumeMapper::PRE_INTEGRATED);
  const double post = ErrorOf(scene, vtkFlatBlockVolumeMapper::POST_INTERPOLATION);
  const double pre = ErrorOf(scene, vtkFlatBlockVolumeMapper::PRE_INTERPOLATION);
  std::cout << "one voxel a step: " << integrated << ", " << post << ", " << pre << "\n";
  EXPECT_LT(2.5 * integrated, post);
  EXPECT_LT(2.5 * integrated, pre);
  ShowThinShell(scene, 0.5);
  const double halfPost = ErrorOf(scene, vtkFlatBlockVolumeMapper::POST_INTERPOLATION);
  std::cout << "half a voxel, post-interpolation: " << halfPost << "\n";
  EXPECT_LT(1.5 * integrated, halfPost);
}

// Pre-integration and post-interpolation converge to the reference, second order in the step; what
// is classified before it is interpolated does not.
TEST(Classification, ErrorsFallWithTheStep)
{
  Scene scene;
  for (int classification :
    { vtkFlatBlockVolumeMapper::PRE_INTEGRATED, vtkFlatBlockVolumeMapper::POST_INTERPOLATION })
  {
    ShowThinShell(scene, 0.5);
    const double coarse = ErrorOf(scene, classification);
    ShowThinShell(scene, 1.0 / 16.0);
    const double fine = ErrorOf(scene, classification);
    std::cout << "half a voxel: " << coarse << ", a sixteenth: " << fine << "\n";
    EXPECT_LE(fine, 0.25 * coarse);
  }
}

// Between nearest samples there is nothing to integrate: both draw the same.
TEST(Classification, NearestSamplesAreClassifiedAsTheyAre)
{
  Scene scene;
  ShowThinShell(scene, 0.5);
  scene.Property->SetInterpolationTypeToNearest();
  const Picture integrated = DrawFloats(scene);
  scene.Mapper->SetClassificationToPostInterpolation();
  EXPECT_EQ(LargestDifference(DrawFloats(scene), integrated), 0.0);
}

// From the property's functions to the graphics card.
TEST(Classification, TablesAreRebuiltQuickly)
{
  Scene scene;
  ShowThinShell(scene, 1.0);
  std::vector<double> milliseconds;
  for (int edit = 0; edit < 9; ++edit)
  {
    scene.SetOpacity({ { 117.0, 0.0 }, { 121.0, 0.1 * edit }, { 125.0, 0.0 } });
    scene.Draw();
    milliseconds.push_back(
      scene.Mapper->GetRangeMilliseconds() + scene.Mapper->GetUploadMilliseconds());
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::cout << "an edit of the transfer function: " << milliseconds[4] << " ms\n";
  EXPECT_LE(milliseconds[4], 5.0);
}

// The table is in place for any step: nothing is built or sent when it changes.
TEST(Classification, StepsChangeWithoutANewTable)
{
  Scene scene;
  ShowThinShell(scene, 1.0);
  scene.Draw();
  const vtkTypeInt64 bytes = scene.Mapper->GetMemoryInBytes();
  for (double step : { 0.01, 0.02, 0.05, 0.1 })
  {
    scene.Mapper->SetSampleDistance(step);
    scene.Draw();
    EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);
    EXPECT_EQ(scene.Mapper->GetMemoryInBytes(), bytes);
  }
}
