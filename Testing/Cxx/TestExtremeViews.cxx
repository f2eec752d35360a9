// Rays and cameras far from what is usual.
#include "Extremes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace flatblock::testing;

namespace
{
const char* const Group = "rays and cameras";
constexpr double Bound = 0.01; // a step of half a voxel

using Point3 = std::array<double, 3>;

void Look(Scene& scene, const Point3& from, const Point3& to, double angle = 30.0)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(from.data());
  camera->SetFocalPoint(to.data());
  camera->SetViewUp(0.0, 1.0, 0.1);
  camera->SetViewAngle(angle);
  camera->OrthogonalizeViewUp();
  scene.Renderer->ResetCameraClippingRange();
}

void Show(Scene& scene)
{
  ShowWaves(scene, { 17, 17, 17 });
  scene.Mapper->SetBlockSize(17);
}

using Ends = std::pair<Point3, Point3>;

void ShowCube(Scene& scene, int size)
{
  ShowWaves(scene, { 33, 33, 33 });
  scene.Mapper->SetBlockSize(17);
  scene.Window->SetSize(size, size);
}

void LookParallel(Scene& scene, const Ends& ends)
{
  Look(scene, ends.first, ends.second);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(21.3);
  scene.Renderer->ResetCameraClippingRange();
}
} // namespace

// An odd number of pixels: the ray in the middle runs along the axis itself, and in borders of
// blocks.
TEST(ExtremeViews, RaysAlongAxesBordersAndDiagonals)
{
  for (int size : { 64, 65 })
  {
    Scene scene;
    ShowCube(scene, size);
    for (const Ends& ends :
      { Ends{ { 16, 16, 90 }, { 16, 16, 16 } }, Ends{ { -90, 16, 16 }, { 16, 16, 16 } },
        Ends{ { 90, 90, 90 }, { 0, 0, 0 } }, Ends{ { 90, 90, 16 }, { 0, 0, 16 } } })
    {
      LookParallel(scene, ends);
      ExpectRight(scene, Group, "parallel rays along axes, borders and diagonals", Bound);
      scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
      scene.Renderer->ResetCameraClippingRange();
      ExpectRight(scene, Group, "rays through corners and along borders", Bound);
    }
  }
}

// Rays that run in a face or an edge of the volume itself may hit or miss it: all others are right.
TEST(ExtremeViews, RaysInEdgesAndFacesOfTheVolume)
{
  for (const Ends& ends : { Ends{ { 0, 0, 90 }, { 0, 0, 0 } },
         Ends{ { 32, 32, 90 }, { 32, 32, 0 } }, Ends{ { 32, 16, 90 }, { 32, 16, 0 } } })
  {
    Scene scene;
    ShowCube(scene, 65);
    for (bool parallel : { true, false })
    {
      LookParallel(scene, ends);
      scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      const Picture drawn = TakeEvery(DrawFloats(scene), 65, 4);
      const Picture expected = DrawReference(scene, 4);
      EXPECT_TRUE(IsSound(drawn));
      int missed = 0;
      double largest = 0.0;
      for (std::size_t i = 0; i < drawn.size(); ++i)
      {
        const double error = std::abs(drawn[i][3] - expected[i][3]);
        const bool isInFace = i % 17 == 8 || i / 17 == 8;
        missed += isInFace && error > Bound ? 1 : 0;
        largest = std::max(largest, isInFace ? 0.0 : error);
      }
      EXPECT_LE(largest, Bound);
      Record(Group, "rays in an edge or a face of the volume",
        std::to_string(missed) + " of them miss it, all others right", largest);
    }
  }
}

// A fiftieth of a voxel beside: a graphics card tells edges to 1/256 of a pixel.
TEST(ExtremeViews, RaysThatGrazeFaces)
{
  for (double beside : { 0.02, -0.02 })
  {
    Scene scene;
    ShowCube(scene, 65);
    LookParallel(scene, { { 32 + beside, beside, 90 }, { 32 + beside, beside, 0 } });
    ExpectRight(scene, Group, "rays a fiftieth of a voxel beside an edge", Bound);
  }
}

