#include "vtkFlatBlockTransferFunction.h"

#include "vtkColorTransferFunction.h"
#include "vtkFlatBlockGradientFunction.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkFlatBlockTransferFunction);

namespace
{
constexpr int FewestEntries = 1024;
constexpr int EntriesPerEstimate = 4; // VTK's estimate has one entry between the closest nodes
constexpr int MostEntries = 8192;     // the width that every driver with OpenGL 3.2 takes

vtkMTimeType GetLastEdit(vtkVolumeProperty* property, int component)
{
  if (flatblock::HasTwoDimensions(property))
  {
    vtkImageData* function = property->GetTransferFunction2D(component);
    return std::max(property->GetMTime(), function ? function->GetMTime() : 0);
  }
  const vtkMTimeType color = property->GetColorChannels(component) == 1
                               ? property->GetGrayTransferFunction(component)->GetMTime()
                               : property->GetRGBTransferFunction(component)->GetMTime();
  return std::max(
    { property->GetMTime(), color, property->GetScalarOpacity(component)->GetMTime() });
}

template <typename Function>
int EstimateEntries(Function* function, const flatblock::ValueRange& range)
{
  if (function->GetSize() < 2)
  {
    return FewestEntries;
  }
  // Negative: the nodes are so close that the estimate overflowed.
  const int estimate = function->EstimateMinNumberOfSamples(range.Lowest, range.Highest);
  const int most = MostEntries / EntriesPerEstimate;
  return estimate < 0 || estimate > most ? MostEntries
                                         : std::max(estimate * EntriesPerEstimate, FewestEntries);
}

// Where opacity rises to 1 extinction rises without limit, and what lies between the last two
// entries counts as opaque: so it has to be little.
bool BecomesOpaque(vtkPiecewiseFunction* opacity, const flatblock::ValueRange& range)
{
  bool isBelow = false;
  bool isOpaque = false;
  for (int node = 0; node < opacity->GetSize(); ++node)
  {
    double values[4];
    opacity->GetNodeValue(node, values);
    isBelow = isBelow || values[1] < 1.0;
    isOpaque =
      isOpaque || (values[1] >= 1.0 && values[0] >= range.Lowest && values[0] <= range.Highest);
  }
  return isBelow && isOpaque;
}

// vtkColorTransferFunction::GetTable() leaves the entry that falls on the first node black where
// there are entries before it; GetColor() does not.
void RepairFirstNode(vtkColorTransferFunction* function, const flatblock::ValueRange& range,
  int count, std::vector<float>& colors)
{
  double node[6];
  const double span = range.Highest - range.Lowest;
  if (function->GetSize() == 0 || !(span > 0.0))
  {
    return;
  }
  function->GetNodeValue(0, node);
  const double entry = (node[0] - range.Lowest) / span * (count - 1);
  for (const double i : { std::floor(entry), std::ceil(entry) })
  {
    if (i >= 0.0 && i < count)
    {
      double color[3];
      function->GetColor(range.Lowest + i * span / (count - 1), color);
      std::copy_n(color, 3, colors.begin() + 3 * static_cast<std::ptrdiff_t>(i));
    }
  }
}

std::vector<float> SampleColors(
  vtkVolumeProperty* property, int component, const flatblock::ValueRange& range, int count)
{
  std::vector<float> colors(3 * static_cast<std::size_t>(count));
  if (property->GetColorChannels(component) == 1)
  {
    property->GetGrayTransferFunction(component)->GetTable(
      range.Lowest, range.Highest, count, colors.data(), 3);
    for (std::size_t i = 0; i < colors.size(); i += 3)
    {
      colors[i + 1] = colors[i + 2] = colors[i];
    }
  }
  else
  {
    vtkColorTransferFunction* function = property->GetRGBTransferFunction(component);
    function->GetTable(range.Lowest, range.Highest, count, colors.data());
    RepairFirstNode(function, range, count, colors);
  }
  return colors;
}

// What the functions give to values at equal distances.
struct SampledFunctions
{
  std::vector<float> Colors; // three a value
  std::vector<double> Opacities;
};

// Of a function of two dimensions each value has what is the most opaque with it.
SampledFunctions SampleTwoDimensions(vtkImageData* function, int count)
{
  const auto colors = flatblock::GetTwoDimensionalColors(function);
  const auto width = static_cast<std::size_t>(function->GetDimensions()[0]);
  SampledFunctions samples;
  for (int i = 0; i < count; ++i)
  {
    const double share = i / std::max(count - 1.0, 1.0);
    std::size_t best = static_cast<std::size_t>(std::lround(share * (width - 1.0)));
    for (std::size_t texel = best; texel < colors.size(); texel += width)
    {
      best = colors[texel][3] > colors[best][3] ? texel : best;
    }
    samples.Colors.insert(samples.Colors.end(), colors[best].begin(), colors[best].begin() + 3);
    samples.Opacities.push_back(colors[best][3]);
  }
  return samples;
}

SampledFunctions SampleFunctions(
  vtkVolumeProperty* property, int component, const flatblock::ValueRange& range, int count)
{
  if (flatblock::HasTwoDimensions(property))
  {
    return SampleTwoDimensions(property->GetTransferFunction2D(component), count);
  }
  SampledFunctions samples = { SampleColors(property, component, range, count),
    std::vector<double>(count) };
  property->GetScalarOpacity(component)->GetTable(
    range.Lowest, range.Highest, count, samples.Opacities.data());
  return samples;
}

template <int Size, typename Function>
void CheckNodes(Function* function, const char* name)
{
  for (int node = 0; node < function->GetSize(); ++node)
  {
    double values[Size];
    function->GetNodeValue(node, values);
    if (!std::all_of(values, values + Size, [](double value) { return std::isfinite(value); }))
    {
      throw std::runtime_error("Node " + std::to_string(node) + " of the " + name +
                               " function has a value that is not finite.");
    }
  }
}

void CheckNodes(vtkVolumeProperty* property, int component)
{
  if (flatblock::HasTwoDimensions(property))
  {
    flatblock::GetTwoDimensionalColors(property->GetTransferFunction2D(component));
    return;
  }
  CheckNodes<4>(property->GetScalarOpacity(component), "opacity");
  if (property->GetColorChannels(component) == 1)
  {
    CheckNodes<4>(property->GetGrayTransferFunction(component), "gray");
  }
  else
  {
    CheckNodes<6>(property->GetRGBTransferFunction(component), "color");
  }
}
} // namespace

