/// Scenes whose pictures are compared with those of the reference. Samples are of 16 bit or floats:
/// software OpenGL filters textures of 8 bit with arithmetic of 8 bit.
#pragma once

#include "CtLike.h"
#include "FloatPicture.h"
#include "Volumes.h"

#include "vtkImageCast.h"
#include "vtkImageShrink3D.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace flatblock::benchmarks
{
/// Pixels from one that the reference draws to the next.
constexpr int Stride = 4;

struct Subject
{
  std::string Name;
  std::string Description;
  double Voxel = 1.0; ///< smallest spacing
  testing::Scene Shown;
  testing::Picture Reference; ///< every Stride-th pixel of every Stride-th row

  int GetWidth() { return this->Shown.Window->GetSize()[0]; }

  /// What all measurements begin with.
  void Reset()
  {
    vtkFlatBlockVolumeMapper* mapper = this->Shown.Mapper;
    mapper->SetClassificationToPreIntegrated();
    mapper->SetSampleDistance(0.5 * this->Voxel);
    mapper->SetEarlyTerminationThreshold(1.0);
    mapper->UseJitteringOff();
    mapper->AdaptiveSamplingOn();
    mapper->SetBlockSize(33);
    mapper->SetMaxMemoryInBytes(vtkTypeInt64(256) << 20);
  }
};

using Subjects = std::vector<std::unique_ptr<Subject>>;

constexpr int Side = 64;

/// The signal of MarschnerLobb(), of spacing 1 and without rounding.
inline double MarschnerLobbAt(int i, int j, int k)
{
  const double pi = vtkMath::Pi();
  const auto at = [](int index) { return -1.0 + 2.0 * index / (Side - 1); };
  const double wave = std::cos(12.0 * pi * std::cos(0.5 * pi * std::hypot(at(i), at(j))));
  return 255.0 * (1.0 - std::sin(0.5 * pi * at(k)) + 0.25 * (1.0 + wave)) / 2.5;
}

/// Smooth, from 0 to 4000.
inline double WavesAt(int i, int j, int k)
{
  const double sum =
    std::sin(0.21 * i + 0.4) + std::cos(0.17 * j - 0.12 * i) + std::sin(0.19 * k + 0.08 * j);
  return std::round(4000.0 * (sum + 3.0) / 6.0);
}

/// Uniform in [0, 1], without any relation between samples.
inline double NoiseAt(int i, int j, int k)
{
  return Hash(Hash(Hash(i) + j) + k) / 4294967295.0;
}

inline std::unique_ptr<Subject> MakeSubject(
  const std::string& name, const std::string& description, vtkImageData* image)
{
  auto subject = std::make_unique<Subject>();
  subject->Name = name;
  subject->Description = description;
  const double* spacing = image->GetSpacing();
  subject->Voxel = std::min({ spacing[0], spacing[1], spacing[2] });
  subject->Shown.SetVolume(image, subject->Voxel);
  subject->Shown.Property->SetScalarOpacityUnitDistance(subject->Voxel);
  subject->Shown.LookFrom(30.0, 20.0, 1.2);
  return subject;
}

inline void ClassifyShell(testing::Scene& scene)
{
  scene.SetOpacity({ { 118.0, 0.0 }, { 122.0, 0.9 }, { 126.0, 0.0 } });
  scene.SetColor({ { 118.0, 0.1, 0.3, 0.9 }, { 122.0, 0.9, 0.9, 0.8 }, { 126.0, 0.9, 0.2, 0.1 } });
}

/// Values and their type may differ from those of the scene.
inline std::unique_ptr<Subject> MakeShell(
  int scalarType = VTK_FLOAT, double (*field)(int, int, int) = MarschnerLobbAt)
{
  auto subject = MakeSubject("thin shell",
    "the Marschner-Lobb signal in floats, from 0 to 255; opacity rises from 0 at 118 to 0.9 at 122 "
    "and falls to 0 at 126, which is less than a voxel where the signal is steep; the colour "
    "changes across the shell",
    testing::MakeVolume({ Side, Side, Side }, scalarType, field));
  ClassifyShell(subject->Shown);
  return subject;
}

inline std::unique_ptr<Subject> MakeFog()
{
  auto subject = MakeSubject("dense fog",
    "sinusoids of 16 bit, from 0 to 4000; opacity from 0.02 to 0.3 and three colours",
    testing::MakeVolume({ Side, Side, Side }, VTK_UNSIGNED_SHORT, WavesAt));
  subject->Shown.SetOpacity({ { 0.0, 0.02 }, { 4000.0, 0.3 } });
  subject->Shown.SetColor(
    { { 0.0, 0.1, 0.2, 0.9 }, { 2000.0, 0.9, 0.8, 0.2 }, { 4000.0, 0.9, 0.1, 0.2 } });
  return subject;
}

inline std::unique_ptr<Subject> MakeOpaque()
{
  auto subject = MakeSubject("opaque surface",
    "the same sinusoids; opacity rises from 0 at 2200 to 1 at 2220, and the colour changes behind "
    "the surface",
    testing::MakeVolume({ Side, Side, Side }, VTK_UNSIGNED_SHORT, WavesAt));
  subject->Shown.SetOpacity({ { 2200.0, 0.0 }, { 2220.0, 1.0 } });
  subject->Shown.SetColor(
    { { 2200.0, 0.9, 0.8, 0.6 }, { 2600.0, 0.7, 0.2, 0.1 }, { 3600.0, 0.1, 0.3, 0.8 } });
  return subject;
}

inline std::unique_ptr<Subject> MakeNoise()
{
  auto subject = MakeSubject("noise", "random floats from 0 to 1; a translucent ramp over them",
    testing::MakeVolume({ Side, Side, Side }, VTK_FLOAT, NoiseAt));
  subject->Shown.SetRamp(0.3, 0.8, 0.2);
  return subject;
}

/// Every second sample along each axis, so that it takes no longer than the others. Nothing where
/// the file is not there.
inline std::unique_ptr<Subject> MakeMRI()
{
  const auto mri = testing::ReadMRI();
  if (!mri)
  {
    return {};
  }
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputData(*mri);
  shrink->SetShrinkFactors(2, 2, 2);
  shrink->MeanOff();
  vtkNew<vtkImageCast> cast;
  cast->SetInputConnection(shrink->GetOutputPort());
  cast->SetOutputScalarTypeToUnsignedShort();
  cast->Update();
  auto subject = MakeSubject("MRI",
    "ch2better of `mricron-data`, every second sample along each axis, as 16 bit; a translucent "
    "ramp",
    cast->GetOutput());
  subject->Shown.SetRamp(40.0, 160.0, 0.3);
  return subject;
}

inline Subjects MakeSubjects()
{
  Subjects subjects;
  subjects.push_back(MakeShell());
  subjects.push_back(MakeFog());
  subjects.push_back(MakeOpaque());
  subjects.push_back(MakeNoise());
  if (auto mri = MakeMRI())
  {
    subjects.push_back(std::move(mri));
  }
  for (const auto& subject : subjects)
  {
    subject->Reset();
    subject->Shown.Window->Render();
    subject->Reference = testing::DrawReference(subject->Shown, Stride);
  }
  return subjects;
}

/// The one of that name; there is one.
inline Subject& Find(const Subjects& subjects, const std::string& name)
{
  return **std::find_if(subjects.begin(), subjects.end(),
    [&name](const std::unique_ptr<Subject>& subject) { return subject->Name == name; });
}
} // namespace flatblock::benchmarks
