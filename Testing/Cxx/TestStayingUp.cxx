// What programs do to volumes and windows that are being drawn, and the surroundings they run in.
#include "Rendering.h"
#include "Volumes.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkWeakPointer.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <thread>

using namespace flatblock::testing;

namespace
{
void Prepare(Scene& scene, vtkImageData* image)
{
  scene.SetVolume(image, 0.5);
  scene.SetRamp(50.0, 950.0, 0.2);
  scene.Mapper->SetBlockSize(17);
  scene.LookFrom(30.0, 20.0);
}

vtkSmartPointer<vtkImageData> DrawAnew(vtkImageData* image)
{
  Scene scene;
  Prepare(scene, image);
  return scene.Draw();
}

void Halve(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetComponent(i, 0, 0.5 * scalars->GetComponent(i, 0));
  }
}

// Calls a function at the first progress of a frame.
void OnProgress(Scene& scene, std::function<void()>& action)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&action);
  command->SetCallback([](vtkObject*, unsigned long, void* data, void*)
    { (*static_cast<std::function<void()>*>(data))(); });
  scene.Mapper->AddObserver(vtkCommand::ProgressEvent, command);
  scene.Window->AddObserver(vtkCommand::AbortCheckEvent, command);
}
} // namespace

TEST(StayingUp, WindowsAreLostAndMadeAgain)
{
  Scene scene;
  Prepare(scene, MakeWaves());
  const auto before = scene.Draw();
  ASSERT_TRUE(ShowsSomething(before));
  for (int i = 0; i < 3; ++i)
  {
    scene.Window->Finalize();
    EXPECT_EQ(LargestDifference(before, scene.Draw()), 0.0);
  }
}

TEST(StayingUp, InputsMayGoWhileTheyAreDrawn)
{
  Scene scene;
  Prepare(scene, MakeWaves());
  scene.Draw();
  auto large = MakeVolume({ 200, 200, 200 }, VTK_FLOAT, WavesAt);
  const vtkWeakPointer<vtkImageData> watched(large);
  scene.Mapper->SetInputData(large);
  int times = 0;
  std::function<void()> action = [&]
  {
    ++times;
    scene.Mapper->SetInputConnection(nullptr);
    large = nullptr;
  };
  OnProgress(scene, action);
  Listen([&] { scene.Draw(); });
  EXPECT_GT(times, 0);
  Listen([&] { scene.Draw(); });
  const auto good = MakeWaves();
  scene.Mapper->RemoveAllObservers();
  scene.Window->RemoveObservers(vtkCommand::AbortCheckEvent);
  scene.Mapper->SetInputData(good);
  EXPECT_EQ(LargestDifference(DrawAnew(good), scene.Draw()), 0.0);
  EXPECT_FALSE(watched);
}

TEST(StayingUp, InputsModifiedInPlaceAreSeenOnceTheySaySo)
{
  const auto image = MakeWaves();
  Scene scene;
  Prepare(scene, image);
  const auto before = scene.Draw();
  Halve(image);
  // Unsaid: whatever is drawn is the data of then or of now.
  EXPECT_EQ(LargestDifference(before, scene.Draw()), 0.0);
  scene.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(1) << 20);
  EXPECT_TRUE(ShowsSomething(scene.Draw()));
  scene.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(256) << 20);
  image->GetPointData()->GetScalars()->Modified();
  const auto after = scene.Draw();
  EXPECT_GT(LargestDifference(before, after), 0.0);
  EXPECT_EQ(LargestDifference(DrawAnew(image), after), 0.0);
}

TEST(StayingUp, ScalarsMayBeExchangedUnsaid)
{
  const auto image = MakeWaves();
  Scene scene;
  Prepare(scene, image);
  scene.Draw();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const vtkIdType samples = scalars->GetNumberOfTuples();
  scalars->SetNumberOfTuples(10 * samples); // which may move them
  scalars->Fill(500.0);
  scalars->SetNumberOfTuples(samples);
  scalars->Squeeze();
  Listen([&] { EXPECT_TRUE(ShowsSomething(scene.Draw())); });
  scalars->Initialize();
  EXPECT_EQ(Listen([&] { scene.Draw(); }).Errors.size(), 1U);
}

TEST(StayingUp, OneInputIsDrawnInTwoWindows)
{
  const auto image = MakeWaves();
  Scene first;
  Scene second;
  Prepare(first, image);
  Prepare(second, image);
  const auto before = first.Draw();
  EXPECT_EQ(LargestDifference(before, second.Draw()), 0.0);
  for (int i = 0; i < 3; ++i)
  {
    Halve(image);
    image->GetPointData()->GetScalars()->Modified();
    const auto picture = first.Draw();
    EXPECT_GT(LargestDifference(before, picture), 0.0);
    EXPECT_EQ(LargestDifference(picture, second.Draw()), 0.0);
  }
}

// Beside one that stays: where threads at once close the last window and open the first, Mesa's
// driver may crash, whatever is drawn.
TEST(StayingUp, ThreadsEachOwnAWindow)
{
  constexpr int Threads = 4;
  Scene scene;
  Prepare(scene, MakeWaves());
  const auto expected = scene.Draw();
  double differences[Threads];
  std::vector<std::thread> threads;
  threads.reserve(Threads);
  for (int i = 0; i < Threads; ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        differences[i] = 0.0;
        for (int round = 0; round < 5; ++round)
        {
          differences[i] =
            std::max(differences[i], LargestDifference(expected, DrawAnew(MakeWaves())));
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const double difference : differences)
  {
    EXPECT_EQ(difference, 0.0);
  }
}

namespace
{
// German numbers, in C and in C++, while one exists.
class DecimalCommas
{
public:
  DecimalCommas()
  {
    const std::string folder = (std::filesystem::temp_directory_path() / "locale ü").string();
    std::filesystem::create_directories(folder);
    const std::string make =
      "env -u LD_PRELOAD localedef -i de_DE -f UTF-8 '" + folder + "/de_DE.UTF-8'";
    setenv("LOCPATH", folder.c_str(), 1);
    this->Present = std::system(make.c_str()) == 0 && std::setlocale(LC_ALL, "de_DE.UTF-8");
    if (this->Present)
    {
      std::locale::global(std::locale("de_DE.UTF-8"));
    }
  }
  ~DecimalCommas()
  {
    std::locale::global(std::locale::classic());
    unsetenv("LOCPATH");
  }
  DecimalCommas(const DecimalCommas&) = delete;
  DecimalCommas& operator=(const DecimalCommas&) = delete;
  bool IsPresent() const { return this->Present; }

private:
  bool Present = false;
};

// All that writes numbers into shaders.
vtkSmartPointer<vtkImageData> DrawMuch()
{
  Scene scene;
  Prepare(scene, MakeWaves());
  scene.Property->ShadeOn();
  scene.Mapper->SetReconstructionFilterToCubicBSpline();
  scene.Mapper->SetCurvatureFunctionToMean();
  scene.Mapper->SetSilhouetteWidth(1.5);
  return scene.Draw();
}
} // namespace

TEST(StayingUp, DecimalCommasDoNotMatter)
{
  const auto before = DrawMuch();
  ASSERT_TRUE(ShowsSomething(before));
  const DecimalCommas commas;
  if (!commas.IsPresent())
  {
    GTEST_SKIP() << "localedef knows no German here";
  }
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "%.1f", 0.5);
  ASSERT_STREQ(text.data(), "0,5");
  EXPECT_EQ(LargestDifference(before, DrawMuch()), 0.0);
}
