#include "Rendering.h"

#include "Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageDifference.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRegressionTestImage.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>

namespace flatblock::testing
{
namespace
{
class MessageCollector : public vtkOutputWindow
{
public:
  static MessageCollector* New();
  vtkTypeMacro(MessageCollector, vtkOutputWindow);

  void DisplayErrorText(const char* text) override { this->Collected.Errors.emplace_back(text); }
  void DisplayGenericWarningText(const char* text) override
  {
    this->Collected.Warnings.emplace_back(text);
  }
  void DisplayWarningText(const char* text) override
  {
    this->Collected.Warnings.emplace_back(text);
  }

  Messages Collected;
};
vtkStandardNewMacro(MessageCollector);

struct Bytes
{
  explicit Bytes(vtkImageData* picture)
    : Array(vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars())),
      Begin(this->Array->GetPointer(0)), Count(this->Array->GetNumberOfValues())
  {
  }
  vtkUnsignedCharArray* Array;
  const unsigned char* Begin;
  vtkIdType Count;
};

struct Difference
{
  double MeanSquare = 255.0 * 255.0; // as between black and white: pictures of unequal sizes
  int Largest = 255;
};

Difference Compare(vtkImageData* a, vtkImageData* b)
{
  const Bytes left(a);
  const Bytes right(b);
  if (left.Count != right.Count)
  {
    return {};
  }
  Difference result{ 0.0, 0 };
  for (vtkIdType i = 0; i < left.Count; ++i)
  {
    const int difference = std::abs(int(left.Begin[i]) - int(right.Begin[i]));
    result.MeanSquare += double(difference) * difference / static_cast<double>(left.Count);
    result.Largest = std::max(result.Largest, difference);
  }
  return result;
}
} // namespace

Scene::Scene()
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(256, 256);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(0.2, 0.3, 0.4);
  this->Renderer->AddVolume(this->Volume);
  this->Volume->SetMapper(this->Mapper);
  this->Volume->SetProperty(this->Property);
  this->Property->SetInterpolationTypeToLinear();
  this->Mapper->AutoAdjustSampleDistancesOff();
  auto peer = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  peer->SetAutoAdjustSampleDistances(0);
  this->Peer = peer;
}

void Scene::SetVolume(vtkImageData* image, double sampleDistance)
{
  this->Mapper->SetInputData(image);
  this->Mapper->SetSampleDistance(sampleDistance);
  this->Peer->SetInputData(image);
  vtkGPUVolumeRayCastMapper::SafeDownCast(this->Peer)
    ->SetSampleDistance(static_cast<float>(sampleDistance));
}

void Scene::SetOpacity(const std::vector<std::pair<double, double>>& points)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& [value, alpha] : points)
  {
    opacity->AddPoint(value, alpha);
  }
  this->Property->SetScalarOpacity(opacity);
}

void Scene::SetColor(const std::vector<std::array<double, 4>>& points)
{
  vtkNew<vtkColorTransferFunction> color;
  for (const auto& [value, r, g, b] : points)
  {
    color->AddRGBPoint(value, r, g, b);
  }
  this->Property->SetColor(color);
}

void Scene::SetRamp(double lowest, double highest, double opacity)
{
  const double middle = 0.5 * (lowest + highest);
  this->SetOpacity({ { lowest, 0.0 }, { highest, opacity } });
  this->SetColor(
    { { lowest, 0.1, 0.2, 0.8 }, { middle, 0.9, 0.8, 0.3 }, { highest, 1.0, 0.2, 0.1 } });
}

void Scene::LookFrom(double azimuth, double elevation, double zoom)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 1.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->Azimuth(azimuth);
  camera->Elevation(elevation);
  camera->OrthogonalizeViewUp();
  this->Renderer->ResetCamera();
  camera->Zoom(zoom);
  this->Renderer->ResetCameraClippingRange();
}

