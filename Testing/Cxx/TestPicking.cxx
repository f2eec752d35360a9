// What is under the mouse: hardware selection and vtkVolumePicker.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"
#include "vtkVolumePicker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace flatblock::testing;

namespace
{
constexpr std::array<int, 3> Samples = { 60, 50, 70 };
constexpr std::array<double, 3> Center = { 30.0, 24.0, 36.0 };
constexpr double Radius = 20.0;

// A ball: values fall from its middle, and are 100 at its surface.
vtkSmartPointer<vtkImageData> MakeBall()
{
  return MakeVolume(Samples, VTK_FLOAT,
    [](int x, int y, int z)
    { return 100.0 + Radius - std::hypot(x - Center[0], y - Center[1], z - Center[2]); });
}

void ShowBall(Scene& scene, vtkImageData* image)
{
  scene.SetVolume(image, 0.2);
  scene.SetOpacity({ { 100.0, 0.0 }, { 100.01, 1.0 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 }, { 200.0, 1.0, 1.0, 1.0 } });
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 20.0);
}

vtkSmartPointer<vtkSelection> Select(
  Scene& scene, int association, const std::array<unsigned int, 4>& area = { 0, 0, 255, 255 })
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(area[0], area[1], area[2], area[3]);
  selector->SetFieldAssociation(association);
  return vtkSmartPointer<vtkSelection>::Take(selector->Select());
}

vtkProp* PropOf(vtkSelectionNode* node)
{
  return vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
}

vtkSelectionNode* FindNode(vtkSelection* selection, vtkProp* prop)
{
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    if (PropOf(selection->GetNode(i)) == prop)
    {
      return selection->GetNode(i);
    }
  }
  return nullptr;
}

std::array<double, 3> PlaceOf(vtkIdType id, int nx, int ny)
{
  return { static_cast<double>(id % nx), static_cast<double>(id / nx % ny),
    static_cast<double>(id / nx / ny) };
}

void ExpectOnTheNearSide(Scene& scene, const std::array<double, 3>& place)
{
  const std::array<double, 3> outward = { place[0] - Center[0], place[1] - Center[1],
    place[2] - Center[2] };
  EXPECT_NEAR(std::hypot(outward[0], outward[1], outward[2]), Radius, 1.0);
  double* sight = scene.Renderer->GetActiveCamera()->GetDirectionOfProjection();
  EXPECT_LT(outward[0] * sight[0] + outward[1] * sight[1] + outward[2] * sight[2], 2.0);
}

// Ids of a selection of cells or points; `shift` is that of an id's middle.
void ExpectIdsOnTheBall(Scene& scene, int association, int nx, int ny, double shift)
{
  const auto selection = Select(scene, association);
  ASSERT_EQ(selection->GetNumberOfNodes(), 1U);
  vtkSelectionNode* node = selection->GetNode(0);
  EXPECT_EQ(PropOf(node), scene.Volume);
  auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
  ASSERT_GT(ids->GetNumberOfTuples(), 500);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    std::array<double, 3> place = PlaceOf(ids->GetValue(i), nx, ny);
    for (double& axis : place)
    {
      axis += shift;
    }
    ExpectOnTheNearSide(scene, place);
  }
}
} // namespace

TEST(Selection, FindsTheCellsThatAreSeen)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  const auto before = scene.Draw();
  ExpectIdsOnTheBall(
    scene, vtkDataObject::FIELD_ASSOCIATION_CELLS, Samples[0] - 1, Samples[1] - 1, 0.5);
  EXPECT_EQ(LargestDifference(scene.Draw(), before), 0.0);
}

TEST(Selection, FindsThePointsThatAreSeen)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  ExpectIdsOnTheBall(scene, vtkDataObject::FIELD_ASSOCIATION_POINTS, Samples[0], Samples[1], 0.0);
}

TEST(Selection, FindsTheCellsOfCellData)
{
  Scene scene;
  const auto points = MakeBall();
  vtkNew<vtkImageData> cells;
  cells->SetDimensions(Samples[0] + 1, Samples[1] + 1, Samples[2] + 1);
  cells->SetOrigin(-0.5, -0.5, -0.5);
  cells->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  ShowBall(scene, cells);
  ExpectIdsOnTheBall(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS, Samples[0], Samples[1], 0.0);
}

TEST(Selection, OfCoarseLevelsIsNear)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  scene.Mapper->SetMaxMemoryInBytes(Beside + 400000);
  scene.Draw();
  EXPECT_GT(scene.Mapper->GetNumberOfBricks(1), 0);
  const auto selection = Select(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  ASSERT_EQ(selection->GetNumberOfNodes(), 1U);
  EXPECT_GT(selection->GetNode(0)->GetSelectionList()->GetNumberOfTuples(), 100);
}

TEST(Selection, FindsIsosurfacesAndSlices)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  scene.SetOpacity({ { 0.0, 1.0 }, { 200.0, 1.0 } });
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 100.0);
  scene.Mapper->SetBlendModeToIsoSurface();
  ExpectIdsOnTheBall(
    scene, vtkDataObject::FIELD_ASSOCIATION_CELLS, Samples[0] - 1, Samples[1] - 1, 0.5);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 20.3);
  plane->SetNormal(0.0, 0.0, 1.0);
  scene.Property->SetSliceFunction(plane);
  scene.Mapper->SetBlendModeToSlice();
  const auto selection = Select(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  ASSERT_EQ(selection->GetNumberOfNodes(), 1U);
  auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(PlaceOf(ids->GetValue(i), Samples[0] - 1, Samples[1] - 1)[2], 20.0);
  }
}

