/// Distortion.h on a CUDA device.
#pragma once

#include "Distortion.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace flatblock
{
/// Keeps the volume on the first device where it fits there; sends it in slabs of layers of blocks,
/// copying one while the one before it is computed, where it does not.
class CudaDistortion
{
public:
  CudaDistortion();
  ~CudaDistortion();
  CudaDistortion(const CudaDistortion&) = delete;
  CudaDistortion& operator=(const CudaDistortion&) = delete;

  /// As ComputeDistortion(), but for the number of samples that are left out. Neither throws nor
  /// leaves a CUDA error behind.
  ///
  /// @param samples  the same as in the last call, but for calls of Release() between
  /// @return empty, or why it failed; `distortion` is then not to be used
  /// Instantiated for every C++ arithmetic type that a VTK array can hold.
  template <typename T>
  std::string Compute(const T* samples, const BlockedVolume& volume,
    const std::vector<std::int64_t>& blocks, int levels, const ClassifiedTable& table,
    float* distortion);

  /// Gives back everything on the device. To be called when the samples have changed.
  void Release();

  /// Bytes of the volume that may stay on the device; 0: as many as there is room for.
  void SetMostResidentBytes(std::size_t bytes) { this->MostResidentBytes = bytes; }

private:
  struct Memory;
  std::unique_ptr<Memory> Device;
  std::size_t MostResidentBytes = 0;
};
} // namespace flatblock
