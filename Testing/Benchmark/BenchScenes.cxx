#include "BenchScenes.h"

#include "BenchCranium.h"
#include "ReadVolume.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <stdexcept>

namespace flatblock::benchmarks
{
namespace
{
using MadeSubject = std::unique_ptr<Subject>;

// As medical viewers light theirs.
void Light(testing::Scene& scene)
{
  scene.Property->ShadeOn();
  scene.Property->SetAmbient(0.2);
  scene.Property->SetDiffuse(0.8);
  scene.Property->SetSpecular(0.3);
  scene.Property->SetSpecularPower(20.0);
}

MadeSubject MakeHead(const BenchOptions&)
{
  const auto mri = testing::ReadMRI();
  if (!mri)
  {
    return {};
  }
  vtkNew<vtkImageCast> cast;
  cast->SetInputData(*mri);
  cast->SetOutputScalarTypeToUnsignedShort();
  cast->Update();
  auto subject =
    MakeSubject("MRI", "ch2better of `mricron-data`, as 16 bit, shaded", cast->GetOutput());
  subject->Shown.SetOpacity({ { 40.0, 0.0 }, { 100.0, 0.05 }, { 160.0, 0.3 } });
  subject->Shown.SetColor(
    { { 40.0, 0.5, 0.3, 0.2 }, { 100.0, 0.9, 0.7, 0.5 }, { 160.0, 1.0, 1.0, 0.9 } });
  Light(subject->Shown);
  return subject;
}

vtkSmartPointer<vtkImageData> GenerateCt(int n)
{
  const auto samples = MakeCtLike({ n, n, n });
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  std::copy(samples.begin(), samples.end(), static_cast<std::uint16_t*>(image->GetScalarPointer()));
  return image;
}

MadeSubject MakeCt(const BenchOptions& options, bool isBone)
{
  const auto skull = ReadCranium();
  const double zero = skull ? 0.0 : 1024.0; // of Hounsfield units
  auto subject = MakeSubject(isBone ? "CT bone" : "CT skin",
    skull ? "the skull of `invesalius-examples`" : "a generated body with ribs, a spine and noise",
    skull ? skull : GenerateCt(options.Size));
  if (isBone)
  {
    subject->Shown.SetOpacity({ { zero + 200.0, 0.0 }, { zero + 500.0, 0.5 } });
    subject->Shown.SetColor({ { zero + 200.0, 0.8, 0.5, 0.4 }, { zero + 900.0, 1.0, 1.0, 0.9 } });
    Light(subject->Shown);
    return subject;
  }
  subject->Shown.SetOpacity(
    { { zero - 600.0, 0.0 }, { zero - 200.0, 0.2 }, { zero + 200.0, 0.3 } });
  subject->Shown.SetColor({ { zero - 600.0, 0.9, 0.6, 0.5 }, { zero + 400.0, 1.0, 0.9, 0.8 } });
  return subject;
}

MadeSubject MakeVessels(const BenchOptions& options)
{
  auto subject = MakeSubject("vessel tree", "random branching tubes of 16 bit; mostly empty",
    MakeVesselTree(options.Size, options.Seed));
  subject->Shown.SetOpacity({ { 200.0, 0.0 }, { 800.0, 0.7 } });
  subject->Shown.SetColor({ { 200.0, 0.7, 0.1, 0.1 }, { 1000.0, 1.0, 0.8, 0.6 } });
  return subject;
}

// A field of Side^3 samples, on as many as are asked for.
vtkSmartPointer<vtkImageData> Generate(
  int n, int type, const std::function<double(double, double, double)>& field)
{
  const double scale = double(Side - 1) / (n - 1);
  return testing::MakeVolume(
    { n, n, n }, type, [&](int i, int j, int k) { return field(i * scale, j * scale, k * scale); });
}

double SignalAt(double i, double j, double k)
{
  const double pi = vtkMath::Pi();
  const auto at = [](double index) { return -1.0 + 2.0 * index / (Side - 1); };
  const double wave = std::cos(12.0 * pi * std::cos(0.5 * pi * std::hypot(at(i), at(j))));
  return 255.0 * (1.0 - std::sin(0.5 * pi * at(k)) + 0.25 * (1.0 + wave)) / 2.5;
}

MadeSubject MakeFogOf(const BenchOptions& options)
{
  auto subject = MakeSubject("dense fog", "sinusoids of 16 bit; opacity from 0.02 to 0.3",
    Generate(options.Size, VTK_UNSIGNED_SHORT,
      [](double i, double j, double k)
      {
        return 4000.0 *
               (std::sin(0.21 * i + 0.4) + std::cos(0.17 * j - 0.12 * i) +
                 std::sin(0.19 * k + 0.08 * j) + 3.0) /
               6.0;
      }));
  subject->Shown.SetOpacity({ { 0.0, 0.02 }, { 4000.0, 0.3 } });
  subject->Shown.SetColor(
    { { 0.0, 0.1, 0.2, 0.9 }, { 2000.0, 0.9, 0.8, 0.2 }, { 4000.0, 0.9, 0.1, 0.2 } });
  return subject;
}

MadeSubject MakeSignal(const BenchOptions& options, bool isShell)
{
  auto subject = MakeSubject(isShell ? "thin shell" : "Marschner-Lobb",
    isShell ? "the Marschner-Lobb signal in floats; opacity only near 122 of 255"
            : "the Marschner-Lobb signal in floats, a translucent ramp",
    Generate(options.Size, VTK_FLOAT, SignalAt));
  if (isShell)
  {
    ClassifyShell(subject->Shown);
  }
  else
  {
    subject->Shown.SetRamp(90.0, 160.0, 0.4);
  }
  return subject;
}

MadeSubject MakeNoiseOf(const BenchOptions& options)
{
  const int n = options.Size;
  auto subject = MakeSubject("noise", "random floats from 0 to 1; a translucent ramp",
    testing::MakeVolume({ n, n, n }, VTK_FLOAT, NoiseAt));
  subject->Shown.SetRamp(0.3, 0.8, 0.2);
  return subject;
}

// The values below which the given shares of the samples lie.
std::array<double, 2> GetPercentiles(vtkImageData* image, double low, double high)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  std::vector<double> values;
  const vtkIdType stride = std::max<vtkIdType>(1, scalars->GetNumberOfTuples() / 1000000);
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); i += stride)
  {
    const double value = scalars->GetComponent(i, 0);
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }
  if (values.empty())
  {
    throw std::runtime_error("--input: the volume has no finite values.");
  }
  std::sort(values.begin(), values.end());
  const double last = double(values.size() - 1);
  return { values[std::size_t(low * last)], values[std::size_t(high * last)] };
}