// A sum is where it begins, and nowhere where there is nothing to add.
TEST(Selection, FindsSums)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  scene.Mapper->SetBlendModeToAdditive();
  scene.SetOpacity({ { 100.0, 0.0 }, { 100.01, 0.5 } });
  ExpectIdsOnTheBall(
    scene, vtkDataObject::FIELD_ASSOCIATION_CELLS, Samples[0] - 1, Samples[1] - 1, 0.5);
}

// A pick leaves the memory of the frames around it as it is.
TEST(Selection, UploadsNothing)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  scene.Mapper->SetMaxMemoryInBytes(Beside + 1500000);
  scene.Mapper->CountSamplesOn();
  scene.Draw();
  Select(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), 0);
}

// What is in front is found, and what is seen through nothing.
TEST(Selection, TellsPropsApart)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  const auto addSphere = [&scene](double x, double y, double z)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(x, y, z);
    sphere->SetRadius(5.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    scene.Renderer->AddActor(actor);
    return actor;
  };
  const auto hidden = addSphere(Center[0], Center[1], Center[2]);
  const auto beside = addSphere(2.0, 48.0, 68.0);
  const auto selection = Select(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  EXPECT_EQ(selection->GetNumberOfNodes(), 2U);
  EXPECT_TRUE(FindNode(selection, scene.Volume));
  EXPECT_TRUE(FindNode(selection, beside));
  EXPECT_FALSE(FindNode(selection, hidden));
  scene.SetOpacity({ { 0.0, 0.0 }, { 200.0, 0.0 } });
  const auto through = Select(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  EXPECT_FALSE(FindNode(through, scene.Volume));
  EXPECT_TRUE(FindNode(through, hidden));
}

TEST(Picker, FindsTheSurfaceOfTheVolume)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  scene.Draw();
  vtkNew<vtkVolumePicker> picker;
  picker->SetVolumeOpacityIsovalue(0.5);
  ASSERT_TRUE(picker->Pick(128.0, 128.0, 0.0, scene.Renderer));
  EXPECT_EQ(picker->GetVolume(), scene.Volume);
  EXPECT_EQ(picker->GetMapper(), scene.Mapper);
  const double* at = picker->GetPickPosition();
  EXPECT_NEAR(std::hypot(at[0] - Center[0], at[1] - Center[1], at[2] - Center[2]), Radius, 1.0);
  const int* cell = picker->GetCellIJK();
  const auto selection =
    Select(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS, { 128, 128, 128, 128 });
  ASSERT_EQ(selection->GetNumberOfNodes(), 1U);
  auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
  ASSERT_EQ(ids->GetNumberOfTuples(), 1);
  const auto place = PlaceOf(ids->GetValue(0), Samples[0] - 1, Samples[1] - 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(place[axis], cell[axis], 1.0);
  }
  EXPECT_FALSE(picker->Pick(2.0, 2.0, 0.0, scene.Renderer));
}

TEST(Picker, MindsCropping)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.0, 59.0, 0.0, 49.0, 0.0, Center[2]);
  scene.LookFrom(0.0, 0.0);
  scene.Draw();
  vtkNew<vtkVolumePicker> picker;
  picker->SetVolumeOpacityIsovalue(0.5);
  picker->PickCroppingPlanesOn();
  ASSERT_TRUE(picker->Pick(128.0, 128.0, 0.0, scene.Renderer));
  EXPECT_NEAR(picker->GetPickPosition()[2], Center[2], 1e-6);
}

// What is kept is what would be drawn; depths are those of the geometry that a ball would be.
TEST(RenderToImage, KeepsColoursAndDepths)
{
  Scene scene;
  ShowBall(scene, MakeBall());
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  const auto drawn = scene.Draw();
  scene.Mapper->RenderToImageOn();
  EXPECT_FALSE(ShowsSomething(scene.Draw()));
  vtkNew<vtkImageData> color;
  vtkNew<vtkImageData> depth;
  scene.Mapper->GetColorImage(color);
  scene.Mapper->GetDepthImage(depth);
  ASSERT_EQ(color->GetNumberOfPoints(), 256 * 256);
  ASSERT_EQ(depth->GetNumberOfPoints(), 256 * 256);
  scene.Renderer->RemoveVolume(scene.Volume);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(Center.data());
  sphere->SetRadius(Radius);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  scene.Window->Render();
  std::vector<float> expected(256 * 256);
  scene.Window->GetZbufferData(0, 0, 255, 255, expected.data());
  int wrong = 0;
  for (int i = 0; i < 256 * 256; ++i)
  {
    const auto* kept = static_cast<const unsigned char*>(color->GetScalarPointer()) + 4 * i;
    const auto* seen = static_cast<const unsigned char*>(drawn->GetScalarPointer()) + 3 * i;
    ASSERT_NEAR(kept[0], seen[0], 1);
    const float found = static_cast<const float*>(depth->GetScalarPointer())[i];
    wrong += std::abs(found - expected[i]) > 5e-3F ? 1 : 0;
  }
  EXPECT_LE(wrong, 256 * 256 / 100); // at its edge
}
