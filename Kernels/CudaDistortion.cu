#include "CudaDistortion.h"

#include "CudaDistortionKernel.cuh"
#include "SampleTypes.h"

#include <cuda_runtime.h>

#include <algorithm>
#include <cstring>

namespace flatblock
{
namespace
{
constexpr std::size_t SlabBytes = std::size_t(256) << 20;

// Memory on the device, or pinned on the host, that grows as it is needed.
class Buffer
{
public:
  explicit Buffer(bool isPinned = false) : IsPinned(isPinned) {}
  ~Buffer() { this->Release(); }
  Buffer(const Buffer&) = delete;
  void operator=(const Buffer&) = delete;

  cudaError_t Resize(std::size_t bytes)
  {
    if (bytes <= this->Bytes)
    {
      return cudaSuccess;
    }
    this->Release();
    const cudaError_t status =
      this->IsPinned ? cudaMallocHost(&this->Data, bytes) : cudaMalloc(&this->Data, bytes);
    this->Data = status == cudaSuccess ? this->Data : nullptr;
    this->Bytes = status == cudaSuccess ? bytes : 0;
    return status;
  }

  void Release()
  {
    if (this->Data)
    {
      this->IsPinned ? cudaFreeHost(this->Data) : cudaFree(this->Data);
    }
    this->Data = nullptr;
    this->Bytes = 0;
  }

  template <typename T>
  T* Get() const
  {
    return static_cast<T*>(this->Data);
  }

private:
  bool IsPinned;
  void* Data = nullptr;
  std::size_t Bytes = 0;
};

// A stage of the pipeline that copies and computes.
struct Lane
{
  Buffer Staging{ true };
  Buffer Samples;
  cudaStream_t Stream = nullptr;

  ~Lane()
  {
    if (this->Stream)
    {
      cudaStreamDestroy(this->Stream);
    }
  }
};

#define FLATBLOCK_CHECK(call)                                                                      \
  if (const cudaError_t status = (call); status != cudaSuccess)                                    \
  {                                                                                                \
    return status;                                                                                 \
  }
} // namespace

struct CudaDistortion::Memory
{
  Buffer Volume;
  const void* VolumeOnHost = nullptr; // what Volume holds; only compared with
  Buffer Colors;
  Buffer Blocks;
  Buffer Results;
  Lane Lanes[2];

  cudaError_t Prepare(const std::vector<std::int64_t>& blocks, int levels,
    const ClassifiedTable& table, TableOnDevice& onDevice)
  {
    for (Lane& lane : this->Lanes)
    {
      if (!lane.Stream)
      {
        FLATBLOCK_CHECK(cudaStreamCreateWithFlags(&lane.Stream, cudaStreamNonBlocking));
      }
    }
    std::vector<ClassifiedColor> colors = table.GetColors();
    colors.push_back(colors.back()); // after the last position
    const std::size_t bytes = colors.size() * sizeof(colors[0]);
    FLATBLOCK_CHECK(this->Colors.Resize(bytes));
    FLATBLOCK_CHECK(
      cudaMemcpy(this->Colors.Get<void>(), colors.data(), bytes, cudaMemcpyHostToDevice));
    const std::size_t numbers = blocks.size() * sizeof(blocks[0]);
    FLATBLOCK_CHECK(this->Blocks.Resize(numbers));
    FLATBLOCK_CHECK(
      cudaMemcpy(this->Blocks.Get<void>(), blocks.data(), numbers, cudaMemcpyHostToDevice));
    FLATBLOCK_CHECK(this->Results.Resize(blocks.size() * levels * sizeof(float)));
    FLATBLOCK_CHECK(cudaStreamSynchronize(nullptr)); // the lanes do not wait for these copies
    const double span = table.GetHighest() - table.GetLowest();
    const auto last = static_cast<double>(table.GetColors().size() - 1);
    onDevice = { this->Colors.Get<ClassifiedColor>(), table.GetLowest(),
      span > 0.0 ? last / span : 0.0, last };
    return cudaSuccess;
  }

  template <typename T>
  cudaError_t ComputeResident(const T* samples, VolumeOnDevice<T> volume,
    const TableOnDevice& table, std::size_t blocks, int levels)
  {
    const std::size_t bytes =
      sizeof(T) * volume.Dims[0] * volume.Dims[1] * static_cast<std::size_t>(volume.Dims[2]);
    if (this->VolumeOnHost != samples)
    {
      FLATBLOCK_CHECK(this->Volume.Resize(bytes));
      FLATBLOCK_CHECK(cudaMemcpy(this->Volume.Get<void>(), samples, bytes, cudaMemcpyHostToDevice));
      FLATBLOCK_CHECK(cudaStreamSynchronize(nullptr));
      this->VolumeOnHost = samples;
    }
    volume.Samples = this->Volume.Get<T>();
    return Launch(levels, volume, table, this->Blocks.Get<std::int64_t>(), blocks,
      this->Results.Get<float>(), this->Lanes[0].Stream);
  }

