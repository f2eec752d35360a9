// Levels of detail on the way to the graphics card, and what they show. Needs a display.
#include "vtk_glew.h"

#include "CtLike.h"
#include "Rendering.h"
#include "Volumes.h"

#include "vtkImageAppend.h"
#include "vtkImageReader2.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <utility>
#include <vector>

using namespace flatblock::testing;

namespace
{
// n^3 samples of 16 bit, all of them visible.
vtkSmartPointer<vtkImageData> MakeLarge(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  auto* samples = static_cast<std::uint16_t*>(image->GetScalarPointer());
#pragma omp parallel for
  for (int z = 0; z < n; ++z)
  {
    std::uint16_t* slice = samples + std::int64_t(z) * n * n;
    for (std::int64_t i = 0; i < std::int64_t(n) * n; ++i)
    {
      slice[i] = static_cast<std::uint16_t>(30000 + (i * 40503U + z * 9973U) % 5000);
    }
  }
  return image;
}

void ShowLarge(Scene& scene, vtkImageData* image, vtkTypeInt64 limit)
{
  scene.SetRamp(20000.0, 40000.0, 0.01);
  scene.SetVolume(image, 4.0);
  scene.Mapper->SetMaxMemoryInBytes(limit);
  scene.LookFrom(30.0, 20.0);
}

void PlainMinMax(benchmark::State& state)
{
  const auto image = MakeLarge(static_cast<int>(state.range(0)));
  const auto* samples = static_cast<std::uint16_t*>(image->GetScalarPointer());
  const vtkIdType count = image->GetNumberOfPoints();
  for ([[maybe_unused]] auto _ : state)
  {
    std::uint16_t lowest = 65535;
    std::uint16_t highest = 0;
#pragma omp parallel for simd reduction(min : lowest) reduction(max : highest)
    for (vtkIdType i = 0; i < count; ++i)
    {
      lowest = std::min(lowest, samples[i]);
      highest = std::max(highest, samples[i]);
    }
    benchmark::DoNotOptimize(lowest);
    benchmark::DoNotOptimize(highest);
  }
  state.SetBytesProcessed(state.iterations() * count * 2);
}
BENCHMARK(PlainMinMax)->Arg(1024)->UseRealTime()->Unit(benchmark::kMillisecond);

std::int64_t GetPeakResidentBytes()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word && word != "VmHWM:")
  {
  }
  std::int64_t kilobytes = 0;
  status >> kilobytes;
  return kilobytes * 1024;
}

// From SetInputData to the first draw call, with levels for 128 MiB; and the most main memory that
// this takes beside the volume and what a software OpenGL holds there, as a share of the volume: to
// be read where this benchmark runs alone and once.
void FirstDraw(benchmark::State& state)
{
  const auto image = MakeLarge(static_cast<int>(state.range(0)));
  const vtkTypeInt64 limit = vtkTypeInt64(128) << 20;
  Scene scene;
  scene.Volume->VisibilityOff();
  scene.Window->Render();
  scene.Volume->VisibilityOn();
  const std::int64_t before = GetPeakResidentBytes();
  for ([[maybe_unused]] auto _ : state)
  {
    image->Modified();
    ShowLarge(scene, image, limit);
    scene.Window->Render();
    state.SetIterationTime(
      1e-3 * (scene.Mapper->GetRangeMilliseconds() + scene.Mapper->GetSelectionMilliseconds() +
               scene.Mapper->GetUploadMilliseconds()));
    state.counters["ranges_ms"] = scene.Mapper->GetRangeMilliseconds();
    state.counters["selection_ms"] = scene.Mapper->GetSelectionMilliseconds();
    state.counters["upload_ms"] = scene.Mapper->GetUploadMilliseconds();
  }
  const std::int64_t extra = GetPeakResidentBytes() - before - scene.Mapper->GetPeakMemoryInBytes();
  state.counters["extra_memory_percent"] =
    100.0 * double(extra) / (2.0 * double(image->GetNumberOfPoints()));
}
BENCHMARK(FirstDraw)->Arg(1024)->UseManualTime()->Unit(benchmark::kMillisecond);

