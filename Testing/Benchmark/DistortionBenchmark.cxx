// Distortion of every block, by each backend; and what an edit of the transfer function costs.
// Volumes of an eighth of 1.5 GB, 867 MB and 652 MB; with --full as the last argument the whole of
// them.
#include "BlockGrid.h"
#include "CtLike.h"
#include "CudaDevice.h"
#include "CudaDistortion.h"
#include "Distortion.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

using flatblock::BlockedVolume;
using flatblock::BlockGrid;
using flatblock::ClassifiedColor;
using flatblock::ClassifiedTable;

namespace
{
// Skin and bone, translucent.
ClassifiedTable MakeTable()
{
  std::vector<ClassifiedColor> colors;
  for (int value = 0; value < 4096; ++value)
  {
    const double opacity = std::clamp((value - 150.0) / 3000.0, 0.0, 1.0);
    const double warm = std::clamp((value - 900.0) / 900.0, 0.0, 1.0);
    colors.push_back(
      flatblock::ToClassifiedColor(0.9, 0.5 + 0.4 * warm, 0.4 + 0.5 * warm, opacity));
  }
  return { 0.0, 4095.0, colors };
}

struct Volume
{
  explicit Volume(const std::array<int, 3>& n)
    : Samples(flatblock::benchmarks::MakeCtLike(n)), Size(n)
  {
  }

  BlockedVolume Cut(int blockSize) const
  {
    const BlockGrid grid(this->Size, blockSize);
    return { this->Size, grid.GetBlocks(), grid.GetCellsPerBlock() };
  }

  std::vector<std::uint16_t> Samples;
  std::array<int, 3> Size;
};

std::vector<std::int64_t> AllBlocks(const BlockedVolume& volume)
{
  std::vector<std::int64_t> blocks(
    std::size_t(volume.Blocks[0]) * volume.Blocks[1] * volume.Blocks[2]);
  std::iota(blocks.begin(), blocks.end(), 0);
  return blocks;
}

// Three levels of all blocks.
void ByThreads(benchmark::State& state, const Volume* volume, int threads)
{
  const BlockedVolume cut = volume->Cut(static_cast<int>(state.range(0)));
  const auto blocks = AllBlocks(cut);
  const ClassifiedTable table = MakeTable();
  std::vector<float> distortion(3 * blocks.size());
  for ([[maybe_unused]] auto _ : state)
  {
    flatblock::ComputeDistortion(
      volume->Samples.data(), cut, blocks, 3, table, threads, distortion.data());
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(volume->Samples.size()));
}

void ByCuda(benchmark::State& state, const Volume* volume, std::size_t mostResident)
{
  const BlockedVolume cut = volume->Cut(static_cast<int>(state.range(0)));
  const auto blocks = AllBlocks(cut);
  const ClassifiedTable table = MakeTable();
  std::vector<float> distortion(3 * blocks.size());
  flatblock::CudaDistortion cuda;
  cuda.SetMostResidentBytes(mostResident);
  cuda.Compute(volume->Samples.data(), cut, blocks, 3, table, distortion.data());
  for ([[maybe_unused]] auto _ : state)
  {
    const std::string problem =
      cuda.Compute(volume->Samples.data(), cut, blocks, 3, table, distortion.data());
    if (!problem.empty())
    {
      state.SkipWithError(problem.c_str());
      break;
    }
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(volume->Samples.size()));
}

template <typename Function>
void Register(const std::string& name, Function function)
{
  benchmark::RegisterBenchmark(name.c_str(), function)
    ->Arg(17)
    ->Arg(33)
    ->Arg(65)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
}

void RegisterAll(const std::string& name, const Volume* volume)
{
  const auto byThreads = [volume](int threads)
  { return [volume, threads](benchmark::State& state) { ByThreads(state, volume, threads); }; };
  Register(name + "/threads:1", byThreads(1));
  Register(name + "/threads:2", byThreads(2));
  if (flatblock::FindCudaDevice().Answers)
  {
    Register(
      name + "/cuda/resident", [volume](benchmark::State& state) { ByCuda(state, volume, 0); });
    Register(
      name + "/cuda/streamed", [volume](benchmark::State& state) { ByCuda(state, volume, 1); });
  }
}
} // namespace

int main(int argc, char** argv)
{
  const bool isFull = argc > 1 && std::strcmp(argv[argc - 1], "--full") == 0;
  argc -= isFull ? 1 : 0;
  const int part = isFull ? 1 : 2; // along each axis
  const Volume large({ 1024 / part, 1024 / part, 768 / part });
  const Volume medium({ 512 / part, 512 / part, 1734 / part });
  const Volume small({ 512 / part, 512 / part, 1304 / part });
  RegisterAll("1.5 GB", &large);
  RegisterAll("867 MB", &medium);
  RegisterAll("652 MB", &small);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
