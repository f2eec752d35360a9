// Draws a volume file with vtkFlatBlockVolumeMapper, to a picture or in a window.
#include "OneLine.h"
#include "Options.h"
#include "Presets.h"
#include "ReadVolume.h"
#include "ReaderGuard.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkFlatBlockVolumeMapper.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <vector>

namespace
{
constexpr double MiB = 1024.0 * 1024.0;

void Say(const std::string& text)
{
  std::cerr << "FlatBlockView: " << ToOneLine(text) << std::endl;
}

// What VTK says, each on a line.
class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);
  void DisplayErrorText(const char* text) override { this->DisplayText(text); }
  void DisplayWarningText(const char* text) override { this->DisplayText(text); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayText(text); }
  void DisplayText(const char* text) override { Say(StripError(text)); }
};
vtkStandardNewMacro(Messages);

struct Viewer
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkFlatBlockVolumeMapper> Mapper;
};

void SetUp(Viewer& viewer, const Options& options)
{
  viewer.Window->SetSize(options.Size[0], options.Size[1]);
  viewer.Window->SetWindowName("FlatBlockView");
  viewer.Window->SetOffScreenRendering(options.Interactive ? 0 : 1);
  viewer.Window->AddRenderer(viewer.Renderer);
  viewer.Renderer->SetBackground(0.05, 0.06, 0.08);
  viewer.Renderer->SetBackground2(0.25, 0.28, 0.32);
  viewer.Renderer->GradientBackgroundOn();
  viewer.Mapper->SetBlockSize(options.BlockSize);
  viewer.Mapper->SetSampleDistance(options.SampleDistance);
  viewer.Mapper->SetMaxMemoryInBytes(static_cast<vtkTypeInt64>(options.MemoryMiB * MiB));
  viewer.Volume->SetMapper(viewer.Mapper);
  viewer.Volume->SetProperty(viewer.Property);
  viewer.Window->Render(); // the window's own start is not the mapper's time
}

// From the front and a little to the side and above, head up.
void LookAtVolume(Viewer& viewer, bool isAnatomical)
{
  vtkCamera* camera = viewer.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, isAnatomical ? 1.0 : -1.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->Azimuth(35.0);
  camera->Elevation(20.0);
  viewer.Renderer->ResetCamera();
  camera->Zoom(1.3);
  viewer.Renderer->ResetCameraClippingRange();
}

double SecondsToDraw(Viewer& viewer)
{
  const auto start = std::chrono::steady_clock::now();
  viewer.Window->Render();
  viewer.Window->WaitForCompletion();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double MedianSecondsToDraw(Viewer& viewer)
{
  std::vector<double> seconds(5);
  std::generate(seconds.begin(), seconds.end(), [&viewer] { return SecondsToDraw(viewer); });
  std::nth_element(seconds.begin(), seconds.begin() + 2, seconds.end());
  return seconds[2];
}

std::string WritePicture(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  // Beside it first: a former picture stays where the disk is full.
  const std::string unfinished = file + ".part";
  vtkNew<vtkPNGWriter> writer;
  vtkNew<vtkCallbackCommand> silence; // it says in two lines what follows in one
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  writer->AddObserver(vtkCommand::ErrorEvent, silence);
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(unfinished.c_str());
  writer->Write();
  std::error_code problem;
  if (writer->GetErrorCode() == 0)
  {
    std::filesystem::rename(unfinished, file, problem);
  }
  if (writer->GetErrorCode() != 0 || problem)
  {
    std::filesystem::remove(unfinished, problem);
    throw std::runtime_error("'" + file + "' could not be written.");
  }
  return std::filesystem::absolute(file).string();
}

void PrintRow(const char* name, const std::string& value)
{
  std::cout << std::left << std::setw(24) << name << value << "\n";
}

std::string Format(double number, int digits, const char* unit)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << number << unit;
  return text.str();
}

void PrintVolume(vtkImageData* image)
{
  int n[3];
  image->GetDimensions(n);
  const double bytes = static_cast<double>(image->GetNumberOfPoints()) * image->GetScalarSize();
  PrintRow("dimensions",
    std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]));
  PrintRow("scalar type", image->GetScalarTypeAsString());
  PrintRow("volume", Format(bytes / MiB, 1, " MiB"));
}

