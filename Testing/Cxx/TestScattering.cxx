// Light that the volume scatters, where VTK has it, too.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkLight.h"
#include "vtkPlane.h"
#include "vtkVersionMacros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)

using namespace flatblock::testing;

namespace
{
using Vector = std::array<double, 3>;

constexpr int Samples = 41;
constexpr double Last = Samples - 1;
constexpr double Scale = 0.5 * Last; // of the parallel projection

// Which trilinear interpolation reproduces.
double ValueAt(double x, double y, double z)
{
  return 500.0 + 6.0 * (x - 25.0) + 0.3 * (y - 18.0) * (z - 22.0);
}

double ExtinctionAt(const Vector& p)
{
  const double opacity = 0.3 * std::clamp((ValueAt(p[0], p[1], p[2]) - 450.0) / 350.0, 0.0, 1.0);
  return -std::log1p(-opacity);
}

void Light(Scene& scene, const Vector& direction)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPosition(direction.data());
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AddLight(light);
}

void Scatter(Scene& scene, double blending, double reach)
{
  scene.Property->ShadeOn();
  scene.Property->SetAmbient(0.0);
  scene.Property->SetDiffuse(1.0);
  scene.Property->SetSpecular(0.0);
  scene.Mapper->SetVolumetricScatteringBlending(static_cast<float>(blending));
  scene.Mapper->SetGlobalIlluminationReach(static_cast<float>(reach));
}

void LookAlongZ(Scene& scene, double scale)
{
  scene.LookFrom(0.0, 0.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(scale);
}

// White matter that its own light shines through.
void ShowMatter(Scene& scene, const Vector& light, double reach)
{
  const auto field = [](int x, int y, int z) { return ValueAt(x, y, z); };
  scene.SetVolume(MakeVolume({ Samples, Samples, Samples }, VTK_FLOAT, field), 0.5);
  scene.SetOpacity({ { 450.0, 0.0 }, { 800.0, 0.3 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 } });
  scene.Mapper->SetBlockSize(17);
  LookAlongZ(scene, Scale);
  Light(scene, light);
  Scatter(scene, 1.0, reach);
  scene.Mapper->SetEarlyTerminationThreshold(1.0);
}

using Region = std::function<bool(const Vector&)>;

double DepthAlong(Vector at, const Vector& way, double length, const Region& region)
{
  constexpr double Step = 0.1;
  double depth = 0.0;
  for (double t = 0.5 * Step; t < length; t += Step)
  {
    const Vector p = { at[0] + t * way[0], at[1] + t * way[1], at[2] + t * way[2] };
    const bool isInside =
      std::all_of(p.begin(), p.end(), [](double c) { return c >= 0.0 && c <= Last; });
    depth += isInside && region(p) ? Step * ExtinctionAt(p) : 0.0;
  }
  return depth;
}

// What is seen along z from a depth on, of light from a direction that is absorbed over so many
// samples.
double Integrate(double x, double y, double from, Vector light, double reach, const Region& region)
{
  constexpr double Step = 0.1;
  const double length = std::hypot(light[0], light[1], light[2]);
  std::transform(light.begin(), light.end(), light.begin(), [&](double c) { return c / length; });
  double seen = 0.0;
  double depth = 0.0;
  for (double z = from - 0.5 * Step; z > 0.0; z -= Step)
  {
    const double absorbed = region({ x, y, z }) ? Step * ExtinctionAt({ x, y, z }) : 0.0;
    seen +=
      -std::expm1(-absorbed) * std::exp(-depth - DepthAlong({ x, y, z }, light, reach, region));
    depth += absorbed;
  }
  return seen;
}

bool IsAnywhere(const Vector&)
{
  return true;
}

const std::vector<std::array<int, 2>> Pixels = { { 60, 60 }, { 128, 128 }, { 200, 90 },
  { 150, 220 } };

void ExpectIntegrals(Scene& scene, const Vector& light, double reach, const Region& region)
{
  const Picture picture = DrawFloats(scene);
  const double scale = scene.Renderer->GetActiveCamera()->GetParallelScale();
  for (const auto& pixel : Pixels)
  {
    const double x = Scale + (pixel[0] + 0.5 - 128.0) / 128.0 * scale;
    const double y = Scale + (pixel[1] + 0.5 - 128.0) / 128.0 * scale;
    const double expected = Integrate(x, y, Last, light, reach, region);
    EXPECT_NEAR(picture[pixel[0] + 256 * pixel[1]][0], expected, 4e-3) << x << ", " << y;
  }
}

// A ramp that nothing but the volume lights, as it faces away: the share of light that scatters.
double DrawScatteredShare(double blending, double spacing)
{
  Scene scene;
  const auto image = MakeVolume({ 17, 17, 17 }, VTK_FLOAT, [](int, int, int z) { return z; });
  image->SetSpacing(spacing, spacing, spacing);
  scene.SetVolume(image, spacing);
  scene.Property->SetScalarOpacityUnitDistance(spacing);
  scene.SetOpacity({ { 0.0, 0.2 }, { 16.0, 0.2 } });
  scene.SetColor({ { 0.0, 1.0, 1.0, 1.0 } });
  scene.Renderer->TwoSidedLightingOff();
  Scatter(scene, blending, 0.0);
  LookAlongZ(scene, 6.0 * spacing);
  Light(scene, { 0.0, 0.0, 1.0 });
  const auto color = DrawFloats(scene)[128 + 256 * 128];
  return color[0] / color[3];
}
} // namespace

