#include "FlatBlockLighting.h"

#include "FlatBlockRayGeometry.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace flatblock
{
namespace
{
constexpr int MostLights = 6;
constexpr float NoDirection[3] = { 0.0F, 0.0F, 0.0F }; // of a headlight
using Vectors = float[MostLights][3];

struct Lights
{
  int Count = 0;
  Vectors Direction = {};
  float Ambient[3] = {};
  float ScatteredAmbient[3] = {};
  Vectors Diffuse = {};
  Vectors Specular = {};
  float Position[MostLights][4] = {};
  Vectors Attenuation = {};
  float Cone[MostLights][2] = {};
};

void Append(vtkLight* light, Lights& lights)
{
  const int i = lights.Count++;
  double direction[3] = { 0.0, 0.0, 0.0 };
  if (!light->LightTypeIsHeadlight())
  {
    double focalPoint[3];
    light->GetTransformedPosition(direction);
    light->GetTransformedFocalPoint(focalPoint);
    vtkMath::Subtract(direction, focalPoint, direction);
    vtkMath::Normalize(direction);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double intensity = light->GetIntensity();
    lights.Ambient[axis] += static_cast<float>(intensity * light->GetAmbientColor()[axis]);
    lights.Direction[i][axis] = static_cast<float>(direction[axis]);
    lights.Diffuse[i][axis] = static_cast<float>(intensity * light->GetDiffuseColor()[axis]);
    lights.Specular[i][axis] = static_cast<float>(intensity * light->GetSpecularColor()[axis]);
  }
}

bool IsPositional(vtkLight* light)
{
  return light->GetPositional() != 0 && !light->LightTypeIsHeadlight();
}

// An angle of more than 90 degrees is no cone, but all around.
void SetPlace(vtkLight* light, const double origin[3], int i, Lights& lights)
{
  constexpr double Widest = 90.0;
  double position[3];
  light->GetTransformedPosition(position);
  for (int axis = 0; axis < 3; ++axis)
  {
    lights.Position[i][axis] = static_cast<float>(position[axis] - origin[axis]);
    lights.Attenuation[i][axis] = static_cast<float>(light->GetAttenuationValues()[axis]);
  }
  lights.Position[i][3] = 1.0F;
  const double angle = light->GetConeAngle();
  const bool isCone = angle <= Widest;
  lights.Cone[i][0] =
    isCone ? static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(angle))) : -2.0F;
  lights.Cone[i][1] = isCone ? static_cast<float>(light->GetExponent()) : 0.0F;
}

// @param origin  the first sample in world coordinates
Lights GetLights(vtkRenderer* renderer, const double origin[3])
{
  Lights lights;
  vtkLightCollection* all = renderer->GetLights();
  vtkCollectionSimpleIterator place;
  all->InitTraversal(place);
  while (vtkLight* light = all->GetNextLight(place))
  {
    if (light->GetSwitch() != 0 && lights.Count < MostLights)
    {
      Append(light, lights);
      if (IsPositional(light))
      {
        SetPlace(light, origin, lights.Count - 1, lights);
      }
    }
  }
  std::copy_n(lights.Ambient, 3, lights.ScatteredAmbient);
  if (lights.Count == 1 && std::equal(lights.Direction[0], lights.Direction[0] + 3, NoDirection))
  {
    std::fill_n(lights.Ambient, 3, 1.0F);
  }
  return lights;
}

// Normals go with the inverse of the transpose. Their length does not matter, so the largest
// element becomes 1.
void SetGradientToWorld(vtkShaderProgram* program, vtkMatrix4x4* sampleToWorld)
{
  vtkNew<vtkMatrix4x4> normals;
  vtkMatrix4x4::Invert(sampleToWorld, normals);
  normals->Transpose();
  double largest = 1e-300;
  for (int i = 0; i < 9; ++i)
  {
    largest = std::max(largest, std::abs(normals->GetElement(i / 3, i % 3)));
  }
  SetDirections(program, "in_GradientToWorld", normals, largest);
}
void SetMaterials(vtkShaderProgram* program, vtkVolumeProperty* property)
{
  float materials[VTK_MAX_VRCOMP][4];
  for (int i = 0; i < VTK_MAX_VRCOMP; ++i)
  {
    const int component = property->GetIndependentComponents() ? i : 0;
    materials[i][0] = static_cast<float>(property->GetAmbient(component));
    materials[i][1] = static_cast<float>(property->GetDiffuse(component));
    materials[i][2] = static_cast<float>(property->GetSpecular(component));
    materials[i][3] = static_cast<float>(property->GetSpecularPower(component));
  }
  program->SetUniform4fv("in_Materials", VTK_MAX_VRCOMP, materials);
}
} // namespace

bool HasPositionalLights(vtkRenderer* renderer)
{
  vtkLightCollection* all = renderer->GetLights();
  vtkCollectionSimpleIterator place;
  all->InitTraversal(place);
  while (vtkLight* light = all->GetNextLight(place))
  {
    if (light->GetSwitch() != 0 && IsPositional(light))
    {
      return true;
    }
  }
  return false;
}

void SetGradientScale(vtkShaderProgram* program, vtkMatrix4x4* sampleToDataSet,
  const ComponentTables& tables, const RaySampling& sampling)
{
  constexpr double ShareOfRange = 0.25;
  const std::array<double, 3> spacing = GetSpacing(sampleToDataSet);
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  float scale[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    scale[axis] = static_cast<float>(mean / spacing[axis] / ShareOfRange);
  }
  program->SetUniform3f("in_GradientToTable", scale);
  std::vector<float> units(tables.size());
  std::transform(tables.begin(), tables.end(), units.begin(),
    [](const ComponentTable& component)
    {
      const double span = component.Table->GetHighest() - component.Table->GetLowest();
      return span > 0.0 ? static_cast<float>(component.Encoding.Scale / span) : 0.0F;
    });
  program->SetUniform1fv("in_GradientUnits", static_cast<int>(units.size()), units.data());
  if (sampling.HasGradientModulation())
  {
    float modulation[3];
    std::transform(sampling.GradientModulation.begin(), sampling.GradientModulation.end(),
      modulation, [](double share) { return static_cast<float>(share); });
    program->SetUniform3f("in_GradientModulation", modulation);
  }
}

void SetLighting(vtkRenderer* renderer, vtkShaderProgram* program, vtkVolumeProperty* property,
  vtkMatrix4x4* sampleToWorld)
{
  SetGradientToWorld(program, sampleToWorld);
  const double origin[3] = { sampleToWorld->GetElement(0, 3), sampleToWorld->GetElement(1, 3),
    sampleToWorld->GetElement(2, 3) };
  const Lights lights = GetLights(renderer, origin);
  program->SetUniformi("in_Lights", lights.Count);
  program->SetUniform3fv("in_LightDirection", MostLights, lights.Direction);
  if (HasPositionalLights(renderer))
  {
    program->SetUniform4fv("in_LightPosition", MostLights, lights.Position);
    program->SetUniform3fv("in_LightAttenuation", MostLights, lights.Attenuation);
    program->SetUniform2fv("in_LightCone", MostLights, lights.Cone);
  }
  program->SetUniform3fv("in_LightDiffuse", MostLights, lights.Diffuse);
  program->SetUniform3fv("in_LightSpecular", MostLights, lights.Specular);
  program->SetUniform3f("in_Ambient", lights.Ambient);
  program->SetUniform3f("in_ScatteredAmbient", lights.ScatteredAmbient);
  SetMaterials(program, property);
  program->SetUniformi("in_TwoSidedLighting", renderer->GetTwoSidedLighting());
}
} // namespace flatblock