// As many bricks as FullRefinement sends, from one that lies ready, to a texture that is new too:
// the first touch of its memory is part of both.
void PlainTexSubImage(benchmark::State& state)
{
  constexpr int Side = 33;
  constexpr int Along = 16;
  const int bricks = Along * Along * Along;
  Scene scene;
  scene.Volume->VisibilityOff();
  scene.Window->Render();
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->MakeCurrent();
  const int side = Along * Side;
  const std::vector<std::uint16_t> brick(Side * Side * Side, 7);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for ([[maybe_unused]] auto _ : state)
  {
    unsigned int texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_3D, texture);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R16, side, side, side, 0, GL_RED, GL_UNSIGNED_SHORT, nullptr);
    for (int i = 0; i < bricks; ++i)
    {
      glTexSubImage3D(GL_TEXTURE_3D, 0, i % Along * Side, i / Along % Along * Side,
        i / (Along * Along) * Side, Side, Side, Side, GL_RED, GL_UNSIGNED_SHORT, brick.data());
    }
    glFinish();
    glDeleteTextures(1, &texture);
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  state.SetBytesProcessed(state.iterations() * bricks * std::int64_t(brick.size()) * 2);
}
BENCHMARK(PlainTexSubImage)->UseRealTime()->Unit(benchmark::kMillisecond);

// All 4096 bricks of a 513^3 volume, 281 MiB.
void FullRefinement(benchmark::State& state)
{
  const auto image = MakeLarge(513);
  Scene scene;
  ShowLarge(scene, image, vtkTypeInt64(400) << 20);
  std::int64_t bytes = 0;
  for ([[maybe_unused]] auto _ : state)
  {
    scene.Mapper->ReleaseGraphicsResources(scene.Window);
    scene.Window->Render();
    state.SetIterationTime(1e-3 * scene.Mapper->GetUploadMilliseconds());
    bytes += scene.Mapper->GetUploadedBytes();
  }
  state.SetBytesProcessed(bytes);
}
BENCHMARK(FullRefinement)->UseManualTime()->Unit(benchmark::kMillisecond);

// A point of interest that moves on by a block, in interactive frames or in stills: all that comes
// before drawing.
void PointOfInterestMoves(benchmark::State& state, double updateRate)
{
  const auto image = MakeLarge(513);
  Scene scene;
  ShowLarge(scene, image, vtkTypeInt64(128) << 20);
  scene.Mapper->UseCameraAsPointOfInterestOff();
  scene.Mapper->SetPointOfInterest(-100.0, 250.0, 250.0);
  scene.Window->Render();
  scene.Window->SetDesiredUpdateRate(updateRate);
  double x = -100.0;
  double uploaded = 0.0;
  double moved = 0.0;
  for ([[maybe_unused]] auto _ : state)
  {
    x = x > 500.0 ? -100.0 : x + 32.0;
    scene.Mapper->SetPointOfInterest(x, 250.0, 250.0);
    scene.Window->Render();
    state.SetIterationTime(
      1e-3 * (scene.Mapper->GetSelectionMilliseconds() + scene.Mapper->GetUploadMilliseconds()));
    uploaded += double(scene.Mapper->GetUploadedBytes()) / (1 << 20);
    moved += double(scene.Mapper->GetMovedBytes()) / (1 << 20);
  }
  const auto mean = benchmark::Counter::kAvgIterations;
  state.counters["uploaded_MiB"] = benchmark::Counter(uploaded, mean);
  state.counters["moved_MiB"] = benchmark::Counter(moved, mean);
  state.counters["selection_ms"] = scene.Mapper->GetSelectionMilliseconds();
}
BENCHMARK_CAPTURE(PointOfInterestMoves, interactive, 15.0)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(PointOfInterestMoves, still, 0.0001)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond);

