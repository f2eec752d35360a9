#include "FlatBlockClipping.h"

#include "ViewRegion.h"

#include "vtkShaderProgram.h"

#include <cmath>
#include <cstddef>

namespace flatblock
{
namespace
{
double GetLength(const std::array<double, 4>& plane)
{
  const double length = std::hypot(plane[0], plane[1], plane[2]);
  return length > 0.0 ? length : 1.0;
}

// On a scale where normals are 1 long, which single precision holds whatever the volume's units.
void SetPlanes(vtkShaderProgram* program, const Planes& planes)
{
  std::vector<float> numbers;
  for (const auto& plane : planes)
  {
    const double length = GetLength(plane);
    for (const double number : plane)
    {
      numbers.push_back(static_cast<float>(number / length));
    }
  }
  program->SetUniform4fv("in_ClippingPlanes", static_cast<int>(planes.size()),
    reinterpret_cast<const float(*)[4]>(numbers.data()));
}

void SetCropping(vtkShaderProgram* program, const CroppingRegions& cropping)
{
  float normals[3][3];
  float low[3];
  float high[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto& row = cropping.SampleToDataSet[axis];
    const double length = GetLength(row);
    for (std::size_t i = 0; i < 3; ++i)
    {
      normals[axis][i] = static_cast<float>(row[i] / length);
    }
    low[axis] = static_cast<float>((row[3] - cropping.Planes[2 * axis]) / length);
    high[axis] = static_cast<float>((row[3] - cropping.Planes[2 * axis + 1]) / length);
  }
  program->SetUniform3fv("in_CroppingNormals", 3, normals);
  program->SetUniform3f("in_CroppingLow", low);
  program->SetUniform3f("in_CroppingHigh", high);
  program->SetUniformi("in_CroppingFlags", cropping.Flags);
}
} // namespace

void SetClipping(vtkShaderProgram* program, const Clipping& clipping)
{
  if (!clipping.Planes.empty())
  {
    SetPlanes(program, clipping.Planes);
  }
  if (clipping.Cropping)
  {
    SetCropping(program, *clipping.Cropping);
  }
}
} // namespace flatblock
