#include "CudaDevice.h"
#include "vtkFlatBlockVolumeMapperInternals.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <thread>

// Distortion in vtkFlatBlockVolumeMapper: when it is computed, by what, and what it tells.

// By the device that answers, if one does: asked once a process.
bool vtkFlatBlockVolumeMapper::UsesCuda()
{
  if (this->DistortionBackend == SERIAL || this->DistortionBackend == OPENMP ||
      this->Internals->HasCudaFailed)
  {
    return false;
  }
  static const flatblock::CudaDevice device = flatblock::FindCudaDevice();
  if (!device.Answers && this->DistortionBackend == CUDA)
  {
    this->Internals->HasCudaFailed = true;
    vtkWarningMacro(<< "No CUDA device answers (" << device.Name
                    << "); OpenMP computes distortions.");
  }
  return device.Answers;
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateClassified()
{
  flatblock::StageTimer timer(this->Statistics.DistortionMilliseconds);
  this->TransferFunction->UpdateClassified(this->Property, this->AreIndependent ? this->Lead : 0,
    this->Builder->GetRange(), this->Builder->HasIntegers());
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateTransmittance(const flatblock::VolumeView& view)
{
  constexpr double MostExtinction = 1e6; // of what is wholly opaque
  const flatblock::ClassifiedTable& table = this->TransferFunction->GetClassifiedTable();
  const bool isNewTable =
    std::max({ this->TransferFunction->GetClassifiedTime(), this->Builder->GetMTime(),
      this->Builder->GetShownTime() }) > this->ExtinctionTime;
  if (isNewTable)
  {
    const double unit = this->Property->GetScalarOpacityUnitDistance();
    const auto& ranges = this->Builder->GetShownRanges();
    this->LeastExtinction.resize(ranges.size());
    std::transform(ranges.begin(), ranges.end(), this->LeastExtinction.begin(),
      [&](const flatblock::ValueRange& range)
      {
        const double opacity =
          range.HasHoles ? 0.0 : table.GetLeastOpacity(range.Lowest, range.Highest);
        return static_cast<float>(
          std::min(-std::log1p(-std::min(opacity, 1.0)) / unit, MostExtinction));
      });
  }
  const flatblock::VolumeView& last = this->TransmittanceView;
  if (isNewTable || !(view.Camera == last.Camera) || view.DataSetSpacing != last.DataSetSpacing)
  {
    this->Transmittance = flatblock::ComputeTransmittance(
      this->GetSource().GetGrid(), this->LeastExtinction, view.DataSetSpacing, view.Camera);
    this->TransmittanceView = view;
    this->TransmittanceTime.Modified();
    this->ExtinctionTime.Modified();
  }
}

void vtkFlatBlockVolumeMapper::UpdateDistortion(vtkTypeInt64 mostBlocks)
{
  vtkInternals& in = *this->Internals;
  in.UpdateClassified();
  flatblock::StageTimer timer(in.Statistics.DistortionMilliseconds);
  const flatblock::BrickSource& source = in.GetSource();
  const int levels =
    std::clamp(this->NumberOfLevels - 1, 1, source.GetGrid().GetNumberOfLevels() - 1);
  in.Distortion->SetTable(in.Builder, in.TransferFunction->GetClassifiedTable(),
    in.TransferFunction->GetClassifiedTime(), levels, this->DistortionEstimate == SUMMARY,
    this->UsesCuda());
  if (in.Distortion->IsComplete())
  {
    return;
  }
  const int threads = this->DistortionBackend == SERIAL ? 1 : this->NumberOfThreads;
  // As many as an interruption may lose, and as keep all threads busy.
  constexpr vtkTypeInt64 BlocksPerThread = 128;
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const vtkTypeInt64 step = BlocksPerThread * (threads > 0 ? threads : cores);
  for (vtkTypeInt64 left = mostBlocks; left > 0 && !in.Distortion->IsComplete(); left -= step)
  {
    const std::string problem =
      in.Distortion->Compute(in.Builder, std::min(left, step), threads, this->UsesCuda());
    if (!problem.empty())
    {
      in.HasCudaFailed = true;
      vtkWarningMacro(<< "CUDA failed (" << problem << "); OpenMP computes distortions.");
    }
  }
}

bool vtkFlatBlockVolumeMapper::GetDistortionComplete() const
{
  return this->Internals->IsDistortionCurrent;
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::GetDistortionSummaryBytes() const
{
  return this->Internals->Distortion->GetSummaryBytes();
}

double vtkFlatBlockVolumeMapper::GetTotalDistortion()
{
  vtkInternals& in = *this->Internals;
  const auto& levels = in.Residency.GetLevels();
  double total = 0.0;
  try
  {
    if (!levels.empty())
    {
      this->UpdateDistortion(VTK_TYPE_INT64_MAX);
    }
  }
  catch (const std::exception& problem)
  {
    this->ReportOnce(problem.what());
    return 0.0;
  }
  for (std::size_t block = 0; block < levels.size(); ++block)
  {
    total += in.Distortion->GetValue(block, levels[block]);
  }
  return total;
}

double vtkFlatBlockVolumeMapper::GetMeanDistortionOfUnrefinedBlocks()
{
  const auto& levels = this->Internals->Residency.GetLevels();
  const auto unrefined =
    std::count_if(levels.begin(), levels.end(), [](std::int8_t level) { return level > 0; });
  return unrefined > 0 ? this->GetTotalDistortion() / static_cast<double>(unrefined) : 0.0;
}