TEST(ScatteredLight, IsAbsorbedOnItsWay)
{
  for (const Vector& light :
    { Vector{ 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 }, { 4.0, 6.0, 3.0 }, { -1.0, -2.0, -3.0 } })
  {
    Scene scene;
    ShowMatter(scene, light, 1.0);
    ExpectIntegrals(scene, light, Last, IsAnywhere);
    scene.Mapper->SetGlobalIlluminationReach(0.2F);
    ExpectIntegrals(scene, light, 0.2 * Last, IsAnywhere);
    scene.Mapper->SetGlobalIlluminationReach(0.0F);
    ExpectIntegrals(scene, light, 0.0, IsAnywhere);
  }
}

TEST(ScatteredLight, IsAbsorbedByWhatIsOutOfView)
{
  const Vector light = { 4.0, 6.0, 3.0 };
  Scene scene;
  ShowMatter(scene, light, 1.0);
  scene.Renderer->GetActiveCamera()->SetParallelScale(2.0);
  ExpectIntegrals(scene, light, Last, IsAnywhere);
}

// And not by what is behind the eye.
TEST(ScatteredLight, ComesFromTheEye)
{
  Scene scene;
  ShowMatter(scene, { 0.0, 0.0, 1.0 }, 1.0);
  scene.Renderer->RemoveAllLights();
  scene.Renderer->CreateLight();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(27.0, 14.0, 30.0);
  camera->SetFocalPoint(27.0, 14.0, 0.0);
  camera->SetClippingRange(0.001, 100.0);
  constexpr double depth = 30.0;
  const double expected = Integrate(
    27.0, 14.0, depth, { 0.0, 0.0, 1.0 }, Last, [](const Vector& p) { return p[2] < depth; });
  EXPECT_NEAR(DrawFloats(scene)[128 + 256 * 128][0], expected, 4e-3);
}

TEST(ScatteredLight, PassesWhatIsCutOff)
{
  const Vector light = { 4.0, 6.0, 3.0 };
  Scene scene;
  ShowMatter(scene, light, 1.0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 23.0, 0.0);
  plane->SetNormal(0.0, -1.0, 0.0);
  scene.Mapper->AddClippingPlane(plane);
  ExpectIntegrals(scene, light, Last, [](const Vector& p) { return p[1] < 23.0; });
  scene.Mapper->RemoveAllClippingPlanes();
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(-1.0, 25.0, -1.0, 50.0, -1.0, 50.0);
  scene.Mapper->SetCroppingRegionFlags(VTK_CROP_SUBVOLUME);
  ExpectIntegrals(scene, light, Last, [](const Vector& p) { return p[0] < 25.0; });
}

// Henyey and Greenstein's phase function, by the angle that light is turned by.
TEST(ScatteredLight, GoesOnOrBack)
{
  for (const double g : { -0.5, 0.0, 0.5 })
  {
    Scene scene;
    ShowMatter(scene, { 0.0, 0.0, -1.0 }, 0.0);
    scene.Property->SetDiffuse(0.1);
    scene.Property->SetScatteringAnisotropy(static_cast<float>(g));
    const double on = (1.0 - g * g) / std::pow(1.0 - g, 3.0);
    const double back = (1.0 - g * g) / std::pow(1.0 + g, 3.0);
    const auto fromBehind = DrawFloats(scene)[128 + 256 * 128];
    EXPECT_NEAR(fromBehind[0] / fromBehind[3], 0.1 * on, 1e-3) << g;
    Light(scene, { 0.0, 0.0, 1.0 });
    const auto fromBefore = DrawFloats(scene)[128 + 256 * 128];
    EXPECT_NEAR(fromBefore[0] / fromBefore[3], 0.1 * back, 1e-3) << g;
  }
}