void PrintMapper(const Viewer& viewer)
{
  PrintRow("blocks", std::to_string(viewer.Mapper->GetNumberOfBlocks()) + ", visible " +
                       std::to_string(viewer.Mapper->GetNumberOfVisibleBlocks()));
  std::ostringstream levels;
  for (int level = 0; level < 7; ++level)
  {
    levels << (level == 0 ? "" : " ") << viewer.Mapper->GetNumberOfBricks(level);
  }
  PrintRow("blocks by level", levels.str());
  PrintRow("atlas", Format(viewer.Mapper->GetAtlasBytes() / MiB, 1, " MiB"));
  PrintRow("graphics memory", Format(viewer.Mapper->GetMemoryInBytes() / MiB, 1, " MiB"));
}

void ShowMemoryInTitle(vtkObject*, unsigned long, void* data, void*)
{
  auto* viewer = static_cast<Viewer*>(data);
  const std::string title =
    "FlatBlockView - " + Format(viewer->Mapper->GetMemoryInBytes() / MiB, 1, " MiB");
  if (title != viewer->Window->GetWindowName())
  {
    viewer->Window->SetWindowName(title.c_str());
  }
}

void Interact(Viewer& viewer)
{
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetRenderWindow(viewer.Window);
  interactor->SetInteractorStyle(style);
  vtkNew<vtkCallbackCommand> title;
  title->SetCallback(ShowMemoryInTitle);
  title->SetClientData(&viewer);
  viewer.Window->AddObserver(vtkCommand::EndEvent, title);
  interactor->Initialize();
  viewer.Window->Render();
  interactor->Start();
}

void Run(const Options& options)
{
  const LoadedVolume loaded = ReadVolume(options);
  PrintVolume(loaded.Image);
  Viewer viewer;
  SetUp(viewer, options);

  std::string error; // the first one
  vtkNew<vtkCallbackCommand> onError;
  onError->SetCallback(
    [](vtkObject*, unsigned long, void* data, void* text)
    {
      auto* first = static_cast<std::string*>(data);
      *first = first->empty() ? static_cast<const char*>(text) : *first;
    });
  onError->SetClientData(&error);
  viewer.Mapper->AddObserver(vtkCommand::ErrorEvent, onError);

  viewer.Mapper->SetInputData(loaded.Image);
  viewer.Volume->SetUserMatrix(loaded.Anatomy);
  ApplyPreset(options.Preset, loaded.Image, viewer.Property);
  viewer.Renderer->AddVolume(viewer.Volume);
  LookAtVolume(viewer, loaded.Anatomy != nullptr);
  const double first = SecondsToDraw(viewer);
  if (!error.empty())
  {
    throw std::runtime_error("'" + options.File + "' could not be drawn: " + StripError(error));
  }
  PrintMapper(viewer);
  PrintRow("seconds to first frame", Format(first, 3, ""));
  PrintRow("seconds a frame", Format(MedianSecondsToDraw(viewer), 3, ""));
  PrintRow("picture", WritePicture(viewer.Window, options.Output));
  std::cout << std::flush;
  if (options.Interactive)
  {
    Interact(viewer);
  }
}
int Draw(const Options& options)
{
  try
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // says it once more
    vtkOutputWindow::SetInstance(vtkNew<Messages>());
    Run(options);
  }
  catch (const std::exception& problem)
  {
    Say(problem.what());
    return 1;
  }
  return 0;
}

int SayHowItDied(const Options& options, int signal, bool wasReading)
{
  if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
  {
    return 1; // as a person wished
  }
  Say("'" + options.File + "' could not be " +
      (wasReading ? "read: VTK's reader " : "drawn: the program ") +
      (signal == SIGPROF ? "came to no end" : "crashed") + " (" + strsignal(signal) + ").");
  return 1;
}
} // namespace

int main(int argc, char* argv[])
{
  Options options;
  try
  {
    options = ParseOptions(argc, argv);
  }
  catch (const std::exception& problem)
  {
    Say(problem.what());
    return 1;
  }
  if (options.Help)
  {
    std::cout << Usage;
    return 0;
  }
  return RunInChild([&options] { return Draw(options); },
    [&options](int signal, bool wasReading) { return SayHowItDied(options, signal, wasReading); });
}
