#include "CudaDevice.h"
#include "CudaDistortion.h"

namespace flatblock
{
namespace
{
constexpr const char* Reason = "built without CUDA";
}

CudaDevice FindCudaDevice()
{
  CudaDevice device;
  device.Name = Reason;
  return device;
}

struct CudaDistortion::Memory
{
};

CudaDistortion::CudaDistortion() = default;
CudaDistortion::~CudaDistortion() = default;
void CudaDistortion::Release() {}

template <typename T>
std::string CudaDistortion::Compute(const T*, const BlockedVolume&,
  const std::vector<std::int64_t>&, int, const ClassifiedTable&, float*)
{
  return Reason;
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
