// Calls at random, wise and unwise, with frames between them: errors are welcome, crashes are not.
// The environment variable FLATBLOCK_RANDOM_CALLS says how many, FLATBLOCK_RANDOM_SEED which.
#include "Dice.h"
#include "Rendering.h"
#include "Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkVersionMacros.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <limits>

using namespace flatblock::testing;

namespace
{
using Call = std::function<void(Scene&, Dice&)>;
using Mapper = vtkFlatBlockVolumeMapper;

int GetNumber(const char* variable, int otherwise)
{
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

// A property that takes integers, some of them out of range.
template <typename Class, typename Value>
Call Of(void (Class::*set)(Value), int first, int last)
{
  return [=](Scene& scene, Dice& dice)
  { (scene.Mapper->*set)(static_cast<Value>(first - 1 + dice.Below(last - first + 3))); };
}

template <typename Class>
Call OfFlag(void (Class::*set)(bool))
{
  return [=](Scene& scene, Dice& dice) { (scene.Mapper->*set)(dice.Chance(0.5)); };
}

// One that takes reals, some of them none.
template <typename Class, typename Value>
Call OfReal(void (Class::*set)(Value), double low, double high)
{
  return [=](Scene& scene, Dice& dice)
  {
    const double unwise = dice.OneOf({ 0.0, -1.0, 1e30, std::numeric_limits<double>::infinity(),
      std::numeric_limits<double>::quiet_NaN() });
    const double value = dice.Chance(0.05) ? unwise : dice.Between(low, high);
    (scene.Mapper->*set)(static_cast<Value>(value));
  };
}

// 1 to 5 components, of all types.
vtkSmartPointer<vtkImageData> MakeImage(Dice& dice)
{
  const auto side = [&dice] { return dice.OneOf({ 1, 2, 16, 17, 18, 33, 40 }); };
  const int type = dice.OneOf({ VTK_UNSIGNED_CHAR, VTK_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
    VTK_FLOAT, VTK_DOUBLE, VTK_LONG_LONG });
  const double most = type == VTK_UNSIGNED_CHAR || type == VTK_CHAR ? 120.0 : 1000.0;
  const auto image = MakeVolume({ side(), side(), side() }, type,
    [&](int x, int y, int z)
    { return most * (0.5 + 0.5 * std::sin(0.2 * x + 0.3 * y - 0.1 * z)); });
  const int components = dice.OneOf({ 1, 1, 1, 2, 3, 4, 5 });
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (components > 1)
  {
    const auto many = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
    many->SetNumberOfComponents(components);
    many->SetNumberOfTuples(scalars->GetNumberOfTuples());
    for (int i = 0; i < components; ++i)
    {
      many->CopyComponent(i, scalars, 0);
    }
    image->GetPointData()->SetScalars(many);
  }
  else if (type == VTK_FLOAT && dice.Chance(0.3))
  {
    scalars->SetComponent(scalars->GetNumberOfTuples() / 2, 0, std::nan(""));
  }
  image->SetSpacing(dice.OneOf({ 1.0, 0.3, 1e-3 }), 1.0, dice.OneOf({ 1.0, 2.0, 1e4 }));
  return image;
}

void EditOpacity(Scene& scene, Dice& dice)
{
  vtkPiecewiseFunction* opacity = scene.Property->GetScalarOpacity(dice.Below(4));
  if (dice.Chance(0.2))
  {
    opacity->RemoveAllPoints();
  }
  opacity->AddPoint(dice.Between(-200.0, 1200.0), dice.OneOf({ 0.0, 0.01, 0.3, 1.0 }));
}

void EditColor(Scene& scene, Dice& dice)
{
  vtkColorTransferFunction* color = scene.Property->GetRGBTransferFunction(dice.Below(4));
  if (dice.Chance(0.2))
  {
    color->RemoveAllPoints();
  }
  color->AddRGBPoint(dice.Between(-200.0, 1200.0), dice.Between(0.0, 1.0), 0.5, 0.2);
}

void EditLight(Scene& scene, Dice& dice)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  scene.Mapper->SetVolumetricScatteringBlending(static_cast<float>(dice.Between(-0.5, 2.5)));
  scene.Mapper->SetGlobalIlluminationReach(static_cast<float>(dice.Between(-0.5, 1.5)));
#endif
  scene.Property->SetAmbient(dice.Between(0.0, 1.0));
}

void EditProperty(Scene& scene, Dice& dice)
{
  scene.Property->SetShade(dice.Below(2));
  scene.Property->SetInterpolationType(dice.Below(2));
  scene.Property->SetIndependentComponents(dice.Below(2));
  scene.Property->SetScalarOpacityUnitDistance(dice.OneOf({ 1.0, 10.0, 1e-3 }));
  scene.Property->SetComponentWeight(dice.Below(4), dice.OneOf({ 0.0, 0.5, 1.0 }));
  if (dice.Chance(0.3))
  {
    scene.Property->GetGradientOpacity(0)->AddPoint(
      dice.Between(0.0, 300.0), dice.Between(0.0, 1.0));
  }
  scene.Property->SetDisableGradientOpacity(dice.Below(2));
}

void ModifyInPlace(Scene& scene, Dice& dice)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataObjectInput());
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    return;
  }
  for (int i = 0; i < 20; ++i)
  {
    const auto tuples = static_cast<int>(scalars->GetNumberOfTuples());
    scalars->SetComponent(dice.Below(tuples), 0, dice.Between(0.0, 120.0));
  }
  if (dice.Chance(0.5))
  {
    scalars->Modified();
    image->Modified();
  }
}

