#include "BenchMeasure.h"

#include <stdexcept>

namespace flatblock::benchmarks
{
namespace
{
// A volume of its own in the subject's window, as long as it lives.
class Placed
{
public:
  Placed(Subject& subject, const Point& point, vtkTypeInt64 beside, vtkTypeInt64 volume)
    : Shown(subject)
  {
    // DeepCopy() would add a gradient opacity.
    vtkVolumeProperty* property = subject.Shown.Property;
    this->Property->SetColor(property->GetRGBTransferFunction());
    this->Property->SetScalarOpacity(property->GetScalarOpacity());
    this->Property->SetScalarOpacityUnitDistance(property->GetScalarOpacityUnitDistance());
    this->Property->SetInterpolationType(property->GetInterpolationType());
    this->Property->SetShade(property->GetShade());
    this->Property->SetAmbient(property->GetAmbient());
    this->Property->SetDiffuse(property->GetDiffuse());
    this->Property->SetSpecular(property->GetSpecular());
    this->Property->SetSpecularPower(property->GetSpecularPower());
    this->Mapper = point.IsOurs() ? this->MakeOurs(point, beside, volume) : point.MakePeer(subject);
    if (!this->Mapper)
    {
      throw std::runtime_error("this VTK has no such mode");
    }
    this->Volume->SetProperty(this->Property);
    this->Volume->SetMapper(this->Mapper);
    this->Volume->VisibilityOff();
    subject.Shown.Renderer->AddVolume(this->Volume);
  }

  ~Placed()
  {
    this->Shown.Shown.Renderer->RemoveVolume(this->Volume);
    this->Mapper->ReleaseGraphicsResources(this->Shown.Shown.Window);
  }

  Placed(const Placed&) = delete;
  void operator=(const Placed&) = delete;

  double Time()
  {
    this->Shown.Shown.Window->SetDesiredUpdateRate(this->UpdateRate);
    this->Volume->VisibilityOn();
    const double taken = TimeFrame(this->Shown.Shown);
    this->Volume->VisibilityOff();
    return taken;
  }

  testing::Picture Draw()
  {
    this->Shown.Shown.Window->SetDesiredUpdateRate(this->UpdateRate);
    const int* size = this->Shown.Shown.Window->GetSize();
    testing::FloatFramebuffer framebuffer(this->Shown.Shown.Window, size[0], size[1]);
    this->Mapper->Update();
    this->Mapper->Render(this->Shown.Shown.Renderer, this->Volume);
    return framebuffer.Read();
  }

  vtkFlatBlockVolumeMapper* GetOurs()
  {
    return vtkFlatBlockVolumeMapper::SafeDownCast(this->Mapper);
  }

private:
  vtkSmartPointer<vtkVolumeMapper> MakeOurs(
    const Point& point, vtkTypeInt64 beside, vtkTypeInt64 volume)
  {
    auto* image = vtkImageData::SafeDownCast(this->Shown.Shown.Mapper->GetInputDataObject(0, 0));
    auto mapper = vtkSmartPointer<vtkFlatBlockVolumeMapper>::New();
    mapper->SetInputData(image);
    mapper->AutoAdjustSampleDistancesOff();
    mapper->SetSampleDistance(0.5 * this->Shown.Voxel);
    // Enough for all bricks, unless the point says otherwise.
    mapper->SetMaxMemoryInBytes(
      (vtkTypeInt64(256) << 20) + vtkTypeInt64(2048) * vtkTypeInt64(image->GetActualMemorySize()));
    Setting setting{ this->Shown, mapper, this->Property, beside, volume };
    point.Apply(setting);
    this->UpdateRate = setting.IsInteractive ? 20.0 : 1e-4;
    return mapper;
  }

