#include "BenchPoint.h"

#include "vtkExtractVOI.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageResample.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockVolumeMapper.h"
#include "vtkSmartVolumeMapper.h"

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

// What its mode of low resolution draws: a volume of so many times fewer samples along each axis.
// VTK's OpenGL mapper never asks for the mode by itself, so the volume is given to it.
Made MakeLowRes(Subject& subject, int times)
{
  vtkNew<vtkImageResample> resample;
  resample->SetInputData(GetImage(subject));
  for (int axis = 0; axis < 3; ++axis)
  {
    resample->SetAxisMagnificationFactor(axis, 1.0 / times);
  }
  resample->Update();
  auto mapper = vtkSmartPointer<vtkSmartVolumeMapper>::New();
  mapper->SetInputData(resample->GetOutput());
  mapper->SetRequestedRenderModeToGPU();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->InteractiveAdjustSampleDistancesOff();
  mapper->SetSampleDistance(static_cast<float>(0.5 * times * subject.Voxel));
  return mapper;
}

Point LowResPoint(int times)
{
  return { "vtkSmartVolumeMapper", "LowResolution", "1/" + std::to_string(times), {},
    [times](Subject& s) { return MakeLowRes(s, times); } };
}

// Blocks along each axis, which share their border samples. The mapper sets no step and has no
// limit of memory of its own: the blocks are its knob.
Made MakeMultiBlock(Subject& subject, int along)
{
  vtkImageData* image = GetImage(subject);
  int e[6];
  image->GetExtent(e);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int block = 0; block < along * along * along; ++block)
  {
    const int at[3] = { block % along, block / along % along, block / along / along };
    int part[6];
    for (int i = 0; i < 3; ++i)
    {
      const int cells = e[2 * i + 1] - e[2 * i];
      part[2 * i] = e[2 * i] + cells * at[i] / along;
      part[2 * i + 1] = e[2 * i] + cells * (at[i] + 1) / along;
    }
    vtkNew<vtkExtractVOI> cut;
    cut->SetInputData(image);
    cut->SetVOI(part);
    cut->Update();
    blocks->SetBlock(static_cast<unsigned int>(block), cut->GetOutput());
  }
  auto mapper = vtkSmartPointer<vtkMultiBlockVolumeMapper>::New();
  mapper->SetInputDataObject(blocks);
  return mapper;
}

Point MultiBlockPoint(int along)
{
  return { "vtkMultiBlockVolumeMapper", "Blocks", std::to_string(along * along * along), {},
    [along](Subject& s) { return MakeMultiBlock(s, along); } };
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
  points.push_back(LowResPoint(2));
  points.push_back(LowResPoint(4));
  points.push_back(MultiBlockPoint(1));
  points.push_back(MultiBlockPoint(2));
  points.push_back(MultiBlockPoint(3));
  return points;
}
} // namespace flatblock::benchmarks
