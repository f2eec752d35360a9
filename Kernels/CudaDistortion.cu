#include "CudaDistortion.h"

#include <cuda_runtime.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace flatblock
{
namespace
{
constexpr int Threads = 128;
constexpr int TermsPerSum = 16; // floats are exact enough for so many
constexpr int MostLevels = 6;
constexpr int MostExactShift = 13; // 16 bit and this fit a std::int32_t
constexpr std::size_t SlabBytes = std::size_t(256) << 20;

template <typename T>
constexpr bool HasIntegerPositions = std::is_integral<T>::value && sizeof(T) <= 2;

template <typename T>
struct VolumeOnDevice
{
  const T* Samples;
  int FirstSlice; ///< of the volume, that lies at Samples
  int Dims[3];
  int Blocks[3];
  int Cells;
};

struct TableOnDevice
{
  const ClassifiedColor* Colors;
  double Lowest;
  double Scale;
  double Last;
};

// Where a block lies in the volume.
struct Box
{
  int First[3];
  int Count[3];
};

template <typename T>
__device__ Box FindBox(const VolumeOnDevice<T>& volume, std::int64_t block)
{
  const std::int64_t row = block / volume.Blocks[0];
  const int position[3] = { static_cast<int>(block % volume.Blocks[0]),
    static_cast<int>(row % volume.Blocks[1]), static_cast<int>(row / volume.Blocks[1]) };
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    box.First[axis] = position[axis] * volume.Cells;
    box.Count[axis] = min(volume.Cells + 1, volume.Dims[axis] - box.First[axis]);
  }
  return box;
}

// Samples beyond the far faces repeat the last one.
template <typename T>
__device__ T GetSample(const VolumeOnDevice<T>& volume, int x, int y, int z)
{
  x = min(x, volume.Dims[0] - 1);
  y = min(y, volume.Dims[1] - 1);
  z = min(z, volume.Dims[2] - 1) - volume.FirstSlice;
  return volume.Samples[(static_cast<std::size_t>(z) * volume.Dims[1] + y) * volume.Dims[0] + x];
}

template <typename T>
__device__ std::int32_t ToPosition(const TableOnDevice& table, T value, std::int32_t)
{
  return static_cast<std::int32_t>(value) - static_cast<std::int32_t>(table.Lowest);
}

// NaN and infinities as they are drawn.
template <typename T>
__device__ double ToPosition(const TableOnDevice& table, T value, double)
{
  const double position = (static_cast<double>(value) - table.Lowest) * table.Scale;
  return position > 0.0 ? (position < table.Last ? position : table.Last) : 0.0;
}

// The trilinear interpolant at a level, scaled by the stride's cube: exact for integers.
template <typename Number, typename T>
__device__ Number Interpolate(const VolumeOnDevice<T>& volume, const TableOnDevice& table,
  const Box& box, const int local[3], int level)
{
  const int stride = 1 << level;
  int cell[3];
  Number far[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    cell[axis] = min(local[axis] >> level, (volume.Cells >> level) - 1);
    far[axis] = static_cast<Number>(local[axis] - (cell[axis] << level));
  }
  Number sum = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    int at[3];
    Number weight = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int up = corner >> axis & 1;
      at[axis] = box.First[axis] + ((cell[axis] + up) << level);
      weight *= up ? far[axis] : static_cast<Number>(stride) - far[axis];
    }
    sum += weight * ToPosition(table, GetSample(volume, at[0], at[1], at[2]), Number());
  }
  return sum;
}

template <typename T>
__device__ TablePosition GetCoarsePosition(const VolumeOnDevice<T>& volume,
  const TableOnDevice& table, const Box& box, const int local[3], int level)
{
  if (HasIntegerPositions<T> && 3 * level <= MostExactShift)
  {
    return ToTablePosition(Interpolate<std::int32_t>(volume, table, box, local, level), 3 * level);
  }
  const double unit = 1.0 / static_cast<double>(std::int64_t(1) << (3 * level));
  return ToTablePosition(Interpolate<double>(volume, table, box, local, level) * unit);
}

template <typename T>
__device__ bool IsFinite(T value)
{
  return isfinite(static_cast<double>(value));
}

