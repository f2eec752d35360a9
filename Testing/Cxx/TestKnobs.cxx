// What trades accuracy for speed: errors within their bounds, and nothing where it is off.
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtk_glew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace flatblock::testing;

namespace
{
using Mapper = vtkFlatBlockVolumeMapper;

double FogAt(int x, int y, int z)
{
  return 500.0 + 160.0 * (std::sin(0.06 * x) + std::cos(0.05 * y - 0.04 * x) + std::sin(0.07 * z));
}

void ShowFog(Scene& scene)
{
  scene.SetVolume(MakeVolume({ 65, 65, 65 }, VTK_FLOAT, FogAt), 0.5);
  scene.Window->SetSize(96, 96);
  scene.SetOpacity({ { 0.0, 0.0 }, { 1000.0, 0.02 } });
  scene.SetColor({ { 0.0, 0.2, 0.4, 0.6 }, { 1000.0, 0.8, 0.6, 0.3 } });
  scene.LookFrom(35.0, 25.0, 1.3);
}

// Of all shaders that the scene's context has.
std::string GetShaderSources(Scene& scene)
{
  DrawFloats(scene);
  std::string sources;
  for (GLuint name = 1; name < 1000; ++name)
  {
    GLint length = 0;
    if (glIsShader(name) != 0)
    {
      glGetShaderiv(name, GL_SHADER_SOURCE_LENGTH, &length);
    }
    std::string source(static_cast<std::size_t>(length), ' ');
    if (length > 0)
    {
      glGetShaderSource(name, length, nullptr, source.data());
    }
    sources += source;
  }
  return sources;
}

int CountTextures()
{
  int count = 0;
  for (GLuint name = 1; name < 1000; ++name)
  {
    count += glIsTexture(name) != 0 ? 1 : 0;
  }
  return count;
}
} // namespace

// Off, a property leaves neither code in the shader nor a texture on the card.
TEST(Knobs, CostNothingWhereTheyAreOff)
{
  struct Knob
  {
    const char* Code; // that its shader has
    int Textures;
    std::function<void(Scene&)> TurnOn;
  };
  const Knob knobs[] = {
    { "define FLATBLOCK_SKIPPING", 1, [](Scene& s) { s.Mapper->SetSkippingToCells(); } },
    { "in_LightDirection", 0, [](Scene& s) { s.Property->ShadeOn(); } },
    { "define FLATBLOCK_COUNTING", 2, [](Scene& s) { s.Mapper->CountSamplesOn(); } },
    { "define FLATBLOCK_SAMPLE_LIMIT", 2,
      [](Scene& s) { s.Mapper->SetMaximumNumberOfSamples(50); } },
    { "define FLATBLOCK_ADAPTIVE_IMAGE", 1,
      [](Scene& s)
      {
        s.Mapper->AutoAdjustSampleDistancesOff();
        s.Window->SetDesiredUpdateRate(20.0);
        s.Mapper->AdaptiveImageSamplingOn();
      } },
    { "define FLATBLOCK_BRICK_RANGES", 1, [](Scene& s) { s.Mapper->SetAtlasPrecisionTo8Bits(); } },
    { "define FLATBLOCK_JITTERING", 0, [](Scene& s) { s.Mapper->UseJitteringOn(); } },
    { "define FLATBLOCK_RAY_START", 0, [](Scene& s) { s.Mapper->SetRayStartOffset(1.0); } },
  };
  for (const Knob& knob : knobs)
  {
    Scene scene;
    ShowFog(scene);
    scene.Mapper->SetSkippingToNothing();
    const std::string off = GetShaderSources(scene);
    const int texturesOff = CountTextures();
    knob.TurnOn(scene);
    const std::string on = GetShaderSources(scene);
    const std::string code = knob.Code;
    EXPECT_NE(on.find(code), std::string::npos) << code;
    EXPECT_EQ(off.find(code), std::string::npos) << code;
    EXPECT_EQ(CountTextures() - texturesOff, knob.Textures) << code;
  }
}

// Along a ray of length L opacity is off by at most L times how far extinction is, and colour by
// that and by how far colours are.
TEST(VariationTolerance, BoundsTheError)
{
  Scene scene;
  ShowFog(scene);
  scene.Mapper->SetHomogeneousLeaps(false);
  scene.Mapper->CountSamplesOn();
  const Picture exact = DrawFloats(scene);
  double samples = scene.Mapper->GetSamplesPerRay();
  double last = 0.0;
  for (const double tolerance : { 1.0, 10.0, 60.0, 200.0 })
  {
    scene.Mapper->SetVariationTolerance(tolerance);
    const double error = LargestDifference(DrawFloats(scene), exact);
    const double extinction = -std::log1p(-0.02) * tolerance / 1000.0;
    const double color = 0.6 * tolerance / 1000.0;
    constexpr double Length = 64.0 * 1.7320508;
    std::cout << "tolerance " << tolerance << ": error " << error << ", "
              << scene.Mapper->GetSamplesPerRay() << " samples a ray instead of " << samples
              << "\n";
    EXPECT_LE(error, color + 1.05 * extinction * Length);
    EXPECT_LE(scene.Mapper->GetSamplesPerRay(), samples);
    EXPECT_GE(error, last);
    samples = scene.Mapper->GetSamplesPerRay();
    last = error;
  }
  scene.Mapper->SetVariationTolerance(0.0);
  EXPECT_EQ(LargestDifference(DrawFloats(scene), exact), 0.0);
}

