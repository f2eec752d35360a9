#include "FlatBlockRayGeometry.h"

#include "RaySight.h"
#include "vtkCamera.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flatblock
{
namespace
{
using Row = std::array<double, 4>;

Row GetRow(vtkMatrix4x4* matrix, int row)
{
  return { matrix->GetElement(row, 0), matrix->GetElement(row, 1), matrix->GetElement(row, 2),
    matrix->GetElement(row, 3) };
}

Row Combine(const Row& a, double factor, const Row& b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2], a[3] + factor * b[3] };
}

double Apply(const Row& row, const std::array<float, 3>& point, double share)
{
  return share * (row[0] * point[0] + row[1] * point[1] + row[2] * point[2]) + row[3];
}

void SetRow(vtkShaderProgram* program, const char* name, const Row& row, double scale = 1.0)
{
  float values[4];
  std::transform(row.begin(), row.end(), values,
    [scale](double value) { return static_cast<float>(value * scale); });
  program->SetUniform4f(name, values);
}

void SetColumns(vtkShaderProgram* program, const char* name, const std::array<double, 9>& columns)
{
  float values[9];
  std::transform(
    columns.begin(), columns.end(), values, [](double value) { return static_cast<float>(value); });
  program->SetUniformMatrix3x3(name, values);
}

void SetSight(vtkShaderProgram* program, const RaySight& sight)
{
  SetColumns(program, "in_PixelToOrigin", sight.Origin);
  SetColumns(program, "in_PixelToSight", sight.Direction);
  SetRow(program, "in_Eye", sight.Eye);
}

std::array<float, 3> ToFloats(const Index3& index, int offset)
{
  return { static_cast<float>(index[0] + offset), static_cast<float>(index[1] + offset),
    static_cast<float>(index[2] + offset) };
}

// Planes are scaled and shifted so that little cancels in single precision, however far the camera
// and the origin are.
void SetPlanes(
  vtkShaderProgram* program, const std::array<float, 3>& lastSample, vtkMatrix4x4* sampleToClip)
{
  const Row z = GetRow(sampleToClip, 2);
  const Row w = GetRow(sampleToClip, 3);
  const Row nearPlane = Combine(z, 1.0, w);
  const double nearLength = std::hypot(nearPlane[0], nearPlane[1], nearPlane[2]);
  SetRow(program, "in_NearPlane", nearPlane, 1.0 / nearLength);

  const double centerZ = Apply(z, lastSample, 0.5);
  const double centerW = Apply(w, lastSample, 0.5);
  const auto depth =
    static_cast<float>(centerW > 0.0 ? std::clamp(centerZ / centerW, -1.0, 1.0) : 0.0);
  const double scale = centerW != 0.0 ? 1.0 / std::abs(centerW) : 1.0;
  program->SetUniformf("in_DepthOfCenter", depth);
  SetRow(program, "in_SampleToDepth", Combine(z, -depth, w), scale);
  SetRow(program, "in_SampleToClipW", w, scale);
}
} // namespace

// VTK's key matrices are transposed; from here on they are not.
std::array<double, 3> GetSpacing(vtkMatrix4x4* matrix)
{
  std::array<double, 3> spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = std::hypot(
      matrix->GetElement(0, axis), matrix->GetElement(1, axis), matrix->GetElement(2, axis));
  }
  return spacing;
}

void GetSampleToClip(vtkRenderer* renderer, vtkMatrix4x4* sampleToWorld, vtkMatrix4x4* sampleToClip)
{
  vtkMatrix4x4* view;
  vtkMatrix3x3* normal;
  vtkMatrix4x4* projection;
  vtkMatrix4x4* clip;
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  camera->GetKeyMatrices(renderer, view, normal, projection, clip);
  vtkNew<vtkMatrix4x4> worldToClip;
  vtkMatrix4x4::Transpose(clip, worldToClip);
  vtkMatrix4x4::Multiply4x4(worldToClip, sampleToWorld, sampleToClip);
}

void SetDirections(
  vtkShaderProgram* program, const char* name, vtkMatrix4x4* matrix, double unitOfLength)
{
  float columns[9];
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(matrix->GetElement(i % 3, i / 3) / unitOfLength);
  }
  program->SetUniformMatrix3x3(name, columns);
}

void SetRayGeometry(vtkRenderer* renderer, vtkShaderProgram* program, const RayGeometry& geometry)
{
  const bool parallel = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  vtkMatrix4x4* sampleToClip = geometry.SampleToClip;
  vtkNew<vtkMatrix4x4> clipToSample;
  vtkMatrix4x4::Invert(sampleToClip, clipToSample);
  SetSight(program,
    ComputeRaySight(sampleToClip->GetData(), clipToSample->GetData(), geometry.Samples, parallel));
  const auto lastSample = ToFloats(geometry.Samples, -1);
  program->SetUniform3f("in_LastSample", lastSample.data());
  SetDirections(program, "in_SampleToSteps", geometry.SampleToDataSet, geometry.Step);
  vtkNew<vtkMatrix4x4> columns;
  vtkMatrix4x4::Transpose(sampleToClip, columns);
  program->SetUniformMatrix("in_SampleToClip", columns);
  SetPlanes(program, lastSample, sampleToClip);
}
} // namespace flatblock