// 512 x 512 x 1734 samples like a CT, 256 MiB, levels by distortion.
class LiveEdit
{
public:
  LiveEdit()
  {
    const std::array<int, 3> n = { 512, 512, 1734 };
    const auto samples = flatblock::benchmarks::MakeCtLike(n);
    vtkNew<vtkImageData> image;
    image->SetDimensions(n.data());
    image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
    std::copy(
      samples.begin(), samples.end(), static_cast<std::uint16_t*>(image->GetScalarPointer()));
    this->Shown.SetVolume(image, 4.0);
    this->Shown.SetColor({ { 0.0, 0.9, 0.5, 0.4 }, { 2000.0, 0.9, 0.9, 0.9 } });
    this->Shown.Mapper->SetSelectionCriterionToDistortion();
    this->Shown.Window->SetSize(64, 64);
    this->Edit(0);
    this->Shown.LookFrom(30.0, 20.0);
    this->Shown.Window->Render();
    this->Shown.Window->SetDesiredUpdateRate(15.0);
  }

  // All of the range, or the quarter above bone.
  void Edit(int number, bool onlyQuarter = false)
  {
    const double high = onlyQuarter ? 0.6 + 0.01 * (number % 30) : 0.6;
    const double low = onlyQuarter ? 0.05 : 0.05 + 0.001 * (number % 30);
    this->Shown.SetOpacity({ { 100.0, 0.0 }, { 150.0, low }, { 1400.0, low + 0.1 },
      { 1900.0, high }, { 4000.0, high } });
  }

  Scene Shown;
};

LiveEdit& GetLiveEdit()
{
  static LiveEdit edit;
  return edit;
}

// The first interactive frame after an edit, all but uploads and drawing: the order has changed.
void EditOrders(benchmark::State& state, bool onlyQuarter, int estimate)
{
  LiveEdit& edit = GetLiveEdit();
  vtkFlatBlockVolumeMapper* mapper = edit.Shown.Mapper;
  mapper->SetDistortionEstimate(estimate);
  edit.Shown.Window->SetDesiredUpdateRate(0.0001);
  edit.Shown.Window->Render();
  edit.Shown.Window->SetDesiredUpdateRate(15.0);
  int number = 0;
  for ([[maybe_unused]] auto _ : state)
  {
    edit.Edit(++number, onlyQuarter);
    edit.Shown.Window->Render();
    state.SetIterationTime(
      1e-3 * (mapper->GetRangeMilliseconds() + mapper->GetDistortionMilliseconds() +
               mapper->GetSelectionMilliseconds()));
  }
  state.counters["summary_MiB"] = double(mapper->GetDistortionSummaryBytes()) / (1 << 20);
}

// Until all values are in.
void EditCompletes(benchmark::State& state, bool onlyQuarter)
{
  LiveEdit& edit = GetLiveEdit();
  vtkFlatBlockVolumeMapper* mapper = edit.Shown.Mapper;
  mapper->SetDistortionEstimateToExact();
  edit.Shown.Window->SetDesiredUpdateRate(0.0001);
  edit.Shown.Window->Render();
  int number = 100;
  for ([[maybe_unused]] auto _ : state)
  {
    edit.Edit(++number, onlyQuarter);
    edit.Shown.Window->Render();
    state.SetIterationTime(1e-3 * mapper->GetDistortionMilliseconds());
  }
}
BENCHMARK_CAPTURE(EditOrders, full_exact, false, vtkFlatBlockVolumeMapper::EXACT)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(EditOrders, quarter_exact, true, vtkFlatBlockVolumeMapper::EXACT)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(EditOrders, full_summary, false, vtkFlatBlockVolumeMapper::SUMMARY)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(EditCompletes, full, false)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(EditCompletes, quarter, true)->UseManualTime()->Unit(benchmark::kMillisecond);

