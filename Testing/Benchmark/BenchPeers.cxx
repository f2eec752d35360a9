#include "BenchPoint.h"

#include "vtkExtractVOI.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockVolumeMapper.h"
#include "vtkSmartVolumeMapper.h"

#include <type_traits>

namespace flatblock::benchmarks
{
namespace
{
using Made = vtkSmartPointer<vtkVolumeMapper>;

vtkImageData* GetImage(Subject& subject)
{
  return vtkImageData::SafeDownCast(subject.Shown.Mapper->GetInputDataObject(0, 0));
}

Made MakeGPU(Subject& subject, double step, double imageStep)
{
  auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->SetInputData(GetImage(subject));
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(static_cast<float>(step));
  mapper->SetImageSampleDistance(static_cast<float>(imageStep));
  return mapper;
}

Point GPUPoint(const char* knob, const char* value, double (*step)(Subject&, double),
  double (*imageStep)(double))
{
  const double number = std::stod(value);
  return { "vtkGPUVolumeRayCastMapper", knob, value, {},
    [=](Subject& s) { return MakeGPU(s, step(s, number), imageStep(number)); } };
}

// VTK has it from 9.2 on.
template <typename Mapper, typename = void>
struct HasLowResMode : std::false_type
{
};
template <typename Mapper>
struct HasLowResMode<Mapper, std::void_t<decltype(std::declval<Mapper&>().SetLowResMode(1))>>
  : std::true_type
{
};

template <typename Mapper>
Made MakeLowRes(Subject& subject)
{
  if constexpr (HasLowResMode<Mapper>::value)
  {
    auto mapper = vtkSmartPointer<Mapper>::New();
    mapper->SetInputData(GetImage(subject));
    mapper->SetRequestedRenderModeToGPU();
    mapper->SetLowResMode(1);
    return mapper;
  }
  else
  {
    return {}; // the caller says so
  }
}

// Two blocks along each axis, which share their border samples.
Made MakeMultiBlock(Subject& subject)
{
  vtkImageData* image = GetImage(subject);
  int e[6];
  image->GetExtent(e);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int block = 0; block < 8; ++block)
  {
    vtkNew<vtkExtractVOI> cut;
    cut->SetInputData(image);
    int part[6];
    for (unsigned int i = 0; i < 3; ++i)
    {
      const int middle = (e[2 * i] + e[2 * i + 1]) / 2;
      const bool isUpper = (block >> i & 1U) != 0;
      part[2 * i] = isUpper ? middle : e[2 * i];
      part[2 * i + 1] = isUpper ? e[2 * i + 1] : middle;
    }
    cut->SetVOI(part);
    cut->Update();
    blocks->SetBlock(block, cut->GetOutput());
  }
  auto mapper = vtkSmartPointer<vtkMultiBlockVolumeMapper>::New();
  mapper->SetInputDataObject(blocks);
  return mapper;
}
} // namespace

std::vector<Point> ListPeerPoints(bool isQuick)
{
  const auto voxels = [](Subject& s, double number) { return number * s.Voxel; };
  const auto half = [](Subject& s, double) { return 0.5 * s.Voxel; };
  const auto samples = [](Subject& s, double number)
  { return GetStepForSamples(s, static_cast<int>(number)); };
  const auto itself = [](double number) { return number; };
  const auto one = [](double) { return 1.0; };
  std::vector<Point> points;
  for (const char* value : { "1", "0.5" })
  {
    points.push_back(GPUPoint("SampleDistance", value, voxels, one));
  }
  if (isQuick)
  {
    return points;
  }
  for (const char* value : { "2", "0.25" })
  {
    points.push_back(GPUPoint("SampleDistance", value, voxels, one));
  }
  for (const char* value : { "1", "2", "4" })
  {
    points.push_back(GPUPoint("ImageSampleDistance", value, half, itself));
  }
  for (const char* value : { "40", "60", "80", "120" })
  {
    points.push_back(GPUPoint("SamplesPerRay", value, samples, one));
  }
  points.push_back(
    { "vtkSmartVolumeMapper", "LowResMode", "on", {}, MakeLowRes<vtkSmartVolumeMapper> });
  points.push_back({ "vtkMultiBlockVolumeMapper", "Blocks", "8", {}, MakeMultiBlock });
  return points;
}
} // namespace flatblock::benchmarks
