// Bad input: one clear error, no crash, nothing of an older picture; and all is well again once it
// is set right.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

using namespace flatblock::testing;

namespace
{
vtkSmartPointer<vtkImageData> Good()
{
  return MakeVolume({ 20, 20, 20 }, VTK_UNSIGNED_CHAR,
    [](int x, int y, int z) { return 3.0 * x + 4.0 * y + 5.0 * z; });
}

// Draws a good frame first, then breaks something, then mends it.
void ExpectOneError(const std::string& words, const std::function<void(Scene&)>& breakIt,
  const std::function<void(Scene&)>& mend)
{
  Scene scene;
  scene.SetVolume(Good(), 0.5);
  scene.SetRamp(20.0, 240.0, 0.3);
  scene.LookFrom(33.0, 21.0);
  const auto good = scene.Draw();
  ASSERT_TRUE(ShowsSomething(good));

  vtkSmartPointer<vtkImageData> broken;
  const Messages messages = Listen(
    [&]
    {
      breakIt(scene);
      scene.Draw();
      broken = scene.Draw();
    });
  ASSERT_EQ(messages.Errors.size(), 1U)
    << words << ": " << ::testing::PrintToString(messages.Errors);
  EXPECT_NE(messages.Errors[0].find(words), std::string::npos) << messages.Errors[0];
  EXPECT_FALSE(ShowsSomething(broken)) << words;

  const Messages after = Listen([&] { mend(scene); });
  EXPECT_TRUE(after.Errors.empty()) << ::testing::PrintToString(after.Errors);
  EXPECT_EQ(LargestDifference(good, scene.Draw()), 0.0) << words;
}

void SetInput(Scene& scene, vtkImageData* image)
{
  scene.Mapper->SetInputData(image);
}

void SetGood(Scene& scene)
{
  SetInput(scene, Good());
}

class VolumeWithoutProperty : public vtkVolume
{
public:
  static VolumeWithoutProperty* New();
  vtkTypeMacro(VolumeWithoutProperty, vtkVolume);
  vtkVolumeProperty* GetProperty() override { return nullptr; }
};
vtkStandardNewMacro(VolumeWithoutProperty);
} // namespace

TEST(BadInput, NoInput)
{
  Scene scene;
  scene.SetRamp(20.0, 240.0, 0.3);
  vtkSmartPointer<vtkImageData> picture;
  // vtkVolume asks the pipeline first, which speaks once a frame.
  const Messages pipeline = Listen([&] { picture = scene.Draw(); });
  ASSERT_LE(pipeline.Errors.size(), 1U) << ::testing::PrintToString(pipeline.Errors);
  EXPECT_FALSE(ShowsSomething(picture));
  const Messages direct = Listen([&] { scene.Mapper->Render(scene.Renderer, scene.Volume); });
  ASSERT_EQ(direct.Errors.size(), 1U);
  EXPECT_NE(direct.Errors[0].find("no input"), std::string::npos);
}

TEST(BadInput, InputTakenAway)
{
  Scene scene;
  scene.SetVolume(Good(), 0.5);
  scene.SetRamp(20.0, 240.0, 0.3);
  scene.LookFrom(33.0, 21.0);
  ASSERT_TRUE(ShowsSomething(scene.Draw()));
  scene.Mapper->SetInputConnection(nullptr);
  Listen([&] { EXPECT_FALSE(ShowsSomething(scene.Draw())); });
}

TEST(BadInput, EmptyExtent)
{
  ExpectOneError(
    "extent is empty", [](Scene& scene) { SetInput(scene, vtkNew<vtkImageData>()); }, SetGood);
}

TEST(BadInput, OneSampleThick)
{
  ExpectOneError(
    "20 x 20 x 1",
    [](Scene& scene)
    {
      SetInput(
        scene, MakeVolume({ 20, 20, 1 }, VTK_UNSIGNED_CHAR, [](int, int, int) { return 100.0; }));
    },
    SetGood);
}

TEST(BadInput, NotAnImage)
{
  ExpectOneError(
    "vtkPolyData",
    [](Scene& scene)
    {
      vtkNew<vtkSphereSource> sphere;
      scene.Mapper->SetInputConnection(sphere->GetOutputPort());
    },
    SetGood);
}

