// Blocks must leave no trace in the picture, and cost nothing where they are transparent.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace flatblock::testing;

namespace
{
constexpr double LeastPSNR = 55.0;

std::vector<vtkSmartPointer<vtkImageData>> DrawWithEachBlockSize(Scene& scene)
{
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (int size : { 17, 33, 65 })
  {
    scene.Mapper->SetBlockSize(size);
    pictures.push_back(scene.Draw());
    EXPECT_TRUE(ShowsSomething(pictures.back()));
  }
  return pictures;
}

void ExpectAlike(const std::vector<vtkSmartPointer<vtkImageData>>& pictures)
{
  for (std::size_t i = 0; i + 1 < pictures.size(); ++i)
  {
    const double psnr = PSNR(pictures[i], pictures.back());
    std::cout << psnr << " dB to blocks of 65\n";
    EXPECT_GE(psnr, LeastPSNR);
  }
}

double Waves(int x, int y, int z)
{
  return 128.0 + 60.0 * std::sin(0.7 * x) * std::cos(0.5 * y) + 60.0 * std::sin(0.9 * z);
}
} // namespace

// 65 samples: 64 blocks of 17, 8 blocks of 33, or one single block of 65.
TEST(Blocks, SeveralBlocksLookLikeASingleOne)
{
  for (int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT })
  {
    Scene scene;
    scene.SetVolume(MakeVolume({ 65, 65, 65 }, type, Waves), 0.4);
    scene.SetRamp(20.0, 240.0, 0.15);
    scene.LookFrom(33.0, 21.0, 1.3);
    const auto pictures = DrawWithEachBlockSize(scene);
    EXPECT_EQ(scene.Mapper->GetNumberOfBlocks(), 1);
    ExpectAlike(pictures);
  }
}

TEST(Blocks, BordersDoNotShowFromInside)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 65, 65, 65 }, VTK_UNSIGNED_CHAR, Waves), 0.4);
  scene.SetRamp(100.0, 240.0, 0.1);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(32.0, 16.0, 16.0); // on borders of blocks of 17 and of 33
  camera->SetFocalPoint(33.0, 50.0, 45.0);
  camera->SetViewAngle(80.0);
  scene.Renderer->ResetCameraClippingRange();
  ExpectAlike(DrawWithEachBlockSize(scene));
}

TEST(Blocks, BordersDoNotShowInTheMRI)
{
  const auto mri = ReadMRI();
  if (!mri)
  {
    GTEST_SKIP() << "mricron-data is not installed";
  }
  Scene scene;
  scene.SetVolume(*mri, 0.25);
  scene.SetOpacity({ { 30.0, 0.0 }, { 130.0, 0.8 } });
  scene.SetColor({ { 30.0, 0.3, 0.1, 0.1 }, { 130.0, 1.0, 1.0, 0.9 } });
  scene.LookFrom(150.0, 35.0, 1.4);
  ExpectAlike(DrawWithEachBlockSize(scene));
}

// Rays along the axes of the grid run within the borders.
TEST(Blocks, BordersDoNotShowAlongAxes)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 65, 65, 65 }, VTK_UNSIGNED_CHAR, Waves), 0.4);
  scene.SetRamp(20.0, 240.0, 0.05);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  for (double azimuth : { 0.0, 90.0, 180.0, 270.0 })
  {
    scene.LookFrom(azimuth, 0.0);
    ExpectAlike(DrawWithEachBlockSize(scene));
  }
}

TEST(Blocks, SizesBeyondMultiplesOfABlock)
{
  for (const std::array<int, 3>& samples :
    { std::array<int, 3>{ 34, 18, 66 }, { 2, 40, 17 }, { 97, 3, 5 } })
  {
    Scene scene;
    scene.SetVolume(MakeVolume(samples, VTK_UNSIGNED_CHAR, Waves), 0.4);
    scene.SetRamp(20.0, 240.0, 0.3);
    scene.LookFrom(33.0, 21.0, 1.3);
    const auto peer = scene.DrawWithPeer();
    for (const auto& picture : DrawWithEachBlockSize(scene))
    {
      EXPECT_GE(PSNR(picture, peer), 40.0) << samples[0];
    }
  }
}

TEST(Blocks, TransparentOnesAreNotUploaded)
{
  // A ball in the first of 4^3 blocks of 17.
  const auto ball = MakeVolume({ 65, 65, 65 }, VTK_UNSIGNED_CHAR,
    [](int x, int y, int z) { return std::hypot(x - 8, y - 8, z - 8) < 6.0 ? 200.0 : 10.0; });
  Scene scene;
  scene.SetVolume(ball, 0.5);
  scene.Mapper->SetBlockSize(17);
  scene.SetOpacity({ { 20.0, 0.0 }, { 200.0, 0.5 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 } });
  scene.LookFrom(20.0, 20.0);
  const auto peer = scene.DrawWithPeer();
  const auto picture = scene.Draw();
  EXPECT_EQ(scene.Mapper->GetNumberOfBlocks(), 64);
  EXPECT_EQ(scene.Mapper->GetNumberOfVisibleBlocks(), 1);
  EXPECT_EQ(scene.Mapper->GetUsedAtlasBytes(), 17 * 17 * 17);
  EXPECT_LE(scene.Mapper->GetAtlasBytes(), 17 * 17 * 36); // with a slab of each coarser level
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 17 * 17 * 17);
  EXPECT_GE(PSNR(picture, peer), 40.0);
}

TEST(Blocks, NothingVisibleLeavesTheBackground)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 40, 40, 40 }, VTK_UNSIGNED_CHAR, Waves), 0.5);
  scene.SetOpacity({ { 0.0, 0.0 }, { 255.0, 0.0 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 } });
  scene.LookFrom(20.0, 20.0);
  const auto messages = Listen([&] { EXPECT_FALSE(ShowsSomething(scene.Draw())); });
  EXPECT_TRUE(messages.Errors.empty());
  EXPECT_EQ(scene.Mapper->GetNumberOfVisibleBlocks(), 0);
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);
}

TEST(Blocks, NothingIsUploadedWhenNothingChanged)
{
  Scene scene;
  const auto volume = MakeVolume({ 65, 65, 65 }, VTK_UNSIGNED_CHAR, Waves);
  scene.SetVolume(volume, 0.5);
  scene.SetRamp(20.0, 240.0, 0.15);
  scene.LookFrom(33.0, 21.0);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 8 * 33 * 33 * 33);

  const auto before = scene.Draw();
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);
  scene.LookFrom(60.0, 10.0);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0) << "the camera moved";
  scene.Mapper->SetSampleDistance(0.7);
  scene.SetRamp(10.0, 250.0, 0.3);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0) << "the same blocks are visible";

  volume->GetPointData()->GetScalars()->SetComponent(0, 0, 3.0);
  volume->Modified();
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 8 * 33 * 33 * 33) << "the samples changed";
}