MadeSubject MakeInput(const BenchOptions& options)
{
  Options file;
  file.File = options.Input;
  const auto image = ReadVolume(file).Image;
  const auto range = GetPercentiles(image, 0.5, 0.99);
  auto subject = MakeSubject("input", options.Input + "; a ramp over the 50..99 percentile", image);
  subject->Shown.SetRamp(range[0], std::max(range[1], range[0] + 1e-6), 0.3);
  return subject;
}
} // namespace

std::vector<BenchScene> ListScenes(const BenchOptions& options)
{
  using O = const BenchOptions&;
  std::vector<BenchScene> scenes = {
    { "thin shell", [](O o) { return MakeSignal(o, true); }, true },
    { "CT bone", [](O o) { return MakeCt(o, true); }, true },
    { "CT skin", [](O o) { return MakeCt(o, false); } },
    { "vessel tree", MakeVessels, true },
    { "dense fog", MakeFogOf },
    { "Marschner-Lobb", [](O o) { return MakeSignal(o, false); } },
    { "noise", MakeNoiseOf },
    { "MRI", MakeHead },
  };
  if (!options.Input.empty())
  {
    // First, so that a file which can't be read is told of at once.
    scenes.insert(scenes.begin(), { "input", MakeInput, true });
  }
  if (options.IsQuick)
  {
    scenes.erase(std::remove_if(scenes.begin(), scenes.end(),
                   [](const BenchScene& scene) { return !scene.IsQuick; }),
      scenes.end());
  }
  return scenes;
}

std::unique_ptr<Subject> PrepareScene(const BenchScene& scene, const BenchOptions& options)
{
  auto subject = scene.Make(options);
  if (!subject)
  {
    return {};
  }
  subject->Shown.Window->SetSize(options.Window, options.Window);
  subject->Shown.Renderer->SetBackground(0.0, 0.0, 0.0);
  subject->Shown.Volume->VisibilityOff();
  subject->Shown.Window->Render();
  subject->Reference = testing::DrawReference(subject->Shown, Stride);
  return subject;
}
} // namespace flatblock::benchmarks