  // The blocks are in the order of the grid, so that those of some layers follow each other.
  template <typename T>
  cudaError_t ComputeStreamed(const T* samples, VolumeOnDevice<T> volume,
    const TableOnDevice& table, const std::vector<std::int64_t>& blocks, int levels)
  {
    const std::int64_t perLayer = std::int64_t(volume.Blocks[0]) * volume.Blocks[1];
    const std::size_t slice = sizeof(T) * volume.Dims[0] * static_cast<std::size_t>(volume.Dims[1]);
    const auto layers = static_cast<std::int64_t>(
      std::max<std::size_t>(1, SlabBytes / (slice * static_cast<std::size_t>(volume.Cells))));
    std::size_t begin = 0;
    for (int turn = 0; begin < blocks.size(); turn = 1 - turn)
    {
      const std::int64_t first = blocks[begin] / perLayer;
      const auto end = static_cast<std::size_t>(
        std::lower_bound(blocks.begin(), blocks.end(), (first + layers) * perLayer) -
        blocks.begin());
      Lane& lane = this->Lanes[turn];
      FLATBLOCK_CHECK(cudaStreamSynchronize(lane.Stream)); // its buffers are free again
      volume.FirstSlice = static_cast<int>(first) * volume.Cells;
      const int slices =
        std::min(static_cast<int>(layers) * volume.Cells + 1, volume.Dims[2] - volume.FirstSlice);
      const std::size_t bytes = slice * static_cast<std::size_t>(slices);
      FLATBLOCK_CHECK(lane.Staging.Resize(bytes));
      FLATBLOCK_CHECK(lane.Samples.Resize(bytes));
      std::memcpy(lane.Staging.Get<void>(),
        samples + slice / sizeof(T) * static_cast<std::size_t>(volume.FirstSlice), bytes);
      FLATBLOCK_CHECK(cudaMemcpyAsync(lane.Samples.Get<void>(), lane.Staging.Get<void>(), bytes,
        cudaMemcpyHostToDevice, lane.Stream));
      volume.Samples = lane.Samples.Get<T>();
      FLATBLOCK_CHECK(Launch(levels, volume, table, this->Blocks.Get<std::int64_t>() + begin,
        end - begin, this->Results.Get<float>() + begin * levels, lane.Stream));
      begin = end;
    }
    return cudaSuccess;
  }

  cudaError_t Fetch(std::size_t values, float* distortion)
  {
    for (Lane& lane : this->Lanes)
    {
      FLATBLOCK_CHECK(cudaStreamSynchronize(lane.Stream));
    }
    return cudaMemcpy(
      distortion, this->Results.Get<void>(), values * sizeof(float), cudaMemcpyDeviceToHost);
  }

  template <typename T>
  cudaError_t Compute(const T* samples, const BlockedVolume& volume,
    const std::vector<std::int64_t>& blocks, int levels, const ClassifiedTable& table,
    std::size_t mostResident, float* distortion)
  {
    TableOnDevice onDevice;
    FLATBLOCK_CHECK(this->Prepare(blocks, levels, table, onDevice));
    const auto& n = volume.Samples;
    const auto& b = volume.Blocks;
    const VolumeOnDevice<T> whole = { nullptr, 0, { n[0], n[1], n[2] }, { b[0], b[1], b[2] },
      volume.Cells };
    std::size_t free = 0;
    std::size_t total = 0;
    FLATBLOCK_CHECK(cudaMemGetInfo(&free, &total));
    const std::size_t bytes = sizeof(T) * n[0] * n[1] * static_cast<std::size_t>(n[2]);
    const std::size_t room = mostResident > 0 ? mostResident : free / 10 * 8;
    if (this->VolumeOnHost == samples || bytes <= room)
    {
      FLATBLOCK_CHECK(this->ComputeResident(samples, whole, onDevice, blocks.size(), levels));
    }
    else
    {
      FLATBLOCK_CHECK(this->ComputeStreamed(samples, whole, onDevice, blocks, levels));
    }
    return this->Fetch(blocks.size() * levels, distortion);
  }
};

CudaDistortion::CudaDistortion() = default;
CudaDistortion::~CudaDistortion() = default;

void CudaDistortion::Release()
{
  this->Device.reset();
}

template <typename T>
std::string CudaDistortion::Compute(const T* samples, const BlockedVolume& volume,
  const std::vector<std::int64_t>& blocks, int levels, const ClassifiedTable& table,
  float* distortion)
{
  if (levels > MostLevels)
  {
    return "more levels than the kernel has";
  }
  if (!this->Device)
  {
    this->Device = std::make_unique<Memory>();
  }
  const cudaError_t status = this->Device->Compute(
    samples, volume, blocks, levels, table, this->MostResidentBytes, distortion);
  if (status == cudaSuccess)
  {
    return {};
  }
  this->Release();
  cudaGetLastError(); // clears the error for whoever uses CUDA next in this process
  return cudaGetErrorString(status);
}

#define FLATBLOCK_INSTANTIATE(T)                                                                   \
  template std::string CudaDistortion::Compute(const T*, const BlockedVolume&,                     \
    const std::vector<std::int64_t>&, int, const ClassifiedTable&, float*);
FLATBLOCK_FOR_SAMPLE_TYPES(FLATBLOCK_INSTANTIATE)
#undef FLATBLOCK_INSTANTIATE
} // namespace flatblock
