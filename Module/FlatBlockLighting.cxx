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
  Vectors Diffuse = {};
  Vectors Specular = {};
};

void Append(vtkLight* light, vtkVolumeProperty* material, Lights& lights)
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
    lights.Ambient[axis] +=
      static_cast<float>(material->GetAmbient() * intensity * light->GetAmbientColor()[axis]);
    lights.Direction[i][axis] = static_cast<float>(direction[axis]);
    lights.Diffuse[i][axis] =
      static_cast<float>(material->GetDiffuse() * intensity * light->GetDiffuseColor()[axis]);
    lights.Specular[i][axis] =
      static_cast<float>(material->GetSpecular() * intensity * light->GetSpecularColor()[axis]);
  }
}

Lights GetLights(vtkRenderer* renderer, vtkVolumeProperty* material)
{
  Lights lights;
  vtkLightCollection* all = renderer->GetLights();
  vtkCollectionSimpleIterator place;
  all->InitTraversal(place);
  while (vtkLight* light = all->GetNextLight(place))
  {
    if (light->GetSwitch() != 0 && lights.Count < MostLights)
    {
      Append(light, material, lights);
    }
  }
  if (lights.Count == 1 && std::equal(lights.Direction[0], lights.Direction[0] + 3, NoDirection))
  {
    std::fill_n(lights.Ambient, 3, static_cast<float>(material->GetAmbient()));
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
} // namespace

void SetGradientScale(
  vtkShaderProgram* program, vtkMatrix4x4* sampleToDataSet, const ComponentTables& tables)
{
  constexpr double ShareOfRange = 0.25;
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = std::hypot(sampleToDataSet->GetElement(0, axis),
      sampleToDataSet->GetElement(1, axis), sampleToDataSet->GetElement(2, axis));
  }
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
}

void SetLighting(vtkRenderer* renderer, vtkShaderProgram* program, vtkVolumeProperty* material,
  vtkMatrix4x4* sampleToWorld)
{
  SetGradientToWorld(program, sampleToWorld);
  const Lights lights = GetLights(renderer, material);
  program->SetUniformi("in_Lights", lights.Count);
  program->SetUniform3fv("in_LightDirection", MostLights, lights.Direction);
  program->SetUniform3fv("in_LightDiffuse", MostLights, lights.Diffuse);
  program->SetUniform3fv("in_LightSpecular", MostLights, lights.Specular);
  program->SetUniform3f("in_Ambient", lights.Ambient);
  program->SetUniformf("in_SpecularPower", static_cast<float>(material->GetSpecularPower()));
  program->SetUniformi("in_TwoSidedLighting", renderer->GetTwoSidedLighting());
}
} // namespace flatblock
