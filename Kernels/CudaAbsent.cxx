#include "CudaDevice.h"
#include "CudaDistortion.h"
#include "SampleTypes.h"

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
    const std::vector<std::int64_t>&, int, const ClassifiedTable&, float*);
FLATBLOCK_FOR_SAMPLE_TYPES(FLATBLOCK_INSTANTIATE)
#undef FLATBLOCK_INSTANTIATE
} // namespace flatblock