// Mean distortion of unrefined blocks of the same volume, by criterion and limit in MiB.
void MeanDistortion(benchmark::State& state)
{
  LiveEdit& edit = GetLiveEdit();
  vtkFlatBlockVolumeMapper* mapper = edit.Shown.Mapper;
  mapper->SetDistortionEstimateToExact();
  mapper->SetSelectionCriterion(static_cast<int>(state.range(0)));
  mapper->SetMaxMemoryInBytes(state.range(1) << 20);
  edit.Shown.Window->SetDesiredUpdateRate(0.0001);
  for ([[maybe_unused]] auto _ : state)
  {
    edit.Shown.Window->Render();
  }
  state.counters["mean"] = mapper->GetMeanDistortionOfUnrefinedBlocks();
  state.counters["total"] = mapper->GetTotalDistortion();
}
BENCHMARK(MeanDistortion)
  ->ArgsProduct({ { vtkFlatBlockVolumeMapper::DISTANCE, vtkFlatBlockVolumeMapper::DISTORTION,
                    vtkFlatBlockVolumeMapper::DISTORTION_AND_DISTANCE },
    { 64, 128, 256 } })
  ->Iterations(1)
  ->Unit(benchmark::kMillisecond);

// Pictures by criterion at a part of the memory, against the full one, over eight views: an MRI, a
// CT skull (matrix.dat out of Cranium.inv3 of Debian's invesalius-examples, which the environment
// variable FLATBLOCK_SKULL names), and a volume like a CT.
struct Subject
{
  vtkSmartPointer<vtkImageData> Image;
  std::vector<std::pair<double, double>> Opacity;
  std::vector<std::array<double, 4>> Color;
};

Subject MakeMRI()
{
  const auto mri = ReadMRI();
  return { mri ? *mri : nullptr, { { 40.0, 0.0 }, { 160.0, 0.3 } },
    { { 40.0, 0.2, 0.4, 0.9 }, { 160.0, 0.9, 0.8, 0.3 } } };
}

Subject MakeSkull()
{
  const char* file = std::getenv("FLATBLOCK_SKULL");
  if (!file)
  {
    return {};
  }
  vtkNew<vtkImageReader2> reader;
  reader->SetFileName(file);
  reader->SetFileDimensionality(3);
  reader->SetDataExtent(0, 255, 0, 255, 0, 107);
  reader->SetDataSpacing(0.957, 0.957, 1.5);
  reader->SetDataScalarTypeToShort();
  reader->SetDataByteOrderToLittleEndian();
  reader->Update();
  return { reader->GetOutput(), { { 200.0, 0.0 }, { 500.0, 0.5 } },
    { { 200.0, 0.8, 0.5, 0.4 }, { 1500.0, 1.0, 1.0, 0.9 } } };
}

Subject MakeCt()
{
  const std::array<int, 3> n = { 192, 192, 192 };
  const auto samples = flatblock::benchmarks::MakeCtLike(n);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n.data());
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  std::copy(samples.begin(), samples.end(), static_cast<std::uint16_t*>(image->GetScalarPointer()));
  return { image, { { 600.0, 0.0 }, { 1000.0, 0.1 }, { 1500.0, 0.6 } },
    { { 600.0, 0.9, 0.5, 0.4 }, { 1900.0, 0.9, 0.9, 0.9 } } };
}

double GetMeanPSNR(const Subject& subject, int criterion, bool perByte, int part)
{
  double sum = 0.0;
  constexpr int Views = 8;
  for (int view = 0; view < Views; ++view)
  {
    Scene scene;
    scene.SetVolume(subject.Image, 0.5);
    scene.SetOpacity(subject.Opacity);
    scene.SetColor(subject.Color);
    scene.Mapper->SetBlockSize(17);
    scene.Mapper->SetSelectionCriterion(criterion);
    scene.Mapper->SetDistortionPerByte(perByte);
    scene.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(1) << 30);
    scene.LookFrom(30.0 + 45.0 * view, 70.0 * std::sin(1.7 * view), 1.2);
    const auto full = scene.Draw();
    scene.Mapper->SetMaxMemoryInBytes(scene.Mapper->GetMemoryInBytes() -
                                      scene.Mapper->GetAtlasBytes() +
                                      scene.Mapper->GetUsedAtlasBytes() / part);
    sum += PSNR(scene.Draw(), full);
  }
  return sum / Views;
}