void SetMask(Scene& scene, Dice& dice)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataObjectInput());
  if (!image || dice.Chance(0.5))
  {
    scene.Mapper->SetMaskInput(nullptr);
    return;
  }
  int size[3];
  image->GetDimensions(size);
  const int off = dice.OneOf({ 0, 0, 0, 1 });
  const auto mask = MakeVolume({ size[0] + off, size[1], size[2] }, VTK_UNSIGNED_CHAR,
    [](int x, int y, int) { return x > y ? 1.0 : 0.0; });
  mask->SetSpacing(image->GetSpacing());
  scene.Mapper->SetMaskInput(mask);
}

void Clip(Scene& scene, Dice& dice)
{
  scene.Mapper->RemoveAllClippingPlanes();
  for (int i = dice.Below(4); i > 0; --i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0), dice.OneOf({ 0.0, 1.0 }));
    plane->SetOrigin(dice.Between(0.0, 20.0), dice.Between(0.0, 20.0), 10.0);
    scene.Mapper->AddClippingPlane(plane);
  }
  scene.Mapper->SetCropping(dice.Below(2));
  scene.Mapper->SetCroppingRegionPlanes(2.0, 12.0, 3.0, dice.Between(1.0, 20.0), 4.0, 15.0);
  scene.Mapper->SetCroppingRegionFlags(dice.Below(1 << 27));
}

void MoveCamera(Scene& scene, Dice& dice)
{
  scene.Renderer->ResetCamera();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->Azimuth(dice.Between(0.0, 360.0));
  camera->Elevation(dice.Between(-20.0, 20.0));
  camera->OrthogonalizeViewUp();
  camera->SetParallelProjection(dice.Below(2));
  camera->Dolly(dice.OneOf({ 0.5, 1.0, 1.5, 4.0 }));
  scene.Renderer->ResetCameraClippingRange();
  scene.Window->SetDesiredUpdateRate(dice.OneOf({ 0.001, 15.0 }));
}

void ChangeWindow(Scene& scene, Dice& dice)
{
  if (dice.Chance(0.2))
  {
    scene.Window->Finalize(); // as where it is lost
  }
  else if (dice.Chance(0.3))
  {
    scene.Mapper->ReleaseGraphicsResources(scene.Window);
  }
  scene.Window->SetSize(dice.OneOf({ 1, 17, 48 }), dice.OneOf({ 1, 33, 48 }));
}

