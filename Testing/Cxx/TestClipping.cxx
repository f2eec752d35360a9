// What is cut off by clipping planes and cropping regions.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkExtractVOI.h"
#include "vtkPlane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace flatblock::testing;

namespace
{
constexpr int AllRegions = 0x7ffffff;

void Show(Scene& scene, vtkImageData* image)
{
  scene.SetVolume(image, 0.1);
  scene.SetOpacity({ { 550.0, 0.0 }, { 650.0, 0.1 } });
  scene.SetColor({ { 500.0, 0.8, 0.3, 0.2 }, { 700.0, 0.9, 0.9, 0.7 } });
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 40.0, 1.3);
}

// The samples of a box, with the camera as it was for all.
Picture DrawBox(Scene& scene, const std::array<int, 6>& box)
{
  vtkNew<vtkExtractVOI> extract;
  extract->SetInputData(MakeWaves());
  extract->SetVOI(box[0], box[1], box[2], box[3], box[4], box[5]);
  extract->Update();
  scene.Mapper->SetInputData(extract->GetOutput());
  const Picture picture = DrawFloats(scene);
  scene.Mapper->SetInputData(MakeWaves());
  return picture;
}

void Clip(Scene& scene, double x, double y, double z, double nx, double ny, double nz)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(x, y, z);
  plane->SetNormal(nx, ny, nz);
  scene.Mapper->AddClippingPlane(plane);
}
} // namespace

TEST(Clipping, ByPlanesLeavesTheBoxBetweenThem)
{
  for (const int skipping : { 0, 2 })
  {
    Scene scene;
    Show(scene, MakeWaves());
    scene.Mapper->SetSkipping(skipping);
    const Picture box = DrawBox(scene, { 10, 49, 0, 30, 0, 53 });
    Clip(scene, 10.0, 0.0, 0.0, 1.0, 0.0, 0.0);
    Clip(scene, 0.0, 36.0, 0.0, 0.0, -1.0, 0.0);
    EXPECT_LE(RootMeanSquare(DrawFloats(scene), box), 2e-3);
    scene.Mapper->RemoveAllClippingPlanes();
    EXPECT_GT(RootMeanSquare(DrawFloats(scene), box), 2e-2);
  }
}

TEST(Clipping, ByPlanesThatTurnWithNothing)
{
  Scene scene;
  Show(scene, MakeWaves());
  const Picture whole = DrawFloats(scene);
  Clip(scene, -1e6, 0.0, 0.0, 1.0, 0.0, 0.0);
  EXPECT_EQ(LargestDifference(DrawFloats(scene), whole), 0.0);
  Clip(scene, 1e6, 0.0, 0.0, 1.0, 0.0, 0.0);
  for (const auto& pixel : DrawFloats(scene))
  {
    ASSERT_EQ(pixel[3], 0.0);
  }
}

TEST(Cropping, ToTheMiddleRegionIsThatBox)
{
  Scene scene;
  Show(scene, MakeWaves());
  const Picture box = DrawBox(scene, { 10, 40, 5, 30, 20, 45 });
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionFlagsToSubVolume();
  scene.Mapper->SetCroppingRegionPlanes(10.0, 40.0, 6.0, 36.0, 18.0, 40.5);
  EXPECT_LE(RootMeanSquare(DrawFloats(scene), box), 2e-3);
}

TEST(Cropping, ToAllRegionsOrNone)
{
  Scene scene;
  Show(scene, MakeWaves());
  const Picture whole = DrawFloats(scene);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(10.0, 40.0, 6.0, 36.0, 18.0, 40.5);
  scene.Mapper->SetCroppingRegionFlags(AllRegions);
  EXPECT_LE(LargestDifference(DrawFloats(scene), whole), 1e-5);
  scene.Mapper->SetCroppingRegionFlags(0);
  for (const auto& pixel : DrawFloats(scene))
  {
    ASSERT_EQ(pixel[3], 0.0);
  }
}

// What is before and what is behind: a ray has several parts.
TEST(Cropping, ToTheRestCompletesTheMiddle)
{
  Scene scene;
  Show(scene, MakeWaves());
  scene.SetOpacity({ { 500.0, 0.0 }, { 1000.0, 1e-4 } }); // so that opacities add up
  const Picture whole = DrawFloats(scene);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(10.0, 40.0, 6.0, 36.0, 18.0, 40.5);
  scene.Mapper->SetCroppingRegionFlagsToInvertedFence();
  const Picture part = DrawFloats(scene);
  scene.Mapper->SetCroppingRegionFlags(AllRegions & ~scene.Mapper->GetCroppingRegionFlags());
  const Picture rest = DrawFloats(scene);
  double largest = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    largest = std::max(largest, std::abs(part[i][3] + rest[i][3] - whole[i][3]));
    sum += part[i][3];
  }
  EXPECT_LE(largest, 1e-5);
  EXPECT_GT(sum, 0.0);
}
