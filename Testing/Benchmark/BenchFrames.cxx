#include "BenchFrames.h"

#include "BenchMeasure.h"
#include "BenchProgress.h"
#include "BenchText.h"

#include "vtkCamera.h"

#include <stdexcept>

namespace flatblock::benchmarks
{
namespace
{
constexpr int Turn = 30;
constexpr double Degrees = 3.0;
constexpr double InteractiveRate = 15.0;
constexpr double StillRate = 1e-4;

constexpr const char* Head = "scene,frame,kind,milliseconds,bricks,pending_changes,bytes,"
                             "uploaded_bytes,moved_bytes,image_sample_distance\n";

std::string LogFrame(Subject& subject, int frame, const char* kind, double milliseconds)
{
  vtkFlatBlockVolumeMapper* mapper = subject.Shown.Mapper;
  return QuoteCSV(subject.Name) + "," + std::to_string(frame) + "," + kind + "," +
         Fixed(milliseconds, 3) + "," + std::to_string(testing::CountBricks(mapper)) + "," +
         std::to_string(mapper->GetNumberOfPendingChanges()) + "," +
         std::to_string(mapper->GetMemoryInBytes()) + "," +
         std::to_string(mapper->GetUploadedBytes()) + "," +
         std::to_string(mapper->GetMovedBytes()) + "," +
         Exact(mapper->GetUsedImageSampleDistance(), "") + "\n";
}

// As a user has it: the mapper's defaults, and half the memory that its samples take.
void BeginSession(Subject& subject)
{
  subject.Shown.Renderer->SetBackground(0.0, 0.0, 0.0);
  vtkFlatBlockVolumeMapper* mapper = subject.Shown.Mapper;
  mapper->SetSampleDistance(0.0);
  mapper->AutoAdjustSampleDistancesOn();
  mapper->SetMaxMemoryInBytes(vtkTypeInt64(1) << 40);
  subject.Shown.Window->Render();
  const vtkTypeInt64 beside = mapper->GetMemoryInBytes() - mapper->GetAtlasBytes();
  mapper->SetMaxMemoryInBytes(beside + mapper->GetUsedAtlasBytes() / 2);
}

void Play(Subject& subject, std::ofstream& stream, Progress& progress)
{
  BeginSession(subject);
  for (int frame = 0; frame <= Turn; ++frame)
  {
    const bool isStill = frame == Turn;
    progress.Step(subject.Name + ", frame " + std::to_string(frame));
    subject.Shown.Window->SetDesiredUpdateRate(isStill ? StillRate : InteractiveRate);
    if (!isStill)
    {
      subject.Shown.Renderer->GetActiveCamera()->Azimuth(Degrees);
      subject.Shown.Renderer->ResetCameraClippingRange();
    }
    const double taken = TimeFrame(subject.Shown);
    stream << LogFrame(subject, frame, isStill ? "still" : "interactive", taken);
  }
}

void CheckStream(const std::ofstream& stream, const std::string& file)
{
  if (!stream)
  {
    throw std::runtime_error("--frames: cannot write '" + file + "'.");
  }
}
} // namespace

void PlayFrames(const BenchOptions& options, const std::vector<SelectedScene>& scenes)
{
  std::ofstream stream(options.Frames);
  stream << Head << std::flush;
  CheckStream(stream, options.Frames);
  Progress progress(scenes.size() * (Turn + 1));
  for (const SelectedScene& scene : scenes)
  {
    progress.BeginScene(scene.Scene.Name);
    const auto subject = scene.Scene.Make(options);
    if (subject)
    {
      subject->Shown.Window->SetSize(options.Window, options.Window);
      Play(*subject, stream, progress);
    }
  }
  progress.End();
  stream.close();
  CheckStream(stream, options.Frames);
}
} // namespace flatblock::benchmarks