// As VTK's documentation has it: none, or at 1 only where the gradient is flat, to all.
TEST(ScatteredLight, LeavesSteepGradientsToSurfaces)
{
  constexpr double Spacing = 0.01;
  const double gradient = 2.0 / 16.0 / Spacing; // of shares of the range, over two samples
  const double flat = std::exp(-0.2 * gradient);
  EXPECT_NEAR(DrawScatteredShare(0.0, Spacing), 0.0, 1e-3);
  EXPECT_NEAR(DrawScatteredShare(0.5, Spacing), 0.5 * std::sqrt(flat), 0.02);
  EXPECT_NEAR(DrawScatteredShare(1.0, Spacing), flat, 0.02);
  EXPECT_NEAR(DrawScatteredShare(1.5, Spacing), 0.5 * std::pow(flat, 1.5) + 0.5, 0.02);
  EXPECT_NEAR(DrawScatteredShare(2.0, Spacing), 1.0, 1e-3);
}

TEST(ScatteredLight, NeedsBlending)
{
  Scene scene;
  ShowMatter(scene, { 1.0, 1.0, 1.0 }, 0.0);
  scene.Mapper->SetVolumetricScatteringBlending(0.0F);
  const auto without = scene.Draw();
  scene.Mapper->SetGlobalIlluminationReach(1.0F);
  EXPECT_EQ(LargestDifference(scene.Draw(), without), 0.0);
  scene.Mapper->SetVolumetricScatteringBlending(1.0F);
  EXPECT_GE(LargestDifference(scene.Draw(), without), 30.0);
}

// At full resolution; and where memory is short they show as they do with light on surfaces.
TEST(ScatteredLight, ShowsNoBlocks)
{
  Scene scene;
  scene.SetVolume(MakeWaves(), 0.25);
  scene.SetOpacity({ { 550.0, 0.0 }, { 650.0, 0.5 } });
  scene.SetColor({ { 500.0, 0.8, 0.3, 0.2 }, { 700.0, 0.9, 0.9, 0.7 } });
  scene.LookFrom(30.0, 40.0, 1.3);
  Light(scene, { 3.0, 2.0, -1.0 });
  Scatter(scene, 1.2, 0.6);
  scene.Property->SetScatteringAnisotropy(0.4F);
  scene.Mapper->SetBlockSize(65);
  const auto whole = scene.Draw();
  scene.Mapper->SetBlockSize(17);
  EXPECT_LE(LargestDifference(scene.Draw(), whole), 2.0);
  scene.Mapper->SetMaxMemoryInBytes(Beside + 60000);
  const auto coarse = scene.Draw();
  EXPECT_GT(scene.Mapper->GetNumberOfBricks(2), 10);
  EXPECT_GE(PSNR(coarse, whole), 28.0);
}

// A ball within a large empty volume: most blocks have no brick, and rays to lights leap over them.
TEST(ScatteredLight, LeapsOverBlocksWithoutABrick)
{
  Scene scene;
  scene.SetVolume(MakeVolume({ 129, 129, 129 }, VTK_UNSIGNED_CHAR,
                    [](int x, int y, int z)
                    { return std::hypot(x - 20.0, y - 20.0, z - 20.0) < 14.0 ? 200 : 0; }),
    0.5);
  scene.SetOpacity({ { 50.0, 0.0 }, { 200.0, 0.2 } });
  scene.LookFrom(0.0, 0.0);
  Light(scene, { 1.0, 1.0, 1.0 });
  Scatter(scene, 2.0, 1.0);
  scene.Mapper->CountSamplesOn();
  scene.Mapper->SetBlockSize(65);
  scene.Draw();
  const double inLargeBlocks = scene.Mapper->GetFetchesPerRay();
  scene.Mapper->SetBlockSize(17);
  scene.Draw();
  EXPECT_LE(scene.Mapper->GetFetchesPerRay(), 0.5 * inLargeBlocks);
}

#endif