TEST(VariationTolerance, CostsFourPercentOfTheAtlasAtMost)
{
  Scene scene;
  ShowFog(scene);
  scene.Mapper->SetVariationTolerance(20.0);
  scene.Window->Render();
  const vtkTypeInt64 with = scene.Mapper->GetMemoryInBytes();
  scene.Mapper->SetSkippingToNothing();
  scene.Window->Render();
  EXPECT_LE(with - scene.Mapper->GetMemoryInBytes(), scene.Mapper->GetAtlasBytes() * 4 / 100);
  EXPECT_GT(with, scene.Mapper->GetMemoryInBytes());
}

// A sample is off by half a step of the block's range at most, and a ray as by a tolerance.
TEST(AtlasPrecision, BoundsTheError)
{
  Scene scene;
  ShowFog(scene);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetHomogeneousLeaps(false);
  const Picture exact = DrawFloats(scene);
  const vtkTypeInt64 bytes = scene.Mapper->GetUsedAtlasBytes();
  constexpr double LargestRange = 480.0; // of a block of 16^3 cells, at most
  double last = 0.0;
  for (const int bits : { Mapper::BITS_8, Mapper::BITS_4, Mapper::BITS_1 })
  {
    scene.Mapper->SetAtlasPrecision(bits);
    const double difference = LargestDifference(DrawFloats(scene), exact);
    const double off = 0.5 * LargestRange / ((1 << bits) - 1);
    const double extinction = -std::log1p(-0.02) * off / 1000.0;
    constexpr double Length = 64.0 * 1.7320508;
    std::cout << bits << " bits: error " << difference << "\n";
    EXPECT_LE(difference, 0.6 * off / 1000.0 + 1.05 * extinction * Length + 1e-3);
    EXPECT_GT(difference, last);
    EXPECT_EQ(scene.Mapper->GetUsedAtlasBytes(), bytes / 4);
    last = difference;
  }
  scene.Mapper->SetAtlasPrecisionToNative();
  EXPECT_EQ(LargestDifference(DrawFloats(scene), exact), 0.0);
}

TEST(AtlasPrecision, IsThatOfTheBlockAtAllLevelsAndFilters)
{
  Scene scene;
  ShowFog(scene);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetSkippingToNothing();
  for (const int filter : { Mapper::SUBSAMPLE, Mapper::TENT })
  {
    scene.Mapper->SetLevelFilter(filter);
    scene.Mapper->SetAtlasPrecisionToNative();
    scene.Mapper->SetMaxMemoryInBytes(900000);
    const Picture native = DrawFloats(scene);
    const vtkTypeInt64 finest = scene.Mapper->GetNumberOfBricks(0);
    EXPECT_LT(finest, scene.Mapper->GetNumberOfVisibleBlocks());
    scene.Mapper->SetAtlasPrecisionTo8Bits();
    const Picture few = DrawFloats(scene);
    EXPECT_GT(scene.Mapper->GetNumberOfBricks(0), finest) << "more fit";
    EXPECT_LE(RootMeanSquare(few, DrawReference(scene)),
      RootMeanSquare(native, DrawReference(scene)) + 1e-4);
  }
}

// The scales go before what takes their place comes.
TEST(AtlasPrecision, ChangesWithinTheLimit)
{
  Scene scene;
  ShowFog(scene);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetMaxMemoryInBytes(900000);
  for (const int bits : { Mapper::BITS_8, Mapper::NATIVE, Mapper::BITS_8 })
  {
    scene.Mapper->SetAtlasPrecision(bits);
    scene.Window->Render();
    EXPECT_LE(scene.Mapper->GetPeakMemoryInBytes(), 900000) << bits;
  }
}

TEST(AtlasPrecision, RefusesWhatItDoesNotHave)
{
  vtkNew<Mapper> mapper;
  mapper->SetAtlasPrecisionTo4Bits();
  vtkObject::GlobalWarningDisplayOff();
  mapper->SetAtlasPrecision(5);
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_EQ(mapper->GetAtlasPrecision(), 4);
}