TEST(BadInput, SpacingThatSpansNoVolume)
{
  for (double bad :
    { 0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    ExpectOneError(
      "span no volume",
      [bad](Scene& scene)
      {
        const auto image = Good();
        image->SetSpacing(1.0, bad, 1.0);
        SetInput(scene, image);
      },
      SetGood);
  }
}

TEST(BadInput, UnknownBlockSize)
{
  for (int size : { 0, -33, 16, 32, 34, 129, VTK_INT_MAX })
  {
    vtkNew<vtkFlatBlockVolumeMapper> mapper;
    mapper->SetBlockSize(65);
    const Messages messages = Listen([&] { mapper->SetBlockSize(size); });
    ASSERT_EQ(messages.Errors.size(), 1U);
    EXPECT_NE(messages.Errors[0].find("17, 33 or 65"), std::string::npos);
    EXPECT_EQ(mapper->GetBlockSize(), 65);
  }
}

TEST(BadInput, NullProperty)
{
  Scene scene;
  scene.SetVolume(Good(), 0.5);
  scene.LookFrom(33.0, 21.0);
  vtkNew<VolumeWithoutProperty> bare;
  scene.Window->Render();
  const Messages messages = Listen(
    [&]
    {
      scene.Mapper->Render(scene.Renderer, bare);
      scene.Mapper->Render(scene.Renderer, bare);
    });
  ASSERT_EQ(messages.Errors.size(), 1U);
  EXPECT_NE(messages.Errors[0].find("no vtkVolumeProperty"), std::string::npos);

  // vtkVolume itself makes a default property where it was set to null.
  scene.Volume->SetProperty(nullptr);
  const Messages byVolume = Listen([&] { scene.Draw(); });
  EXPECT_TRUE(byVolume.Errors.empty());
}

TEST(BadInput, ArrayThatDoesNotExist)
{
  ExpectOneError(
    "'nowhere'",
    [](Scene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectScalarArray("nowhere");
    },
    [](Scene& scene) { scene.Mapper->SelectScalarArray("values"); });
  ExpectOneError(
    "no scalars",
    [](Scene& scene)
    {
      const auto image = Good();
      image->GetPointData()->Initialize();
      SetInput(scene, image);
    },
    SetGood);
}

TEST(BadInput, CellDataAndManyComponentsAndWrongLength)
{
  ExpectOneError(
    "19 values",
    [](Scene& scene)
    {
      const auto image = Good();
      vtkNew<vtkIntArray> cells;
      cells->SetName("cells");
      cells->SetNumberOfTuples(19);
      image->GetCellData()->SetScalars(cells);
      SetInput(scene, image);
      scene.Mapper->SetScalarModeToUseCellData();
    },
    [](Scene& scene) { scene.Mapper->SetScalarModeToDefault(); });
  ExpectOneError(
    "5 components",
    [](Scene& scene)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(20, 20, 20);
      image->AllocateScalars(VTK_FLOAT, 5);
      SetInput(scene, image);
    },
    SetGood);
  ExpectOneError(
    "7 values",
    [](Scene& scene)
    {
      const auto image = Good();
      vtkNew<vtkIntArray> few;
      few->SetName("few");
      few->SetNumberOfTuples(7);
      image->GetPointData()->SetScalars(few);
      SetInput(scene, image);
    },
    SetGood);
}

TEST(BadInput, BlendModeWithoutItsSettings)
{
  ExpectOneError(
    "vtkPlane", [](Scene& scene) { scene.Mapper->SetBlendModeToSlice(); },
    [](Scene& scene) { scene.Mapper->SetBlendModeToComposite(); });
  ExpectOneError(
    "GetIsoSurfaceValues",
    [](Scene& scene)
    {
      scene.Mapper->SetBlendModeToIsoSurface();
      scene.Property->GetIsoSurfaceValues()->SetNumberOfContours(0);
    },
    [](Scene& scene) { scene.Mapper->SetBlendModeToComposite(); });
}

TEST(BadInput, IgnoredSettingsAreNamedOnce)
{
  Scene scene;
  scene.SetVolume(Good(), 0.5);
  scene.SetRamp(20.0, 240.0, 0.3);
  scene.LookFrom(33.0, 21.0);
  const auto before = scene.Draw();
  const auto image = Good();
  image->AllocateCellGhostArray()->Fill(vtkDataSetAttributes::HIDDENCELL);
  scene.Mapper->SetInputData(image);
  const Messages messages = Listen(
    [&]
    {
      scene.Draw();
      EXPECT_EQ(LargestDifference(before, scene.Draw()), 0.0);
    });
  ASSERT_EQ(messages.Warnings.size(), 1U);
  EXPECT_NE(messages.Warnings[0].find("blanked cells of point data"), std::string::npos);
}

TEST(BadInput, StepTooSmallIsLengthened)
{
  Scene scene;
  scene.SetVolume(Good(), 1e-12);
  scene.SetRamp(20.0, 240.0, 0.3);
  scene.Window->SetSize(16, 16);
  scene.LookFrom(33.0, 21.0);
  const Messages messages = Listen([&] { EXPECT_TRUE(ShowsSomething(scene.Draw())); });
  EXPECT_EQ(messages.Warnings.size(), 1U);
}

TEST(BadInput, PropertiesClampAndPrint)
{
  vtkNew<vtkFlatBlockVolumeMapper> mapper;
  const vtkMTimeType before = mapper->GetMTime();
  mapper->SetSampleDistance(-5.0);
  EXPECT_EQ(mapper->GetSampleDistance(), 0.0);
  EXPECT_EQ(mapper->GetMTime(), before);
  mapper->SetSampleDistance(2.0);
  EXPECT_GT(mapper->GetMTime(), before);
  std::ostringstream printed;
  mapper->Print(printed);
  for (const char* name : { "BlockSize: 33", "SampleDistance: 2", "NumberOfBlocks: 0" })
  {
    EXPECT_NE(printed.str().find(name), std::string::npos) << name;
  }
}
