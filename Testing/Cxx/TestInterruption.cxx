// Frames that are stopped, or for which main memory is short: the former picture stays, and the
// next one goes on.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

using namespace flatblock::testing;
using Clock = std::chrono::steady_clock;

namespace
{
// Every block of which differs at all levels, so that everything takes its time.
vtkSmartPointer<vtkImageData> MakeNoise(int n)
{
  return MakeVolume({ n, n, n }, VTK_FLOAT,
    [](int x, int y, int z)
    {
      const unsigned int mixed = (x * 73856093U) ^ (y * 19349663U) ^ (z * 83492791U);
      return static_cast<double>(mixed * 2654435761U >> 16U & 1023U);
    });
}

// Twice the scalars, so that components are copies.
vtkSmartPointer<vtkImageData> MakeVectors(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> vectors;
  vectors->SetNumberOfComponents(2);
  vectors->SetNumberOfTuples(scalars->GetNumberOfTuples());
  vectors->CopyComponent(0, scalars, 0);
  vectors->CopyComponent(1, scalars, 0);
  image->GetPointData()->SetScalars(vectors);
  return image;
}

void Prepare(Scene& scene, vtkImageData* image)
{
  scene.SetVolume(image, 1.0);
  scene.SetRamp(300.0, 1023.0, 0.4);
  scene.LookFrom(30.0, 20.0);
}

// What a person sees: of the front buffer.
vtkSmartPointer<vtkImageData> Shown(Scene& scene)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(scene.Window);
  filter->ReadFrontBufferOn();
  filter->ShouldRerenderOff();
  filter->Update();
  return filter->GetOutput();
}

double Since(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Wishes for an end so many milliseconds after a frame began, and measures how long it takes.
struct Stopper
{
  double After = 0.0;
  Clock::time_point Began;
  Clock::time_point Wished;
  bool HasWished = false;
  std::function<void()> Wish;

  static void Answer(vtkObject*, unsigned long, void* data, void*)
  {
    auto* self = static_cast<Stopper*>(data);
    if (!self->HasWished && Since(self->Began) >= self->After)
    {
      self->HasWished = true;
      self->Wished = Clock::now();
      self->Wish();
    }
  }

  // @return milliseconds from when the wish could be known, or -1 where the frame was faster
  double Draw(vtkRenderWindow* window)
  {
    this->HasWished = false;
    this->Began = Clock::now();
    window->Render();
    return this->HasWished ? Since(this->Began) - this->After : -1.0;
  }
};

class Interruption : public ::testing::TestWithParam<bool>
{
protected:
  // Stops by the window's abort check, or else by the mapper's progress.
  void Listen(Stopper& stopper)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(Stopper::Answer);
    command->SetClientData(&stopper);
    if (this->GetParam())
    {
      stopper.Wish = [this] { this->Current.Window->SetAbortRender(1); };
      this->Current.Window->AddObserver(vtkCommand::AbortCheckEvent, command);
    }
    else
    {
      stopper.Wish = [this] { this->Current.Mapper->SetAbortExecute(1); };
      this->Current.Mapper->AddObserver(vtkCommand::ProgressEvent, command);
    }
  }

  // The same mapper in another window.
  void ShowIn(Scene& other)
  {
    vtkNew<vtkVolume> same;
    same->SetMapper(this->Current.Mapper);
    same->SetProperty(this->Current.Property);
    other.Renderer->AddVolume(same);
  }

  Scene Current;
};

constexpr double MostMilliseconds = 100.0;
} // namespace

TEST_P(Interruption, EndsWithinMilliseconds)
{
  Prepare(this->Current, MakeWaves());
  this->Current.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(24) << 20);
  this->Current.Mapper->SetSelectionCriterionToDistortion();
  this->Current.Draw();
  const auto before = Shown(this->Current);
  ASSERT_TRUE(ShowsSomething(before));
  const auto noise = MakeNoise(256);
  this->Current.Mapper->SetInputData(noise);
  Stopper stopper;
  this->Listen(stopper);
  int stopped = 0;
  double longest = 0.0;
  for (stopper.After = 15.0; stopper.After < 4000.0; stopper.After *= 1.7)
  {
    const double taken = stopper.Draw(this->Current.Window);
    if (taken < 0.0 || this->Current.Mapper->GetConverged())
    {
      break;
    }
    ++stopped;
    longest = std::max(longest, taken);
    EXPECT_LT(taken, MostMilliseconds) << "after " << stopper.After;
    EXPECT_EQ(LargestDifference(before, Shown(this->Current)), 0.0) << "after " << stopper.After;
    EXPECT_TRUE(this->Current.Mapper->GetInterrupted());
  }
  EXPECT_GT(stopped, 4);
  RecordProperty("Milliseconds", static_cast<int>(longest));
  stopper.After = 1e9;
  const auto picture = this->Current.Draw();
  Scene fresh;
  Prepare(fresh, noise);
  fresh.LookFrom(30.0, 20.0);
  fresh.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(24) << 20);
  fresh.Mapper->SetSelectionCriterionToDistortion();
  fresh.Renderer->GetActiveCamera()->DeepCopy(this->Current.Renderer->GetActiveCamera());
  fresh.Renderer->ResetCameraClippingRange();
  this->Current.Renderer->ResetCameraClippingRange();
  ASSERT_TRUE(ShowsSomething(picture));
  EXPECT_FALSE(this->Current.Mapper->GetInterrupted());
  EXPECT_EQ(LargestDifference(fresh.Draw(), this->Current.Draw()), 0.0);
}