// Fine enough for the closest pair of nodes, with an entry at every integer where there is room.
int vtkFlatBlockTransferFunction::CountEntries(
  vtkVolumeProperty* property, int component, const flatblock::ValueRange& range)
{
  if (flatblock::HasTwoDimensions(property))
  {
    return property->GetTransferFunction2D(component)->GetDimensions()[0];
  }
  const double span = range.Highest - range.Lowest;
  if (span <= 0.0)
  {
    return 2;
  }
  int wanted = EstimateEntries(property->GetScalarOpacity(component), range);
  if (property->GetColorChannels(component) != 1)
  {
    wanted = std::max(wanted, EstimateEntries(property->GetRGBTransferFunction(component), range));
  }
  if (span == std::floor(span) && span < MostEntries)
  {
    const int steps = static_cast<int>(span);
    const int repeats = std::max(1, std::min((wanted - 2) / steps + 1, (MostEntries - 1) / steps));
    return steps * repeats + 1;
  }
  return BecomesOpaque(property->GetScalarOpacity(component), range) ? MostEntries : wanted;
}

bool vtkFlatBlockTransferFunction::Update(vtkVolumeProperty* property, int component,
  const flatblock::ValueRange& range, double unitOfLength, const flatblock::Blending& blending,
  int fewestEntries)
{
  const vtkMTimeType edited = GetLastEdit(property, component);
  if (this->BuiltProperty == property && this->BuiltComponent == component &&
      this->BuiltTime == edited && this->BuiltFewest == fewestEntries &&
      this->BuiltUnit == unitOfLength && this->BuiltBlending == blending &&
      this->Table.GetLowest() == range.Lowest && this->Table.GetHighest() == range.Highest)
  {
    return false;
  }
  CheckNodes(property, component);
  const int count = std::max(CountEntries(property, component, range), fewestEntries);
  const auto [colors, opacities] = SampleFunctions(property, component, range, count);
  const double distance =
    blending.IsComposite() ? property->GetScalarOpacityUnitDistance(component) / unitOfLength : 1.0;
  std::vector<flatblock::TransferTable::Entry> entries(count);
  for (int i = 0; i < count; ++i)
  {
    entries[i] = { colors[3 * i], colors[3 * i + 1], colors[3 * i + 2],
      static_cast<float>(flatblock::GetExtinction(opacities[i], distance)) };
  }
  flatblock::TransferTable table(range.Lowest, range.Highest, std::move(entries));
  this->DecisiveValues = flatblock::GetDecisiveValues(table, blending);
  this->Table = std::move(table);
  this->BuiltBlending = blending;
  this->BuiltProperty = property;
  this->BuiltComponent = component;
  this->BuiltFewest = fewestEntries;
  this->BuiltTime = edited;
  this->BuiltUnit = unitOfLength;
  this->Modified();
  return true;
}

void vtkFlatBlockTransferFunction::UpdateClassified(
  vtkVolumeProperty* property, int component, const flatblock::ValueRange& range, bool everyInteger)
{
  constexpr int EntriesOfReals = 4096;
  const double span = range.Highest - range.Lowest;
  const int count = everyInteger ? static_cast<int>(span) + 1 : (span > 0.0 ? EntriesOfReals : 1);
  const vtkMTimeType edited = GetLastEdit(property, component);
  if (this->ClassifiedProperty == property && this->ClassifiedComponent == component &&
      this->ClassifiedEdit == edited &&
      this->Classified.GetColors().size() == static_cast<std::size_t>(count) &&
      this->Classified.GetLowest() == range.Lowest &&
      this->Classified.GetHighest() == range.Highest)
  {
    return;
  }
  const auto [colors, opacities] = SampleFunctions(property, component, range, count);
  std::vector<flatblock::ClassifiedColor> classified(count);
  for (int i = 0; i < count; ++i)
  {
    const float* color = &colors[3 * i];
    classified[i] = flatblock::ToClassifiedColor(color[0], color[1], color[2], opacities[i]);
  }
  this->Classified = flatblock::ClassifiedTable(range.Lowest, range.Highest, std::move(classified));
  this->ClassifiedProperty = property;
  this->ClassifiedComponent = component;
  this->ClassifiedEdit = edited;
  this->ClassifiedTime.Modified();
}

void vtkFlatBlockTransferFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfEntries: " << this->Table.GetEntries().size() << "\n";
}
