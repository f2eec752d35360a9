#include "vtkFlatBlockScalars.h"

#include "FlatBlockVolumeInput.h"
#include "Interruption.h"

#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <vector>

vtkStandardNewMacro(vtkFlatBlockScalars);

vtkFlatBlockScalars::vtkFlatBlockScalars() = default;
vtkFlatBlockScalars::~vtkFlatBlockScalars() = default;

namespace
{
using Array = vtkSmartPointer<vtkDataArray>;

// Of one component. VTK's own way ends the process where memory is short, in builds with asserts.
Array Allocate(int type, vtkIdType values)
{
  Array array = Array::Take(vtkDataArray::CreateDataArray(type));
  void* memory = std::malloc(static_cast<std::size_t>(values) * array->GetDataTypeSize());
  if (!memory)
  {
    throw std::bad_alloc();
  }
  array->SetVoidArray(memory, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return array;
}

// Now and then, in loops over samples.
void CheckInterruptionAt(vtkIdType sample)
{
  constexpr vtkIdType Often = 1 << 14;
  if (sample % Often == 0)
  {
    flatblock::CheckInterruption();
  }
}

// Bits are packed eight to a byte, which neither kernels nor textures can read.
Array UnpackBits(const Array& values)
{
  auto* bits = vtkBitArray::SafeDownCast(values);
  if (!bits)
  {
    return values;
  }
  const vtkIdType count = bits->GetNumberOfValues();
  Array bytes = Allocate(VTK_UNSIGNED_CHAR, count);
  auto* to = static_cast<unsigned char*>(bytes->GetVoidPointer(0));
  for (vtkIdType i = 0; i < count; ++i)
  {
    CheckInterruptionAt(i);
    to[i] = static_cast<unsigned char>(bits->GetValue(i));
  }
  bytes->SetNumberOfComponents(bits->GetNumberOfComponents());
  return bytes;
}

// Integers of up to 24 bits are exact in the smaller one.
Array AllocateReals(int type, vtkIdType values)
{
  const bool isSmall = type == VTK_CHAR || type == VTK_SIGNED_CHAR || type == VTK_UNSIGNED_CHAR ||
                       type == VTK_SHORT || type == VTK_UNSIGNED_SHORT || type == VTK_FLOAT;
  return Allocate(isSmall ? VTK_FLOAT : VTK_DOUBLE, values);
}

Array TakeMagnitude(const Array& vectors)
{
  Array norms = AllocateReals(vectors->GetDataType(), vectors->GetNumberOfTuples());
  std::vector<double> vector(vectors->GetNumberOfComponents());
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    CheckInterruptionAt(i);
    vectors->GetTuple(i, vector.data());
    double sum = 0.0;
    for (const double value : vector)
    {
      sum += value * value;
    }
    norms->SetComponent(i, 0, std::sqrt(sum));
  }
  return norms;
}

template <typename T>
void CopyComponent(const T* from, T* to, vtkIdType count, int components)
{
  constexpr vtkIdType PerTurn = 1 << 20;
  flatblock::ParallelLoop loop;
#pragma omp parallel for
  for (vtkIdType first = 0; first < count; first += PerTurn)
  {
    loop.Do(
      [&]
      {
        for (vtkIdType i = first; i < std::min(first + PerTurn, count); ++i)
        {
          to[i] = from[i * components];
        }
      });
  }
  loop.Finish();
}

Array TakeComponent(const Array& values, int component)
{
  if (component == vtkFlatBlockScalars::Magnitude)
  {
    return TakeMagnitude(values);
  }
  if (values->GetNumberOfComponents() == 1)
  {
    return values;
  }
  Array one = Allocate(values->GetDataType(), values->GetNumberOfTuples());
  switch (values->GetDataType())
  {
    vtkTemplateMacro(CopyComponent(static_cast<const VTK_TT*>(values->GetVoidPointer(component)),
      static_cast<VTK_TT*>(one->GetVoidPointer(0)), values->GetNumberOfTuples(),
      values->GetNumberOfComponents()));
  }
  return one;
}

bool HasAny(vtkUnsignedCharArray* ghosts, int hidden)
{
  return ghosts &&
         std::any_of(ghosts->GetPointer(0), ghosts->GetPointer(0) + ghosts->GetNumberOfValues(),
           [hidden](unsigned char bits) { return (bits & hidden) != 0; });
}

Array Blank(const Array& values, vtkUnsignedCharArray* ghosts, int hidden, vtkTypeInt64& count)
{
  Array blanked = AllocateReals(values->GetDataType(), values->GetNumberOfTuples());
  blanked->InsertTuples(0, values->GetNumberOfTuples(), 0, values);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    CheckInterruptionAt(i);
    if ((ghosts->GetValue(i) & hidden) != 0)
    {
      blanked->SetComponent(i, 0, std::numeric_limits<double>::quiet_NaN());
      ++count;
    }
  }
  return blanked;
}