TEST_P(Interruption, KeepsWhatIsDone)
{
  const auto noise = MakeNoise(160);
  Prepare(this->Current, noise);
  this->Current.Mapper->SetBlockSize(17);
  this->Current.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(8) << 20);
  this->Current.Mapper->SetSelectionCriterionToDistortion();
  Stopper stopper;
  this->Listen(stopper);
  stopper.After = 150.0;
  int frames = 0;
  do
  {
    stopper.Draw(this->Current.Window);
    stopper.After *= 1.1; // for slow machines; what is not kept would take as long each time
    ++frames;
  } while (!this->Current.Mapper->GetConverged() && frames < 100);
  EXPECT_TRUE(this->Current.Mapper->GetConverged());
  EXPECT_TRUE(ShowsSomething(Shown(this->Current)));
}

// What a window shows after a size of which there was no whole picture is none of it.
TEST_P(Interruption, ForgetsPicturesOfOtherSizes)
{
  Prepare(this->Current, MakeWaves());
  this->Current.Renderer->SetBackground(0.2, 0.4, 0.6);
  this->Current.Draw();
  this->Current.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(8) << 20);
  this->Current.Mapper->SetSelectionCriterionToDistortion();
  const int* former = this->Current.Window->GetSize();
  const int size[2] = { former[0], former[1] };
  Stopper stopper;
  this->Listen(stopper);
  for (const int side : { size[0] / 2, size[0] })
  {
    this->Current.Window->SetSize(side, side);
    this->Current.Mapper->SetInputData(MakeNoise(160));
    stopper.After = 2.0;
    ASSERT_GE(stopper.Draw(this->Current.Window), 0.0);
  }
  const auto shown = Shown(this->Current);
  this->Current.Volume->VisibilityOff();
  stopper.After = 1e9;
  EXPECT_EQ(LargestDifference(shown, this->Current.Draw()), 0.0);
}

TEST_P(Interruption, EachWindowKeepsItsPicture)
{
  Prepare(this->Current, MakeWaves());
  const auto before = this->Current.Draw();
  Scene other;
  Prepare(other, MakeWaves());
  other.Renderer->RemoveAllViewProps();
  this->ShowIn(other);
  other.Draw();
  this->Current.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(8) << 20);
  this->Current.Mapper->SetSelectionCriterionToDistortion();
  this->Current.Mapper->SetInputData(MakeNoise(160));
  Stopper stopper;
  this->Listen(stopper);
  for (stopper.After = 10.0; stopper.After < 30.0; stopper.After += 10.0)
  {
    ASSERT_GE(stopper.Draw(this->Current.Window), 0.0);
    EXPECT_TRUE(this->Current.Mapper->GetInterrupted());
    EXPECT_EQ(LargestDifference(before, Shown(this->Current)), 0.0);
  }
}

TEST_P(Interruption, ResourcesMayBeReleasedWhileTheyAreDrawn)
{
  Prepare(this->Current, MakeNoise(160));
  this->Current.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(8) << 20);
  this->Current.Mapper->SetSelectionCriterionToDistortion();
  const auto before = this->Current.Draw();
  Stopper stopper;
  this->Listen(stopper);
  stopper.Wish = [&] { this->Current.Mapper->ReleaseGraphicsResources(this->Current.Window); };
  stopper.After = 30.0;
  this->Current.Mapper->SetInputData(MakeNoise(160));
  ASSERT_GE(stopper.Draw(this->Current.Window), 0.0);
  EXPECT_TRUE(this->Current.Mapper->GetInterrupted());
  EXPECT_EQ(this->Current.Mapper->GetAtlasBytes(), 0);
  EXPECT_EQ(LargestDifference(before, this->Current.Draw()), 0.0);
}

// Observers may draw other windows, even such as show the mapper that is about to draw this one.
TEST_P(Interruption, ObserversMayDrawOtherWindows)
{
  const auto noise = MakeNoise(160);
  Prepare(this->Current, noise);
  this->Current.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(8) << 20);
  this->Current.Mapper->SetSelectionCriterionToDistortion();
  const auto before = this->Current.Draw();
  {
    Scene other;
    Prepare(other, MakeWaves());
    this->ShowIn(other);
    Stopper stopper;
    this->Listen(stopper);
    stopper.Wish = [&] { other.Window->Render(); };
    stopper.After = 30.0;
    this->Current.Mapper->SetInputData(MakeNoise(160));
    ASSERT_GE(stopper.Draw(this->Current.Window), 0.0);
    EXPECT_FALSE(this->Current.Mapper->GetInterrupted());
    EXPECT_TRUE(this->Current.Mapper->GetConverged());
    EXPECT_EQ(LargestDifference(before, Shown(this->Current)), 0.0);
    EXPECT_TRUE(ShowsSomething(Shown(other)));
    this->Current.Window->RemoveObservers(vtkCommand::AbortCheckEvent);
    this->Current.Mapper->RemoveObservers(vtkCommand::ProgressEvent);
  }
  EXPECT_EQ(LargestDifference(before, this->Current.Draw()), 0.0);
}