// One block of the volume by one block of threads. Sums are in a fixed order.
template <int Levels, typename T>
__global__ void ComputeBlocks(
  VolumeOnDevice<T> volume, TableOnDevice table, const std::int64_t* blocks, float* distortion)
{
  const Box box = FindBox(volume, blocks[blockIdx.x]);
  const int samples = box.Count[0] * box.Count[1] * box.Count[2];
  double sums[Levels] = {};
  ClassifiedColor squares[Levels] = {};
  int finite = 0;
  int terms = 0;
  for (int i = static_cast<int>(threadIdx.x); i < samples; i += Threads)
  {
    const int local[3] = { i % box.Count[0], i / box.Count[0] % box.Count[1],
      i / (box.Count[0] * box.Count[1]) };
    const T value =
      GetSample(volume, box.First[0] + local[0], box.First[1] + local[1], box.First[2] + local[2]);
    if (!IsFinite(value))
    {
      continue;
    }
    ++finite;
    const TablePosition fine = HasIntegerPositions<T>
                                 ? ToTablePosition(ToPosition(table, value, std::int32_t()), 0)
                                 : ToTablePosition(ToPosition(table, value, 0.0));
    const bool isFull = ++terms == TermsPerSum;
    for (int level = 1; level <= Levels; ++level)
    {
      ClassifiedColor& sum = squares[level - 1];
      sum = sum + GetSquaredDifference(
                    table.Colors, fine, GetCoarsePosition(volume, table, box, local, level));
      if (isFull)
      {
        sums[level - 1] += (double(sum[0]) + sum[1]) + (double(sum[2]) + sum[3]);
        sum = ClassifiedColor{};
      }
    }
    terms = isFull ? 0 : terms;
  }

  __shared__ double shared[Threads];
  __shared__ int sharedFinite[Threads];
  const int thread = static_cast<int>(threadIdx.x);
  sharedFinite[thread] = finite;
  for (int level = 0; level < Levels; ++level)
  {
    const ClassifiedColor& rest = squares[level];
    shared[thread] = sums[level] + ((double(rest[0]) + rest[1]) + (double(rest[2]) + rest[3]));
    __syncthreads();
    for (int half = Threads / 2; half > 0; half /= 2)
    {
      if (thread < half)
      {
        shared[thread] += shared[thread + half];
        sharedFinite[thread] += level == 0 ? sharedFinite[thread + half] : 0;
      }
      __syncthreads();
    }
    if (thread == 0)
    {
      const double mean = sharedFinite[0] > 0 ? shared[0] / sharedFinite[0] : 0.0;
      distortion[static_cast<std::size_t>(blockIdx.x) * Levels + level] =
        static_cast<float>(sqrt(mean));
    }
    __syncthreads();
  }
}

template <typename T>
cudaError_t Launch(int levels, const VolumeOnDevice<T>& volume, const TableOnDevice& table,
  const std::int64_t* blocks, std::size_t count, float* distortion, cudaStream_t stream)
{
  const auto grid = static_cast<unsigned int>(count);
  switch (levels)
  {
  case 1:
    ComputeBlocks<1><<<grid, Threads, 0, stream>>>(volume, table, blocks, distortion);
    break;
  case 2:
    ComputeBlocks<2><<<grid, Threads, 0, stream>>>(volume, table, blocks, distortion);
    break;
  case 3:
    ComputeBlocks<3><<<grid, Threads, 0, stream>>>(volume, table, blocks, distortion);
    break;
  case 4:
    ComputeBlocks<4><<<grid, Threads, 0, stream>>>(volume, table, blocks, distortion);
    break;
  case 5:
    ComputeBlocks<5><<<grid, Threads, 0, stream>>>(volume, table, blocks, distortion);
    break;
  default:
    ComputeBlocks<MostLevels><<<grid, Threads, 0, stream>>>(volume, table, blocks, distortion);
  }
  return cudaGetLastError();
}

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
    const std::vector<std::int64_t>&, int, const ClassifiedTable&, float*)
FLATBLOCK_INSTANTIATE(char);
FLATBLOCK_INSTANTIATE(signed char);
FLATBLOCK_INSTANTIATE(unsigned char);
FLATBLOCK_INSTANTIATE(short);
FLATBLOCK_INSTANTIATE(unsigned short);
FLATBLOCK_INSTANTIATE(int);
FLATBLOCK_INSTANTIATE(unsigned int);
FLATBLOCK_INSTANTIATE(long);
FLATBLOCK_INSTANTIATE(unsigned long);
FLATBLOCK_INSTANTIATE(long long);
FLATBLOCK_INSTANTIATE(unsigned long long);
FLATBLOCK_INSTANTIATE(float);
FLATBLOCK_INSTANTIATE(double);
#undef FLATBLOCK_INSTANTIATE
} // namespace flatblock
