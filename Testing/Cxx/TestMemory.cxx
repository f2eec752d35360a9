// What is on the graphics card, and the limit of it.
#include "vtk_glew.h"

#include "Rendering.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

using namespace flatblock::testing;

TEST(Memory, LimitHoldsUnderRandomChanges)
{
  std::mt19937 random(5);
  const auto uniform = [&random](double from, double to)
  { return std::uniform_real_distribution<double>(from, to)(random); };
  Scene scene;
  ShowShell(scene, 256 << 20);
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

TEST(Memory, TooLittleMemoryIsSaid)
{
  Scene scene;
  ShowShell(scene, 1000);
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

TEST(Memory, VolumesLongerThanTheLargestTexture)
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

TEST(Memory, TwoVolumesInOneWindowKeepTheirLimits)
{
  Scene alone;
  ShowShell(alone, 700000);
  const auto picture = alone.Draw();
  Scene both;
  ShowShell(both, 700000);
  vtkNew<vtkFlatBlockVolumeMapper> mapper;
  mapper->SetInputDataObject(both.Mapper->GetInputDataObject(0, 0));
  mapper->SetSampleDistance(both.Mapper->GetSampleDistance());
  mapper->SetBlockSize(33);
  mapper->SetMaxMemoryInBytes(900000);
  vtkNew<vtkVolume> other;
  other->SetMapper(mapper);
  other->SetProperty(both.Property);
  other->SetPosition(0.0, 2.2, 0.0);
  both.Renderer->AddVolume(other);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> angle(0.0, 360.0);
  for (int step = 0; step < 10; ++step)
  {
    both.LookFrom(angle(random), 20.0);
    both.Draw();
    EXPECT_LE(both.Mapper->GetPeakMemoryInBytes(), 700000);
    EXPECT_LE(mapper->GetPeakMemoryInBytes(), 900000);
    EXPECT_TRUE(both.Mapper->GetConverged() && mapper->GetConverged());
  }
  other->VisibilityOff();
  both.LookFrom(30.0, 40.0, 1.3);
  EXPECT_EQ(LargestDifference(both.Draw(), picture), 0.0);
}

TEST(Memory, ReleaseAmidRefinementStartsAnew)
{
  Scene still;
  ShowShell(still, 800000);
  const auto converged = still.Draw();
  Scene scene;
  ShowShell(scene, 800000);
  scene.Mapper->SetRefinementFraction(0.02);
  scene.Window->SetDesiredUpdateRate(15.0);
  for (int frame = 0; frame < 4; ++frame)
  {
    scene.Draw();
  }
  ASSERT_FALSE(scene.Mapper->GetConverged());
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(scene.Mapper->GetMemoryInBytes(), 0);
  EXPECT_TRUE(ShowsSomething(scene.Draw()));
  ASSERT_FALSE(scene.Mapper->GetConverged());
  scene.Mapper->RenderUntilConverged(scene.Window);
  scene.Window->SetDesiredUpdateRate(0.0001);
  EXPECT_EQ(LargestDifference(scene.Draw(), converged), 0.0);
}

namespace
{
// A graphics card that has no memory for 3D textures above a limit: the driver is asked for the
// largest there can be, and says so itself. Some know before they try, others don't. To be made
// once there is a window.
class SmallCard
{
public:
  explicit SmallCard(vtkTypeInt64 mostTexels, bool knowsBefore = true)
  {
    MostTexels = mostTexels;
    KnowsBefore = knowsBefore;
    Driver = __glewTexImage3D;
    __glewTexImage3D = &SmallCard::TexImage3D;
  }
  ~SmallCard() { __glewTexImage3D = Driver; }

private:
  static void GLAPIENTRY TexImage3D(GLenum target, GLint level, GLint internalFormat, GLsizei width,
    GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels)
  {
    const bool isAsked = target == GL_PROXY_TEXTURE_3D && !KnowsBefore;
    if (vtkTypeInt64(width) * height * depth > MostTexels && !isAsked)
    {
      GLint most = 0;
      glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most);
      Driver(target, level, GL_RGBA32F, most, most, most, border, GL_RGBA, GL_FLOAT, nullptr);
      return;
    }
    Driver(target, level, internalFormat, width, height, depth, border, format, type, pixels);
  }

  inline static vtkTypeInt64 MostTexels = 0;
  inline static bool KnowsBefore = true;
  inline static PFNGLTEXIMAGE3DPROC Driver = nullptr;
};
} // namespace

TEST(Memory, CardsWithTooLittleShowTheLastGoodState)
{
  for (const bool knowsBefore : { true, false })
  {
    Scene scene;
    ShowShell(scene, 700000);
    const auto good = scene.Draw();
    const vtkTypeInt64 atlas = scene.Mapper->GetAtlasBytes();
    const SmallCard card(atlas, knowsBefore);
    scene.Mapper->SetMaxMemoryInBytes(3000000);
    const auto messages = Listen(
      [&]
      {
        EXPECT_GE(PSNR(scene.Draw(), good), 60.0);
        EXPECT_EQ(scene.Mapper->GetUploadedBytes() > 0, true);
        scene.Draw();
        EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);
        scene.LookFrom(100.0, 20.0);
        EXPECT_TRUE(ShowsSomething(scene.Draw()));
      });
    const auto isOurs = [](const std::string& error)
    { return error.find("no memory for an atlas") != std::string::npos; };
    EXPECT_EQ(std::count_if(messages.Errors.begin(), messages.Errors.end(), isOurs), 1);
    // Where the driver fails VTK may add its own.
    EXPECT_LE(messages.Errors.size(), knowsBefore ? 1U : 2U);
    EXPECT_LE(scene.Mapper->GetAtlasBytes(), atlas);
    EXPECT_GE(scene.Mapper->GetAtlasBytes(), atlas * 8 / 10);
    EXPECT_TRUE(scene.Mapper->GetConverged());
  }
}

TEST(Memory, CardsWithTooLittleFromTheStartShowWhatTheyCan)
{
  Scene scene;
  scene.Volume->VisibilityOff();
  scene.Draw();
  scene.Volume->VisibilityOn();
  const SmallCard card(300000);
  ShowShell(scene, 256 << 20);
  const auto messages = Listen([&] { EXPECT_TRUE(ShowsSomething(scene.Draw())); });
  EXPECT_EQ(messages.Errors.size(), 1U);
  EXPECT_LE(scene.Mapper->GetAtlasBytes(), 300000);
  EXPECT_GE(scene.Mapper->GetAtlasBytes(), 150000);
  scene.Mapper->SetMaxMemoryInBytes(500000);
  EXPECT_TRUE(Listen([&] { scene.Draw(); }).Errors.empty());
}

TEST(Memory, CardsWithNoneSaySo)
{
  Scene scene;
  scene.Volume->VisibilityOff();
  scene.Draw();
  scene.Volume->VisibilityOn();
  {
    const SmallCard card(10);
    ShowShell(scene, 256 << 20);
    const auto messages = Listen([&] { EXPECT_FALSE(ShowsSomething(scene.Draw())); });
    EXPECT_EQ(messages.Errors.size(), 2U); // that it tries with less, and that it can't
  }
  scene.Mapper->SetMaxMemoryInBytes(600000);
  EXPECT_TRUE(ShowsSomething(scene.Draw()));
}