TEST_P(Interruption, OfOneVolumeIsThatOfTheFrame)
{
  Prepare(this->Current, MakeWaves());
  vtkNew<vtkFlatBlockVolumeMapper> mapper;
  mapper->SetInputData(MakeWaves());
  mapper->SetSampleDistance(1.0);
  vtkNew<vtkVolume> beside;
  beside->SetMapper(mapper);
  beside->SetProperty(this->Current.Property);
  beside->SetPosition(10.0, 20.0, 0.0);
  this->Current.Renderer->AddVolume(beside);
  this->Current.Draw();
  const auto before = Shown(this->Current);
  const auto noise = MakeNoise(160);
  this->Current.Mapper->SetInputData(noise);
  this->Current.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(8) << 20);
  this->Current.Mapper->SetSelectionCriterionToDistortion();
  Stopper stopper;
  this->Listen(stopper);
  stopper.After = 60.0;
  ASSERT_GE(stopper.Draw(this->Current.Window), 0.0);
  EXPECT_FALSE(this->Current.Mapper->GetConverged());
  EXPECT_TRUE(this->Current.Mapper->GetInterrupted());
  EXPECT_FALSE(mapper->GetConverged());
  EXPECT_FALSE(mapper->GetInterrupted());
  EXPECT_EQ(LargestDifference(before, Shown(this->Current)), 0.0);
  stopper.After = 1e9;
  this->Current.Draw();
  EXPECT_TRUE(mapper->GetConverged());
}

INSTANTIATE_TEST_SUITE_P(Of, Interruption, ::testing::Bool(),
  [](const auto& info) { return info.param ? "TheWindow" : "TheMapper"; });

namespace
{
// While one exists, the process gets no more than so many bytes: as by ulimit -v.
class AddressSpaceLimit
{
public:
  explicit AddressSpaceLimit(std::uintmax_t more)
  {
    std::uintmax_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    getrlimit(RLIMIT_AS, &this->Former);
    rlimit limit = this->Former;
    limit.rlim_cur = pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE)) + more;
    setrlimit(RLIMIT_AS, &limit);
  }
  ~AddressSpaceLimit() { setrlimit(RLIMIT_AS, &this->Former); }
  AddressSpaceLimit(const AddressSpaceLimit&) = delete;
  AddressSpaceLimit& operator=(const AddressSpaceLimit&) = delete;

private:
  rlimit Former = {};
};
} // namespace

// With room for less and less of what the tables take: each either draws or says so.
TEST(MainMemory, ShortageKeepsTheFormerPicture)
{
  mallopt(M_MMAP_THRESHOLD, 1 << 17); // what is freed goes back, and is not had once more
  const auto noise = MakeVectors(MakeNoise(128));
  int refused = 0;
  for (std::uintmax_t room = std::uintmax_t(24) << 20; room > 1 << 16; room /= 4)
  {
    Scene scene;
    Prepare(scene, MakeWaves());
    scene.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(6) << 20);
    scene.Mapper->SetBlockSize(17);
    scene.Mapper->SetSelectionCriterionToDistortion();
    scene.Mapper->SetDistortionEstimate(vtkFlatBlockVolumeMapper::SUMMARY);
    scene.Draw();
    const auto before = Shown(scene);
    scene.Mapper->SetInputData(noise);
    scene.Mapper->SetVectorMode(vtkFlatBlockVolumeMapper::COMPONENT);
    scene.Mapper->SetVectorComponent(1);
    const Messages messages = Listen(
      [&]
      {
        const AddressSpaceLimit limit(room);
        scene.Window->Render();
        scene.Window->Render();
      });
    if (messages.Errors.empty())
    {
      continue;
    }
    ++refused;
    ASSERT_EQ(messages.Errors.size(), 1U) << ::testing::PrintToString(messages.Errors);
    EXPECT_NE(messages.Errors[0].find("not enough main memory"), std::string::npos)
      << messages.Errors[0];
    EXPECT_EQ(LargestDifference(before, Shown(scene)), 0.0);
    EXPECT_TRUE(scene.Mapper->GetFailed());
    EXPECT_FALSE(scene.Mapper->GetInterrupted());
    const auto after = scene.Draw();
    EXPECT_FALSE(scene.Mapper->GetFailed());
    EXPECT_TRUE(scene.Mapper->GetConverged());
    EXPECT_GT(LargestDifference(before, after), 0.0);
  }
  EXPECT_GT(refused, 2);
}