// Most of what keeps anything from being drawn, or else all frames after a while would be errors.
void Relent(Scene& scene, Dice& dice)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataObjectInput());
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || image->GetDataDimension() < 3 || scalars->GetNumberOfComponents() > 4 ||
      (scalars->GetNumberOfComponents() == 3 && !scene.Property->GetIndependentComponents()))
  {
    scene.Mapper->SetInputData(MakeWaves());
  }
  const vtkTypeInt64 least = vtkTypeInt64(1) << dice.OneOf({ 19, 22, 26 });
  scene.Mapper->SetMaxMemoryInBytes(std::max(least, scene.Mapper->GetMaxMemoryInBytes()));
  scene.Mapper->SetScalarMode(VTK_SCALAR_MODE_DEFAULT);
  scene.Mapper->SetVectorMode(Mapper::DISABLED);
  if (scene.Mapper->GetBlendMode() == vtkVolumeMapper::SLICE_BLEND)
  {
    scene.Mapper->SetBlendModeToComposite();
  }
  scene.Mapper->SetRenderToImage(dice.Chance(0.1));
  if (dice.Chance(0.5))
  {
    scene.Mapper->SetMaskInput(nullptr);
    scene.Mapper->RemoveAllClippingPlanes();
    scene.Mapper->CroppingOff();
    scene.SetRamp(50.0, 950.0, 0.2);
    scene.Mapper->SetSampleDistance(0.0);
    scene.Mapper->SetRayStartOffset(0.0);
    scene.Window->SetSize(48, 48);
    scene.Renderer->ResetCamera();
  }
}

std::vector<Call> GetCalls()
{
  return { [](Scene& scene, Dice& dice) { scene.Mapper->SetInputData(MakeImage(dice)); },
    [](Scene& scene, Dice& dice)
    {
      if (dice.Chance(0.2))
      {
        scene.Mapper->SetInputConnection(nullptr);
      }
    },
    EditOpacity, EditColor, EditProperty, EditLight, ModifyInPlace, SetMask, Clip, MoveCamera,
    ChangeWindow,
    [](Scene& scene, Dice& dice) {
      scene.Mapper->SetBlockSize(dice.OneOf({ 17, 33, 65, 16, 0, -3 }));
    },
    [](Scene& scene, Dice& dice)
    { scene.Mapper->SetMaxMemoryInBytes(static_cast<vtkTypeInt64>(dice.Power(0.0, 8.0))); },
    [](Scene& scene, Dice& dice) {
      scene.Mapper->SetAtlasPrecision(dice.OneOf({ 0, 1, 4, 8, 3 }));
    },
    [](Scene& scene, Dice& dice)
    { scene.Mapper->SetUploadBytesPerFrame(static_cast<vtkTypeInt64>(dice.Power(0.0, 8.0))); },
    [](Scene& scene, Dice& dice)
    { scene.Mapper->SetPointOfInterest(dice.Between(-9.0, 50.0), 3.0, std::nan("")); },
    [](Scene& scene, Dice& dice)
    { scene.Mapper->SetCurvatureRange(dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0)); },
    [](Scene& scene, Dice&) { scene.Mapper->GetTotalDistortion(); },
    [](Scene& scene, Dice&)
    {
      vtkNew<vtkImageData> image;
      scene.Mapper->GetColorImage(image);
      scene.Mapper->GetDepthImage(image);
    },
    [](Scene& scene, Dice&)
    {
      std::ostringstream text;
      scene.Mapper->Print(text);
    },
    Of(&Mapper::SetBlendMode, 0, 6), Of(&Mapper::SetNumberOfLevels, 1, 7),
    Of(&Mapper::SetLevelFilter, 0, 1), Of(&Mapper::SetSelectionCriterion, 0, 2),
    Of(&Mapper::SetDistortionBackend, 0, 3), Of(&Mapper::SetDistortionEstimate, 0, 1),
    Of(&Mapper::SetNumberOfThreads, 0, 3), Of(&Mapper::SetDistortionBlocksPerFrame, 1, 20),
    Of(&Mapper::SetClassification, 0, 2), Of(&Mapper::SetSkipping, 0, 2),
    Of(&Mapper::SetReconstructionFilter, 0, 1), Of(&Mapper::SetStillReconstructionFilter, -1, 1),
    Of(&Mapper::SetCurvatureFunction, 0, 9), Of(&Mapper::SetVectorMode, 0, 2),
    Of(&Mapper::SetVectorComponent, 0, 8), Of(&Mapper::SetMaskType, 0, 1),
    Of(&Mapper::SetScalarMode, 0, 4), Of(&Mapper::SetMaximumNumberOfSamples, 0, 100),
    OfFlag(&Mapper::SetRenderToImage), OfFlag(&Mapper::SetInterpolatingBSpline),
    OfFlag(&Mapper::SetDerivativesOnDemand), OfFlag(&Mapper::SetComputeNormalFromOpacity),
    OfFlag(&Mapper::SetAdaptiveImageSampling), OfFlag(&Mapper::SetAutoAdjustSampleDistances),
    OfFlag(&Mapper::SetLockSampleDistanceToInputSpacing), OfFlag(&Mapper::SetUseJittering),
    OfFlag(&Mapper::SetAdaptiveSampling), OfFlag(&Mapper::SetHomogeneousLeaps),
    OfFlag(&Mapper::SetProfiling), OfFlag(&Mapper::SetCountSamples),
    OfFlag(&Mapper::SetDistortionPerByte), OfFlag(&Mapper::SetVisibilityWeighting),
    OfFlag(&Mapper::SetUseCameraAsPointOfInterest), OfFlag(&Mapper::SetProgressiveStills),
    OfFlag(&Mapper::SetInterblockContinuity), OfReal(&Mapper::SetSilhouetteWidth, 0.0, 3.0),
    OfReal(&Mapper::SetShadingOpacityThreshold, 0.0, 1.0),
    OfReal(&Mapper::SetSampleDistance, 0.0, 5.0),
    OfReal(&Mapper::SetSampleDistanceInVoxels, 0.2, 5.0),
    OfReal(&Mapper::SetImageSamplingTolerance, 0.0, 1.0),
    OfReal(&Mapper::SetImageSampleDistance, 0.5, 5.0), OfReal(&Mapper::SetRayStartOffset, 0.0, 5.0),
    OfReal(&Mapper::SetEarlyTerminationThreshold, 0.5, 1.0),
    OfReal(&Mapper::SetVariationTolerance, 0.0, 10.0),
    OfReal(&Mapper::SetMaskBlendFactor, 0.0, 1.0),
    OfReal(&Mapper::SetRefinementFraction, 0.0, 1.0) };
}
} // namespace