  Subject& Shown;
  double UpdateRate = 1e-4;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Property;
  vtkSmartPointer<vtkVolumeMapper> Mapper;
};

bool IsEmpty(const testing::Picture& picture)
{
  return std::all_of(
    picture.begin(), picture.end(), [](const auto& pixel) { return pixel[3] == 0.0; });
}

std::vector<unsigned char> ToBytes(const testing::Picture& picture)
{
  std::vector<unsigned char> bytes;
  bytes.reserve(3 * picture.size());
  for (const auto& pixel : picture)
  {
    for (int c = 0; c < 3; ++c)
    {
      bytes.push_back(
        static_cast<unsigned char>(std::lround(255.0 * std::clamp(pixel[c], 0.0, 1.0))));
    }
  }
  return bytes;
}
} // namespace

namespace
{
vtkTypeInt64 GetVolumeBytes(Subject& subject)
{
  auto* image = vtkImageData::SafeDownCast(subject.Shown.Mapper->GetInputDataObject(0, 0));
  return image->GetNumberOfPoints() * image->GetScalarSize();
}

// The least limit within which every visible block is drawn at its finest level.
vtkTypeInt64 FindLeastLimit(Subject& subject)
{
  vtkFlatBlockVolumeMapper* mapper = nullptr;
  Placed placed(
    subject, { "", "", "", [&mapper](Setting& setting) { mapper = setting.Mapper; }, {} }, 0, 0);
  vtkTypeInt64 most = mapper->GetMaxMemoryInBytes();
  vtkTypeInt64 least = 0;
  testing::Listen(
    [&]
    {
      while (most - least > most / 200)
      {
        const vtkTypeInt64 limit = least + (most - least) / 2;
        mapper->SetMaxMemoryInBytes(limit);
        placed.Time();
        const bool areFinest = mapper->GetNumberOfBricks(0) > 0 &&
                               mapper->GetNumberOfBricks(0) == mapper->GetNumberOfVisibleBlocks();
        (areFinest ? most : least) = limit;
      }
    });
  mapper->SetMaxMemoryInBytes(most);
  placed.Time();
  return most - mapper->GetUsedAtlasBytes();
}
} // namespace

Bench::Bench(Subject& subject)
  : Shown(subject), BytesBeside(FindLeastLimit(subject)), BytesOfVolume(GetVolumeBytes(subject))
{
}

Record Bench::Measure(const Point& point)
{
  Record record{ this->Shown.Name, point.Mapper, point.Knob, point.Value };
  Placed placed(this->Shown, point, this->BytesBeside, this->BytesOfVolume);
  testing::Picture drawn;
  const auto messages = testing::Listen(
    [&]
    {
      placed.Time();
      std::vector<double> times;
      for (int frame = 0; frame < 5; ++frame)
      {
        times.push_back(placed.Time());
      }
      record.Milliseconds = GetMedian(times);
      drawn = placed.Draw();
    });
  if (!messages.Errors.empty() || IsEmpty(drawn))
  {
    throw std::runtime_error(
      messages.Errors.empty() ? "it draws nothing" : messages.Errors.front());
  }
  if (auto* ours = placed.GetOurs())
  {
    record.Bytes = double(ours->GetMemoryInBytes());
    ours->CountSamplesOn();
    placed.Time();
    record.SamplesPerRay = ours->GetSamplesPerRay();
    record.FetchesPerRay = ours->GetFetchesPerRay();
  }
  record.Error = CompareWithReference(this->Shown, drawn);
  record.Width = this->Shown.GetWidth();
  record.Pixels = ToBytes(drawn);
  return record;
}

Duel Bench::TimeInTurns(const Point& first, const Point& second)
{
  Placed a(this->Shown, first, this->BytesBeside, this->BytesOfVolume);
  Placed b(this->Shown, second, this->BytesBeside, this->BytesOfVolume);
  a.Time();
  b.Time();
  std::vector<double> timesA;
  std::vector<double> timesB;
  for (int frame = 0; frame < 9; ++frame)
  {
    timesA.push_back(a.Time());
    timesB.push_back(b.Time());
  }
  return { GetMedian(timesA), GetMedian(timesB) };
}
} // namespace flatblock::benchmarks
