/// Whether CUDA kernels can run in this process.
#pragma once

#include <cstddef>
#include <string>

namespace flatblock
{
struct CudaDevice
{
  bool Compiled = false;       ///< the library was built with nvcc
  bool Answers = false;        ///< a device ran a kernel and gave the right result
  std::string Name;            ///< the device's name, or why none answers
  std::size_t MemoryBytes = 0; ///< memory of the device
};

/// Asks the first device to run a one-thread kernel. Never throws; leaves no error behind.
CudaDevice FindCudaDevice();
} // namespace flatblock
