#include "vtkFlatBlockVolumeMapperInternals.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <set>
#include <stdexcept>

// The mask of vtkFlatBlockVolumeMapper, and functions of its labels.

// Of each label that has functions a property of its own, with the default ones where it has none.
void vtkFlatBlockVolumeMapper::vtkInternals::SetLabels(vtkVolumeProperty* property)
{
  constexpr std::size_t MostLabels = 255;
  std::set<int> numbers = this->Input.HasLabels ? property->GetLabelMapLabels() : std::set<int>();
  numbers.erase(0);
  if (numbers.size() > MostLabels)
  {
    throw std::runtime_error(
      "A mask has at most 255 labels with functions, not " + std::to_string(numbers.size()) + ".");
  }
  auto& labels = this->Mask->Labels;
  const bool isSame = std::equal(numbers.begin(), numbers.end(), labels.begin(), labels.end(),
    [](int number, const auto& label) { return number == label->Number; });
  if (!isSame)
  {
    labels.clear();
    for (const int number : numbers)
    {
      labels.push_back(std::make_unique<flatblock::MaskChannel::Label>());
      labels.back()->Number = number;
    }
  }
  for (const auto& label : labels)
  {
    vtkColorTransferFunction* color = property->GetLabelColor(label->Number);
    vtkPiecewiseFunction* opacity = property->GetLabelScalarOpacity(label->Number);
    label->Property->SetScalarOpacity(opacity ? opacity : property->GetScalarOpacity());
    label->Property->SetScalarOpacityUnitDistance(property->GetScalarOpacityUnitDistance());
    if (color || property->GetColorChannels() != 1)
    {
      label->Property->SetColor(color ? color : property->GetRGBTransferFunction());
    }
    else
    {
      label->Property->SetColor(property->GetGrayTransferFunction());
    }
  }
}

// After UpdateMask(), which finds the labels. All tables have as many entries.
void vtkFlatBlockVolumeMapper::vtkInternals::UpdateLabelFunctions()
{
  const flatblock::ValueRange& range = this->Builder->GetRange();
  int entries = vtkFlatBlockTransferFunction::CountEntries(this->Property, 0, range);
  for (const auto& label : this->Mask->Labels)
  {
    entries =
      std::max(entries, vtkFlatBlockTransferFunction::CountEntries(label->Property, 0, range));
  }
  this->TransferFunction->Update(
    this->Property, 0, range, this->Sampling.UnitOfLength, this->Sampling.Blending, entries);
  for (const auto& label : this->Mask->Labels)
  {
    label->TransferFunction->Update(
      label->Property, 0, range, this->Sampling.UnitOfLength, this->Sampling.Blending, entries);
  }
}

bool vtkFlatBlockVolumeMapper::vtkInternals::UpdateMask(
  int blockSize, const vtkFlatBlockBuilder::Bricks& bricks)
{
  this->SetLabels(this->Property);
  std::vector<int> numbers;
  for (const auto& label : this->Mask->Labels)
  {
    numbers.push_back(label->Number);
  }
  vtkFlatBlockBuilder::Bricks subsampled = bricks;
  subsampled.Filter = flatblock::LevelFilter::Subsample;
  subsampled.MayBeSpline = false;
  subsampled.AreCoefficients = false;
  this->Mask->Scalars->UpdateMask(this->Input, numbers);
  return this->Mask->Builder->Update(this->Mask->Scalars, blockSize, subsampled);
}

// Whether a value of the block is seen by the functions of a label that it has.
bool vtkFlatBlockVolumeMapper::vtkInternals::IsMaskedBlockVisible(std::size_t block) const
{
  const flatblock::ValueRange& values = this->Builder->GetShownRanges()[block];
  const flatblock::ValueRange& labels = this->Mask->Builder->GetBlockRanges()[block];
  const auto shows = [&values](vtkFlatBlockTransferFunction* function)
  { return !function->GetDecisiveValues().IsTransparent(values.Lowest, values.Highest); };
  if (!this->Input.HasLabels)
  {
    return labels.Highest > 0.0 && shows(this->TransferFunction);
  }
  bool isVisible = shows(this->TransferFunction);
  for (int label = std::max(static_cast<int>(labels.Lowest), 1);
       label <= static_cast<int>(labels.Highest); ++label)
  {
    isVisible = isVisible || shows(this->Mask->Labels[label - 1]->TransferFunction);
  }
  return isVisible;
}
