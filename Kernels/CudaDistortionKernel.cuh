/// Distortion of blocks on a CUDA device: one block of threads for each.
/// Launches take a stream, return an error, and never synchronize.
#pragma once

#include "DistortionArithmetic.h"

#include <cuda_runtime.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace flatblock
{
namespace
{
constexpr int Threads = 128;
constexpr int TermsPerSum = 16; // floats are exact enough for so many
constexpr int MostLevels = 6;
constexpr int MostExactShift = 13; // 16 bit and this fit a std::int32_t

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
  const std::int32_t position =
    static_cast<std::int32_t>(value) - static_cast<std::int32_t>(table.Lowest);
  return max(0, min(position, static_cast<std::int32_t>(table.Last)));
}

// NaN and infinities as the lowest or highest value; nothing is drawn around them.
template <typename T>
__device__ double ToPosition(const TableOnDevice& table, T value, double)
{
  const double position = (static_cast<double>(value) - table.Lowest) * table.Scale;
  return position > 0.0 ? (position < table.Last ? position : table.Last) : 0.0;
}

// The trilinear interpolant at a level, scaled by the stride's cube: exact for
// integers.
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
__device__ ClassifiedColor GetSquare(const VolumeOnDevice<T>& volume, const TableOnDevice& table,
  const Box& box, const int local[3], T value, int level)
{
  if (HasIntegerPositions<T> && 3 * level <= MostExactShift)
  {
    const ClassifiedColor& fine = table.Colors[ToPosition(table, value, std::int32_t())];
    const TablePosition coarse =
      ToTablePosition(Interpolate<std::int32_t>(volume, table, box, local, level), 3 * level);
    return GetSquaredDifference(
      fine, table.Colors[coarse.Nearest], table.Colors[coarse.Next], coarse.Share);
  }
  const double unit = 1.0 / static_cast<double>(std::int64_t(1) << (3 * level));
  return GetSquaredDifference(table.Colors, ToPosition(table, value, 0.0),
    Interpolate<double>(volume, table, box, local, level) * unit);
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
    const bool isFull = ++terms == TermsPerSum;
    for (int level = 1; level <= Levels; ++level)
    {
      ClassifiedColor& sum = squares[level - 1];
      sum = sum + GetSquare(volume, table, box, local, value, level);
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
} // namespace
} // namespace flatblock