// One more on each side, the same as the outermost.
Array Surround(const Array& values, const flatblock::Index3& cells)
{
  Array padded = Allocate(
    values->GetDataType(), static_cast<vtkIdType>(cells[0] + 2) * (cells[1] + 2) * (cells[2] + 2));
  vtkIdType to = 0;
  for (int z = -1; z <= cells[2]; ++z)
  {
    for (int y = -1; y <= cells[1]; ++y)
    {
      flatblock::CheckInterruption();
      const vtkIdType row = (static_cast<vtkIdType>(std::clamp(z, 0, cells[2] - 1)) * cells[1] +
                              std::clamp(y, 0, cells[1] - 1)) *
                            cells[0];
      padded->InsertTuples(to, 1, row, values);
      padded->InsertTuples(to + 1, cells[0], row, values);
      padded->InsertTuples(to + 1 + cells[0], 1, row + cells[0] - 1, values);
      to += cells[0] + 2;
    }
  }
  return padded;
}

flatblock::Index3 CountSamples(const flatblock::VolumeInput& input)
{
  flatblock::Index3 samples;
  input.Image->GetDimensions(samples.data());
  for (int& axis : samples)
  {
    axis += input.IsCellData ? 1 : 0; // one cell less than points, and two more around
  }
  return samples;
}

// Values of points as they are, those of cells with others around.
Array ToSamples(const Array& values, const flatblock::VolumeInput& input)
{
  const flatblock::Index3 samples = CountSamples(input);
  return input.IsCellData ? Surround(values, { samples[0] - 2, samples[1] - 2, samples[2] - 2 })
                          : values;
}

Array NumberLabels(const Array& mask, const std::vector<int>& labels, bool hasLabels)
{
  Array numbers = Allocate(VTK_UNSIGNED_CHAR, mask->GetNumberOfTuples());
  auto* to = static_cast<unsigned char*>(numbers->GetVoidPointer(0));
  for (vtkIdType i = 0; i < mask->GetNumberOfTuples(); ++i)
  {
    CheckInterruptionAt(i);
    const double value = mask->GetComponent(i, 0);
    const auto place = std::find(labels.begin(), labels.end(), value);
    const bool isFound = place != labels.end() && value != 0.0;
    const auto number = isFound ? place - labels.begin() + 1 : 0;
    to[i] = static_cast<unsigned char>(hasLabels ? number : (value != 0.0 ? 1 : 0));
  }
  return numbers;
}
} // namespace

void vtkFlatBlockScalars::UpdateMask(
  const flatblock::VolumeInput& input, const std::vector<int>& labels)
{
  vtkDataArray* mask = input.Mask->GetPointData()->GetScalars();
  const void* samples = mask->GetVoidPointer(0);
  const vtkMTimeType time = std::max(input.Mask->GetMTime(), input.Image->GetMTime());
  if (this->Values && this->BuiltSamples == samples && this->BuiltImageTime == time &&
      this->BuiltLabels == labels && this->BuiltWithLabels == input.HasLabels)
  {
    return;
  }
  this->Values = ToSamples(NumberLabels(UnpackBits(mask), labels, input.HasLabels), input);
  this->Samples = CountSamples(input);
  this->BuiltSamples = samples;
  this->BuiltImageTime = time;
  this->BuiltLabels = labels;
  this->BuiltWithLabels = input.HasLabels;
  this->Modified();
}

void vtkFlatBlockScalars::Update(
  const flatblock::VolumeInput& input, vtkDataArray* array, int component)
{
  const void* samples = array->GetVoidPointer(0);
  const vtkMTimeType imageTime = input.Image->GetMTime();
  if (this->Values && this->BuiltSamples == samples && this->BuiltImageTime == imageTime &&
      this->BuiltComponent == component)
  {
    return;
  }
  vtkTypeInt64 blanked = 0;
  Array values = ToSamples(TakeComponent(UnpackBits(array), component), input);
  vtkImageData* image = input.Image;
  const bool hidesPoints = HasAny(image->GetPointGhostArray(), vtkDataSetAttributes::HIDDENPOINT);
  const bool hidesCells = HasAny(image->GetCellGhostArray(), vtkDataSetAttributes::HIDDENCELL);
  if (input.IsCellData ? hidesCells : hidesPoints)
  {
    const int hidden = input.IsCellData ? int(vtkDataSetAttributes::HIDDENCELL)
                                        : int(vtkDataSetAttributes::HIDDENPOINT);
    const Array ghosts =
      ToSamples(input.IsCellData ? image->GetCellGhostArray() : image->GetPointGhostArray(), input);
    values = Blank(values, vtkUnsignedCharArray::SafeDownCast(ghosts), hidden, blanked);
  }
  this->IgnoredBlanks = !input.IsCellData && hidesCells;
  this->Blanked = blanked;
  this->Values = values;
  this->Samples = CountSamples(input);
  this->BuiltSamples = samples;
  this->BuiltImageTime = imageTime;
  this->BuiltComponent = component;
  this->Modified();
}

void vtkFlatBlockScalars::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Samples: " << this->Samples[0] << " " << this->Samples[1] << " "
     << this->Samples[2] << "\n";
  os << indent << "Blanked: " << this->Blanked << "\n";
}
