#include "CudaDevice.h"

namespace flatblock
{
CudaDevice FindCudaDevice()
{
  CudaDevice device;
  device.Name = "built without CUDA";
  return device;
}
} // namespace flatblock