// In error, and in samples of all rays.
TEST(AdaptiveImageSampling, RefinesWhereRaysDiffer)
{
  Scene scene;
  ShowShell(scene, 256 << 20);
  scene.Mapper->AutoAdjustSampleDistancesOff();
  const auto whole = scene.Draw();
  scene.Mapper->AdaptiveImageSamplingOn();
  EXPECT_EQ(LargestDifference(scene.Draw(), whole), 0.0) << "stills are whole";
  scene.Window->SetDesiredUpdateRate(20.0);
  scene.Mapper->SetImageSamplingTolerance(0.0);
  EXPECT_GE(PSNR(scene.Draw(), whole), 45.0) << "any difference is refined";
  scene.Mapper->SetImageSamplingTolerance(0.02);
  const double fine = PSNR(scene.Draw(), whole);
  EXPECT_TRUE(MatchesBaseline(scene.Window, "AdaptiveImage"));
  scene.Mapper->SetImageSamplingTolerance(1.0);
  const double coarse = PSNR(scene.Draw(), whole);
  std::cout << "tolerance 0.02: " << fine << " dB, 1: " << coarse << " dB\n";
  EXPECT_GE(fine, coarse + 5.0);
  EXPECT_LE(scene.Mapper->GetPeakMemoryInBytes(), 256 << 20);
}

TEST(Quality, PresetsAreInOrder)
{
  using Show = void (*)(Scene&);
  const Show shows[] = { ShowFog, [](Scene& s) { ShowShell(s, 256 << 20); },
    [](Scene& s)
    {
      ShowFog(s);
      s.SetOpacity({ { 500.0, 0.0 }, { 560.0, 0.4 } });
      s.Property->ShadeOn();
    } };
  for (const Show& show : shows)
  {
    Scene scene;
    show(scene);
    scene.Window->SetSize(96, 96);
    scene.Mapper->CountSamplesOn();
    constexpr int Stride = 3;
    const Picture reference = DrawReference(scene, Stride);
    double lastError = 1.0;
    double lastWork = 0.0;
    using Set = void (Mapper::*)();
    for (const Set set :
      { Set(&Mapper::SetQualityToInteractive), Set(&Mapper::SetQualityToBalanced),
        Set(&Mapper::SetQualityToAccurate), Set(&Mapper::SetQualityToReference) })
    {
      (scene.Mapper->*set)();
      scene.Window->Render();
      const double error = RootMeanSquare(TakeEvery(DrawFloats(scene), 96, Stride), reference);
      const double rays = std::pow(96.0 / scene.Mapper->GetUsedImageSampleDistance(), 2.0);
      const double work = rays * scene.Mapper->GetSamplesPerRay();
      std::cout << "error " << error << ", samples " << work << "\n";
      EXPECT_LT(error, lastError);
      EXPECT_GT(work, lastWork);
      lastError = error;
      lastWork = work;
    }
  }
}

TEST(Quality, AutomaticKeepsToTheGoal)
{
  Scene scene;
  ShowFog(scene);
  scene.Window->SetSize(256, 256);
  scene.Mapper->SetQualityToAutomatic();
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetUsedImageSampleDistance(), 1.0);
  scene.Window->SetDesiredUpdateRate(10.0);
  scene.Mapper->SetFrameTimeGoal(1e-3);
  for (int frame = 0; frame < 8; ++frame)
  {
    scene.Window->Render();
  }
  const double coarser = scene.Mapper->GetUsedImageSampleDistance();
  EXPECT_GE(coarser, 2.0);
  EXPECT_LT(Mapper::GetExpectedPSNR(coarser), Mapper::GetExpectedPSNR(1.0));
  EXPECT_GT(Mapper::GetExpectedPSNR(coarser), 15.0);
  scene.Mapper->SetFrameTimeGoal(100.0);
  for (int frame = 0; frame < 8; ++frame)
  {
    scene.Window->Render();
  }
  EXPECT_EQ(scene.Mapper->GetUsedImageSampleDistance(), 1.0);
}

TEST(CountSamples, CountsWhatIsThere)
{
  Scene scene;
  ShowFog(scene);
  scene.Mapper->SetSkippingToNothing();
  scene.Mapper->SetClassificationToPostInterpolation();
  const Picture uncounted = DrawFloats(scene);
  EXPECT_EQ(scene.Mapper->GetSamplesPerRay(), 0.0);
  scene.Mapper->CountSamplesOn();
  scene.Mapper->SetEarlyTerminationThreshold(1.0);
  EXPECT_LE(LargestDifference(DrawFloats(scene), uncounted), 0.005);
  const double samples = scene.Mapper->GetSamplesPerRay();
  scene.Mapper->SetSampleDistance(1.0);
  DrawFloats(scene);
  EXPECT_NEAR(samples / scene.Mapper->GetSamplesPerRay(), 2.0, 0.1);
  // Of the volume and two entries of the table, and some for each block.
  EXPECT_GE(scene.Mapper->GetFetchesPerRay(), 3.0 * scene.Mapper->GetSamplesPerRay());
  EXPECT_LE(scene.Mapper->GetFetchesPerRay(), 3.3 * scene.Mapper->GetSamplesPerRay() + 10.0);
}

TEST(Profiling, TimesTheGraphicsCard)
{
  Scene scene;
  ShowFog(scene);
  DrawFloats(scene);
  EXPECT_EQ(scene.Mapper->GetGPUMilliseconds(), -1.0);
  scene.Mapper->ProfilingOn();
  DrawFloats(scene);
  EXPECT_NE(scene.Mapper->GetGPUMilliseconds(), 0.0);
}