TEST(ExtremeViews, CamerasOnFacesInCornersAndInside)
{
  for (const auto& [from, to, name] :
    std::vector<std::tuple<Point3, Point3, std::string>>{
      { { 8, 8, 16 }, { 8, 8, 0 }, "on a face" }, { { 8, 8, 16 }, { 15, 9, 16 }, "in a face" },
      { { 16, 16, 16 }, { 0, 0, 0 }, "in a corner" }, { { 16, 8, 16 }, { 0, 8, 0 }, "on an edge" },
      { { 8, 8, 8 }, { 0, 3, 1 }, "in the middle" },
      { { 4.25, 7.5, 9.1 }, { 16, 3, 1 }, "inside" } })
  {
    Scene scene;
    Show(scene);
    Look(scene, from, to, 60.0);
    scene.Renderer->GetActiveCamera()->SetClippingRange(1e-3, 100.0);
    ExpectRight(scene, Group, "camera " + name, Bound);
  }
}

TEST(ExtremeViews, NearPlanesWithin)
{
  for (double nearPlane : { 30.0, 38.0, 45.0 })
  {
    Scene scene;
    Show(scene);
    Look(scene, { 30, 25, 35 }, { 8, 8, 8 });
    scene.Renderer->GetActiveCamera()->SetClippingRange(nearPlane, 100.0);
    ExpectRight(scene, Group, "near plane inside the volume", Bound);
  }
}

TEST(ExtremeViews, CamerasFarAway)
{
  const double diagonal = 16.0 * std::sqrt(3.0);
  for (double distance : { 1e2, 1e4, 1e6 })
  {
    Scene scene;
    Show(scene);
    const double d = distance * diagonal / std::sqrt(3.0);
    const double angle = 2.0 * std::atan(0.6 / distance) * 180.0 / 3.14159265358979323846;
    Look(scene, { 8 + 0.3 * d, 8 + 0.5 * d, 8 + 1.6 * d }, { 8, 8, 8 }, angle);
    ExpectRight(scene, Group,
      "camera 1e" + std::to_string(int(std::log10(distance) + 0.5)) +
        " diagonals away, as close as it can be zoomed",
      Bound);
  }
}

TEST(ExtremeViews, AnglesOfView)
{
  Scene narrow;
  Show(narrow);
  Look(narrow, { 8, 20, 1e5 }, { 8, 8, 8 }, 0.01);
  ExpectRight(narrow, Group, "field of view of 0.01 degrees", Bound);
  Scene close;
  Show(close);
  Look(close, { 8, 20, 60 }, { 8, 8, 8 }, 0.01);
  ExpectRight(close, Group, "field of view of 0.01 degrees, from close by", Bound);
  for (const Point3& from : { Point3{ 8, 10, 30 }, { 8, 8, 8 }, { 8, 8, 17 } })
  {
    Scene wide;
    Show(wide);
    Look(wide, from, { 8, 8, -8 }, 170.0);
    wide.Renderer->GetActiveCamera()->SetClippingRange(1e-2, 100.0);
    ExpectRight(wide, Group, "field of view of 170 degrees", Bound);
  }
}

TEST(ExtremeViews, ParallelScales)
{
  for (double scale : { 1e-6, 1e-3, 1.0, 1e3, 1e6 })
  {
    Scene scene;
    Show(scene);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    Look(scene, { 30, 25, 35 }, { 8.3, 8.1, 8.2 });
    scene.Window->SetSize(65, 65); // the ray in the middle hits even what is smaller than a pixel
    scene.Renderer->GetActiveCamera()->SetParallelScale(scale);
    // VTK's own range begins a ten-thousandth of the scale before the camera, behind the volume.
    scene.Renderer->GetActiveCamera()->SetClippingRange(1.0, 100.0);
    EXPECT_GT(CompareWithReference(scene).Brightest, 0.5);
    ExpectRight(scene, Group, "parallel scale " + ToText(scale), Bound);
  }
}