void PictureByCriterion(benchmark::State& state, Subject (*make)())
{
  const Subject subject = make();
  if (!subject.Image)
  {
    state.SkipWithError("the volume is not here");
    return;
  }
  const int part = static_cast<int>(state.range(0));
  using Mapper = vtkFlatBlockVolumeMapper;
  for ([[maybe_unused]] auto _ : state)
  {
    state.counters["distance_dB"] = GetMeanPSNR(subject, Mapper::DISTANCE, true, part);
    state.counters["distortion_dB"] = GetMeanPSNR(subject, Mapper::DISTORTION, true, part);
    state.counters["both_dB"] = GetMeanPSNR(subject, Mapper::DISTORTION_AND_DISTANCE, true, part);
    state.counters["distortion_largest_first_dB"] =
      GetMeanPSNR(subject, Mapper::DISTORTION, false, part);
  }
}
BENCHMARK_CAPTURE(PictureByCriterion, MRI, MakeMRI)->Arg(8)->Arg(32)->Iterations(1);
BENCHMARK_CAPTURE(PictureByCriterion, skull, MakeSkull)->Arg(8)->Arg(32)->Iterations(1);
BENCHMARK_CAPTURE(PictureByCriterion, CT, MakeCt)->Arg(8)->Arg(32)->Iterations(1);

// The picture at a part of the memory that all bricks take, against the full one. The pictures go
// to levels.png, side by side: full, 1/2, 1/8, 1/32, 1/128.
class PictureStrip
{
public:
  PictureStrip()
  {
    const auto mri = ReadMRI();
    this->Shown.SetVolume(mri ? *mri : MarschnerLobb(257), mri ? 0.5 : 1.0 / 256.0);
    if (mri)
    {
      this->Shown.SetRamp(40.0, 160.0, 0.3);
    }
    else
    {
      ShowShell(this->Shown, 1);
      this->Shown.SetVolume(MarschnerLobb(257), 1.0 / 256.0);
    }
    this->Shown.Mapper->SetBlockSize(17);
    this->Shown.LookFrom(30.0, 20.0, 1.4);
    this->Shown.Mapper->SetMaxMemoryInBytes(vtkTypeInt64(1) << 30);
    this->Full = this->Shown.Draw();
    this->Bricks = this->Shown.Mapper->GetUsedAtlasBytes();
    this->Beside = this->Shown.Mapper->GetMemoryInBytes() - this->Shown.Mapper->GetAtlasBytes();
  }

  double Draw(int part)
  {
    this->Shown.Mapper->SetMaxMemoryInBytes(this->Beside + this->Bricks / part);
    this->Pictures[part] = this->Shown.Draw();
    return PSNR(this->Pictures[part], this->Full);
  }

  void Write() const
  {
    vtkNew<vtkImageAppend> strip;
    strip->SetInputData(this->Full);
    for (const auto& [part, picture] : this->Pictures)
    {
      strip->AddInputData(picture);
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(strip->GetOutputPort());
    writer->SetFileName("levels.png");
    writer->Write();
  }

private:
  Scene Shown;
  vtkSmartPointer<vtkImageData> Full;
  std::map<int, vtkSmartPointer<vtkImageData>> Pictures; // by part of the memory
  vtkTypeInt64 Bricks = 0;
  vtkTypeInt64 Beside = 0;
};

void PictureAtPartOfMemory(benchmark::State& state)
{
  static PictureStrip strip;
  double psnr = 0.0;
  for ([[maybe_unused]] auto _ : state)
  {
    psnr = strip.Draw(static_cast<int>(state.range(0)));
  }
  state.counters["PSNR_dB"] = psnr;
  strip.Write();
}
BENCHMARK(PictureAtPartOfMemory)
  ->Arg(2)
  ->Arg(8)
  ->Arg(32)
  ->Arg(128)
  ->Iterations(1)
  ->Unit(benchmark::kMillisecond);
} // namespace
