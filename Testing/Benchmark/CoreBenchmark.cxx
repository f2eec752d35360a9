// Block ranges against a plain minimum and maximum of the same memory, and the selection of levels.
#include "BlockGrid.h"
#include "BlockRanges.h"
#include "BlockVisibility.h"
#include "LodSelector.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

using flatblock::AtlasShape;
using flatblock::BlockGrid;

namespace
{
std::vector<std::uint16_t> MakeSamples(int n)
{
  std::mt19937 random(1);
  std::vector<std::uint16_t> samples(std::size_t(n) * n * n);
  std::generate(samples.begin(), samples.end(), [&] { return std::uint16_t(random()); });
  return samples;
}

void BlockRanges(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  const auto samples = MakeSamples(n);
  const BlockGrid grid({ n, n, n }, static_cast<int>(state.range(1)));
  std::vector<flatblock::ValueRange> ranges(grid.GetNumberOfBlocks());
  for ([[maybe_unused]] auto _ : state)
  {
    flatblock::ComputeBlockRanges(
      samples.data(), grid.GetSamples(), grid.GetCellsPerBlock(), grid.GetBlocks(), ranges.data());
    benchmark::DoNotOptimize(ranges.data());
  }
  state.SetBytesProcessed(state.iterations() * std::int64_t(samples.size() * sizeof(samples[0])));
}
BENCHMARK(BlockRanges)
  ->ArgsProduct({ { 512 }, { 17, 33, 65 } })
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

void PlainMinMax(benchmark::State& state)
{
  const auto samples = MakeSamples(static_cast<int>(state.range(0)));
  const auto count = static_cast<std::int64_t>(samples.size());
  const std::uint16_t* values = samples.data();
  for ([[maybe_unused]] auto _ : state)
  {
    std::uint16_t lowest = 65535;
    std::uint16_t highest = 0;
#pragma omp parallel for simd reduction(min : lowest) reduction(max : highest)
    for (std::int64_t i = 0; i < count; ++i)
    {
      lowest = std::min(lowest, values[i]);
      highest = std::max(highest, values[i]);
    }
    benchmark::DoNotOptimize(lowest);
    benchmark::DoNotOptimize(highest);
  }
  state.SetBytesProcessed(state.iterations() * count * std::int64_t(sizeof(samples[0])));
}
BENCHMARK(PlainMinMax)->Arg(512)->UseRealTime()->Unit(benchmark::kMillisecond);

// Every block at the next position of a point of interest that moves on by one block. A decision is
// a block that is refined by one level or left as it is.
void SelectLevels(benchmark::State& state)
{
  const int n = 16 * static_cast<int>(state.range(0)) + 1;
  const BlockGrid grid({ n, n, n }, 17);
  const std::int64_t blocks = grid.GetNumberOfBlocks();
  const AtlasShape shape({ { 17, 9, 5, 3, 2 }, blocks * 1200, blocks, 16384 });
  const std::vector<flatblock::BlockRank> ranks(blocks, flatblock::BlockRank::InView);
  flatblock::RefinementOrder order;
  flatblock::LodSelector selector;
  std::int64_t decisions = 0;
  double x = -200.0;
  for ([[maybe_unused]] auto _ : state)
  {
    x = x > 200.0 ? -200.0 : x + 16.0;
    order.SetToDistance(grid, ranks, { x, 50.0, 30.0 }, { 1.0, 1.0, 1.0 });
    if (!selector.Select(order, shape, 4))
    {
      state.SkipWithError("nothing fits");
    }
    state.PauseTiming();
    for (const std::int8_t level : selector.GetLevels())
    {
      decisions += 3 - level + (level > 0 ? 1 : 0);
    }
    state.ResumeTiming();
  }
  state.SetItemsProcessed(decisions);
}
// 24^3 blocks.
void Visibility(benchmark::State& state)
{
  const BlockGrid grid({ 385, 385, 385 }, 17);
  const std::vector<float> extinction(grid.GetNumberOfBlocks(), 0.1F);
  flatblock::Viewpoint view;
  view.Eye = { 600.0, 500.0, 400.0 };
  for ([[maybe_unused]] auto _ : state)
  {
    benchmark::DoNotOptimize(
      flatblock::ComputeTransmittance(grid, extinction, { 1.0, 1.0, 1.0 }, view));
  }
}
BENCHMARK(Visibility)->Unit(benchmark::kMillisecond);

BENCHMARK(SelectLevels)->Arg(20)->Arg(74)->Unit(benchmark::kMillisecond);
} // namespace
