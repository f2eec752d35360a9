#include "FlatBlockBlending.h"

#include "FlatBlockVolumeInput.h"
#include "RaySampling.h"
#include "ViewRegion.h"

#include "vtkContourValues.h"
#include "vtkPlane.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace flatblock
{
namespace
{
// As many uniforms as every driver with OpenGL 3.2 has, with room for all others.
constexpr int MostIsoValues = 256;

std::vector<double> GetIsoValues(vtkVolumeProperty* property)
{
  vtkContourValues* contours = property->GetIsoSurfaceValues();
  const int count = contours->GetNumberOfContours();
  if (count < 1 || count > MostIsoValues)
  {
    throw std::runtime_error("Isosurface blending needs 1 to " + std::to_string(MostIsoValues) +
                             " values in vtkVolumeProperty::GetIsoSurfaceValues(), which has " +
                             std::to_string(count) + ".");
  }
  std::vector<double> values(contours->GetValues(), contours->GetValues() + count);
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
  {
    throw std::runtime_error("A value of vtkVolumeProperty::GetIsoSurfaceValues() is not finite.");
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

void CheckSlice(vtkVolumeProperty* property)
{
  vtkImplicitFunction* function = property->GetSliceFunction();
  if (!vtkPlane::SafeDownCast(function))
  {
    throw std::runtime_error(
      "Slice blending needs a vtkPlane in vtkVolumeProperty::SetSliceFunction(), not " +
      std::string(function ? function->GetClassName() : "nothing") + ".");
  }
}

// Of dependent ones there is no value to add up, and of several none that a surface has.
void CheckComponents(const Components& components, const Blending& blending)
{
  const bool isSurface =
    blending.Mode == BlendMode::Isosurface || blending.Mode == BlendMode::Slice;
  const bool isSum = blending.Mode == BlendMode::Average || blending.Mode == BlendMode::Additive;
  if (components.Numbers.size() > 1 && (isSurface || (isSum && !components.AreIndependent)))
  {
    throw std::runtime_error(
      std::string(isSurface ? "Isosurfaces and slices" : "Sums of dependent components") + " of " +
      std::to_string(components.Numbers.size()) +
      " components cannot be drawn. SetVectorMode() takes one of them, or their magnitude.");
  }
}

float ToTable(const TransferTable& table, double value)
{
  constexpr double Most = 1e30; // so that it is a float
  return static_cast<float>(std::clamp(table.GetPosition(value), -Most, Most));
}
} // namespace

Blending GetBlending(
  vtkVolumeMapper* mapper, vtkVolumeProperty* property, const Components& components)
{
  Blending blending;
  switch (mapper->GetBlendMode())
  {
  case vtkVolumeMapper::COMPOSITE_BLEND:
    break;
  case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
    blending.Mode = BlendMode::Maximum;
    break;
  case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
    blending.Mode = BlendMode::Minimum;
    break;
  case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
    blending.Mode = BlendMode::Average;
    mapper->GetAverageIPScalarRange(blending.AverageRange.data());
    break;
  case vtkVolumeMapper::ADDITIVE_BLEND:
    blending.Mode = BlendMode::Additive;
    break;
  case vtkVolumeMapper::ISOSURFACE_BLEND:
    blending.Mode = BlendMode::Isosurface;
    blending.IsoValues = GetIsoValues(property);
    break;
  case vtkVolumeMapper::SLICE_BLEND:
    blending.Mode = BlendMode::Slice;
    CheckSlice(property);
    break;
  default:
    throw std::runtime_error(
      "There is no blend mode " + std::to_string(mapper->GetBlendMode()) + ".");
  }
  CheckComponents(components, blending);
  return blending;
}

void SetBlending(vtkShaderProgram* program, const RaySampling& sampling, const Clipping& clipping,
  const ComponentTables& tables)
{
  const Blending& blending = sampling.Blending;
  if (blending.HasSurfaces())
  {
    program->SetUniformf("in_EnoughOpacity", static_cast<float>(sampling.EnoughOpacity));
  }
  if (blending.Mode == BlendMode::Average)
  {
    float ranges[4][2] = {};
    for (std::size_t i = 0; i < tables.size() && i < 4; ++i)
    {
      const auto last = static_cast<float>(tables[i].Table->GetEntries().size() - 1);
      ranges[i][0] = ToTable(*tables[i].Table, blending.AverageRange[0]) / last;
      ranges[i][1] = ToTable(*tables[i].Table, blending.AverageRange[1]) / last;
    }
    program->SetUniform2fv("in_AverageRanges", sampling.Components, ranges);
  }
  else if (blending.Mode == BlendMode::Additive)
  {
    program->SetUniformf(
      "in_OpacityUnits", static_cast<float>(sampling.UnitOfLength / sampling.UnitOfOpacity));
  }
  else if (blending.Mode == BlendMode::Isosurface)
  {
    std::vector<float> positions(blending.IsoValues.size());
    std::transform(blending.IsoValues.begin(), blending.IsoValues.end(), positions.begin(),
      [&tables](double value) { return ToTable(*tables.front().Table, value); });
    program->SetUniform1fv("in_IsoValues", static_cast<int>(positions.size()), positions.data());
  }
  else if (clipping.Slice)
  {
    float plane[4];
    std::copy(clipping.Slice->begin(), clipping.Slice->end(), plane);
    program->SetUniform4f("in_Slice", plane);
  }
}
} // namespace flatblock
