#include "FlatBlockComponents.h"

#include "RaySampling.h"

#include "vtkShaderProgram.h"

namespace flatblock
{
namespace
{
// Colours of their own are from 0 to 1 in floats, and up to the largest value in integers.
void SetColors(vtkShaderProgram* program, const ComponentTables& tables)
{
  float scale[3];
  float offset[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const ComponentTable& table = tables[i];
    scale[i] = static_cast<float>(table.Encoding.Scale / table.FullColor);
    offset[i] = static_cast<float>(table.Encoding.Offset / table.FullColor);
  }
  program->SetUniform3f("in_ColorScale", scale);
  program->SetUniform3f("in_ColorOffset", offset);
}

void SetEach(vtkShaderProgram* program, const RaySampling& sampling, const ComponentTables& tables)
{
  constexpr int Most = 4;
  int firstEntries[Most] = {};
  float lastEntries[Most] = {};
  float texelsToTables[Most][2] = {};
  float weights[Most] = {};
  int entries = 0;
  for (std::size_t i = 0; i < tables.size(); ++i)
  {
    const auto count = static_cast<int>(tables[i].Table->GetEntries().size());
    const std::array<double, 2> line = GetTexelToTable(tables[i]);
    firstEntries[i] = entries;
    lastEntries[i] = static_cast<float>(count - 1);
    texelsToTables[i][0] = static_cast<float>(line[0]);
    texelsToTables[i][1] = static_cast<float>(line[1]);
    weights[i] = static_cast<float>(tables[i].Weight);
    entries += count;
  }
  const auto count = static_cast<int>(tables.size());
  program->SetUniform1iv("in_FirstEntries", count, firstEntries);
  program->SetUniform1fv("in_LastEntries", count, lastEntries);
  program->SetUniform2fv("in_TexelsToTables", count, texelsToTables);
  if (sampling.AreIndependent)
  {
    program->SetUniform1fv("in_Weights", count, weights);
  }
  else if (count == Most)
  {
    SetColors(program, tables);
  }
}

void SetSecondArray(vtkShaderProgram* program, const ComponentTables& tables)
{
  const ComponentTable& second = tables.back();
  const std::array<double, 2> line = GetTexelToTable(second);
  const double last = static_cast<double>(second.Table->GetEntries().size()) - 1.0;
  const float toTable[2] = { static_cast<float>(line[0] / last),
    static_cast<float>(line[1] / last) };
  program->SetUniform2f("in_SecondToTable", toTable);
}

void SetMask(vtkShaderProgram* program, const RaySampling& sampling, const ComponentTables& tables,
  const MaskOptions& mask)
{
  if (sampling.Blending.IsComposite())
  {
    program->SetUniformi(
      "in_EntriesPerTable", static_cast<int>(tables.front().Table->GetEntries().size()));
  }
  program->SetUniformf("in_LowestLabel", static_cast<float>(mask.LowestLabel));
  if (sampling.Mask == MaskKind::Labels)
  {
    program->SetUniformf("in_MaskBlendFactor", static_cast<float>(mask.BlendFactor));
  }
}
} // namespace

void SetComponents(vtkShaderProgram* program, const RaySampling& sampling,
  const ComponentTables& tables, const MaskOptions& mask)
{
  if (sampling.Mask != MaskKind::None)
  {
    SetMask(program, sampling, tables, mask);
  }
  else if (sampling.HasSecondArray)
  {
    SetSecondArray(program, tables);
  }
  else
  {
    SetEach(program, sampling, tables);
  }
}
} // namespace flatblock