TEST(RandomCalls, DoNoHarm)
{
  const int calls = GetNumber("FLATBLOCK_RANDOM_CALLS", 600);
  const auto seed = static_cast<unsigned>(GetNumber("FLATBLOCK_RANDOM_SEED", 1));
  const std::vector<Call> all = GetCalls();
  Dice dice(seed);
  Scene scene;
  scene.Window->SetSize(48, 48);
  scene.SetVolume(MakeWaves(), 0.5);
  scene.SetRamp(50.0, 950.0, 0.2);
  int frames = 0;
  int drawn = 0;
  const Messages messages = Listen(
    [&]
    {
      for (int i = 0; i < calls; ++i)
      {
        all[dice.Below(static_cast<int>(all.size()))](scene, dice);
        if (dice.Chance(0.4))
        {
          if (dice.Chance(0.8))
          {
            Relent(scene, dice);
          }
          scene.Window->Render();
          ++frames;
          drawn += ShowsSomething(Grab(scene.Window)) ? 1 : 0;
          EXPECT_LE(scene.Mapper->GetMemoryInBytes(), scene.Mapper->GetMaxMemoryInBytes())
            << "call " << i;
        }
      }
    });
  EXPECT_GT(drawn, frames / 3); // of what is transparent, clipped or as small as a pixel nothing
  std::cout << drawn << " of " << frames << " frames show something, " << messages.Errors.size()
            << " errors\n";
  for (const std::string& error : messages.Errors)
  {
    EXPECT_EQ(error.find("shader"), std::string::npos) << error;
  }
  // After all of it a good volume is drawn as by a new mapper.
  Scene fresh;
  Scene* scenes[] = { &scene, &fresh };
  vtkNew<vtkFlatBlockVolumeMapper> defaults;
  scene.Mapper->ShallowCopy(defaults);
  scene.Volume->SetProperty(fresh.Property);
  scene.Window->SetSize(256, 256);
  const auto good = MakeWaves();
  vtkSmartPointer<vtkImageData> pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    scenes[i]->Window->SetDesiredUpdateRate(0.001);
    scenes[i]->SetVolume(good, 0.5);
    scenes[i]->Renderer->GetActiveCamera()->DeepCopy(vtkNew<vtkCamera>());
  }
  fresh.SetRamp(50.0, 950.0, 0.2);
  for (int i = 0; i < 2; ++i)
  {
    scenes[i]->LookFrom(30.0, 20.0);
    pictures[i] = scenes[i]->Draw();
  }
  ASSERT_TRUE(ShowsSomething(pictures[1]));
  EXPECT_EQ(LargestDifference(pictures[0], pictures[1]), 0.0);
}
