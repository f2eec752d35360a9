#include "CudaDevice.h"

#include <cuda_runtime.h>

namespace flatblock
{
namespace
{
__global__ void Answer(int* answer)
{
  *answer = 42;
}

cudaError_t AskDevice(int& answer)
{
  int* onDevice = nullptr;
  cudaError_t status = cudaMalloc(&onDevice, sizeof(int));
  if (status != cudaSuccess)
  {
    return status;
  }
  Answer<<<1, 1>>>(onDevice);
  status = cudaGetLastError();
  if (status == cudaSuccess)
  {
    status = cudaMemcpy(&answer, onDevice, sizeof(int), cudaMemcpyDeviceToHost);
  }
  const cudaError_t freed = cudaFree(onDevice);
  return status == cudaSuccess ? freed : status;
}
} // namespace

CudaDevice FindCudaDevice()
{
  CudaDevice device;
  device.Compiled = true;
  cudaDeviceProp properties;
  int answer = 0;
  cudaError_t status = cudaGetDeviceProperties(&properties, 0);
  if (status == cudaSuccess)
  {
    device.Name = properties.name;
    device.MemoryBytes = properties.totalGlobalMem;
    status = AskDevice(answer);
  }
  device.Answers = status == cudaSuccess && answer == 42;
  if (!device.Answers)
  {
    device.Name = cudaGetErrorString(status);
    cudaGetLastError(); // clears the error for whoever uses CUDA next in this process
  }
  return device;
}
} // namespace flatblock