vtkSmartPointer<vtkImageData> Scene::Draw()
{
  this->Volume->SetMapper(this->Mapper);
  this->Window->Render();
  return Grab(this->Window);
}

vtkSmartPointer<vtkImageData> Scene::DrawWithPeer()
{
  this->Volume->SetMapper(this->Peer);
  this->Window->Render();
  auto picture = Grab(this->Window);
  this->Volume->SetMapper(this->Mapper);
  return picture;
}

void ShowShell(Scene& scene, vtkTypeInt64 maxMemoryInBytes)
{
  scene.SetVolume(MarschnerLobb(128), 0.5 * 2.0 / 127.0);
  scene.SetOpacity({ { 90.0, 0.0 }, { 125.0, 0.6 }, { 160.0, 0.0 } });
  scene.SetColor({ { 90.0, 0.2, 0.4, 0.9 }, { 125.0, 0.9, 0.9, 0.7 }, { 160.0, 0.9, 0.3, 0.1 } });
  scene.Property->SetScalarOpacityUnitDistance(0.01);
  scene.Mapper->SetBlockSize(17);
  scene.Mapper->SetMaxMemoryInBytes(maxMemoryInBytes);
  scene.LookFrom(30.0, 40.0, 1.3);
}

vtkTypeInt64 CountBricks(vtkFlatBlockVolumeMapper* mapper)
{
  vtkTypeInt64 bricks = 0;
  for (int level = 0; level < 7; ++level)
  {
    bricks += mapper->GetNumberOfBricks(level);
  }
  return bricks;
}

vtkSmartPointer<vtkImageData> Grab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->DeepCopy(grab->GetOutput());
  return picture;
}

double PSNR(vtkImageData* a, vtkImageData* b)
{
  const double mean = Compare(a, b).MeanSquare;
  return mean > 0.0 ? std::min(200.0, 10.0 * std::log10(255.0 * 255.0 / mean)) : 200.0;
}

double LargestDifference(vtkImageData* a, vtkImageData* b)
{
  return Compare(a, b).Largest;
}

double ShareThatDiffers(vtkImageData* a, vtkImageData* b, int most)
{
  const Bytes first(a);
  const Bytes second(b);
  if (first.Count != second.Count)
  {
    return 1.0;
  }
  vtkIdType different = 0;
  for (vtkIdType pixel = 0; pixel < first.Count; pixel += 3)
  {
    int largest = 0;
    for (int i = 0; i < 3; ++i)
    {
      largest =
        std::max(largest, std::abs(int(first.Begin[pixel + i]) - int(second.Begin[pixel + i])));
    }
    different += largest > most ? 1 : 0;
  }
  return 3.0 * static_cast<double>(different) / static_cast<double>(first.Count);
}

bool ShowsSomething(vtkImageData* picture)
{
  const Bytes bytes(picture);
  vtkIdType different = 0;
  for (vtkIdType i = 3; i < bytes.Count; ++i)
  {
    different += std::abs(int(bytes.Begin[i]) - int(bytes.Begin[i % 3])) > 8 ? 1 : 0;
  }
  return different > bytes.Count / 50;
}

bool MatchesBaseline(vtkRenderWindow* window, const std::string& name)
{
  std::vector<std::string> arguments = { name, "-V",
    std::string(FLATBLOCK_BASELINES) + "/" + name + ".png", "-T", FLATBLOCK_TEMPORARY };
  std::vector<char*> argv;
  for (std::string& argument : arguments)
  {
    argv.push_back(argument.data());
  }
  const auto argc = static_cast<int>(argv.size());
  return vtkTesting::Test(argc, argv.data(), window, 0.15) == vtkTesting::PASSED;
}

Messages Listen(const std::function<void()>& action)
{
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkNew<MessageCollector> collector;
  vtkOutputWindow::SetInstance(collector);
  action();
  vtkOutputWindow::SetInstance(before);
  return collector->Collected;
}
} // namespace flatblock::testing
