#include "vtkFlatBlockVolumeMapperInternals.h"

#include <algorithm>
#include <stdexcept>

// The components of the data that vtkFlatBlockVolumeMapper draws.

namespace
{
// The largest value of small integers; reals are from 0 to 1.
double GetFullColor(vtkDataArray* values)
{
  constexpr int MostBytes = 2;
  const int type = values->GetDataType();
  const bool isSmall =
    type != VTK_FLOAT && type != VTK_DOUBLE && values->GetDataTypeSize() <= MostBytes;
  return isSmall ? values->GetDataTypeMax() : 1.0;
}
} // namespace

// All anew where they are others than before: so whatever was made of them is out of date.
void vtkFlatBlockVolumeMapper::vtkInternals::SetChannels(
  const flatblock::VolumeInput& input, vtkVolumeProperty* property)
{
  const flatblock::Components& components = input.Components;
  const bool hasSecond = input.SecondScalars != nullptr;
  const std::size_t count =
    std::max<std::size_t>(components.Numbers.size(), 1) + (hasSecond ? 1 : 0);
  if (this->Channels.size() != count || this->AreIndependent != components.AreIndependent ||
      this->HasSecondArray != hasSecond || (this->Mask != nullptr) != (input.Mask != nullptr))
  {
    auto mask = input.Mask ? std::make_unique<flatblock::MaskChannel>() : nullptr;
    std::vector<std::unique_ptr<flatblock::Channel>> channels;
    for (std::size_t i = 0; i < count; ++i)
    {
      channels.push_back(std::make_unique<flatblock::Channel>());
    }
    this->Residency.Clear(); // of bricks that nobody knows any more
    this->Interleaved.reset();
    this->Mask = std::move(mask); // nothing from here on fails
    this->Channels.swap(channels);
    this->AreIndependent = components.AreIndependent;
    this->HasSecondArray = hasSecond;
  }
  std::size_t lead = hasSecond ? 0 : count - 1;
  for (std::size_t i = 0; components.AreIndependent && i < count; ++i)
  {
    this->Channels[i]->Weight = property->GetComponentWeight(static_cast<int>(i));
    lead = this->Channels[i]->Weight > this->Channels[lead]->Weight ? i : lead;
  }
  this->Lead = static_cast<int>(lead);
  this->Scalars = this->Channels[lead]->Scalars;
  this->Builder = this->Channels[lead]->Builder;
  this->TransferFunction = this->Channels[lead]->TransferFunction;
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateFunctions()
{
  std::vector<flatblock::ValueRange> ranges;
  for (const auto& channel : this->Channels)
  {
    ranges.push_back(channel->Builder->GetRange());
  }
  if (this->Mask)
  {
    this->UpdateLabelFunctions();
  }
  for (std::size_t i = 0; i < this->Channels.size() && !this->Mask; ++i)
  {
    this->Channels[i]->TransferFunction->Update(this->Property,
      this->AreIndependent ? static_cast<int>(i) : 0, ranges[i], this->Sampling.UnitOfLength,
      this->Sampling.Blending);
  }
  this->GradientFunction->Update(
    this->Property, ranges, this->AreIndependent, this->Sampling.UnitOfLength);
}

// The next frame builds all of them.
void vtkFlatBlockVolumeMapper::vtkInternals::ForgetBlocks()
{
  this->Residency.Clear();
  this->Interleaved.reset();
  for (const auto& channel : this->Channels)
  {
    channel->Builder->Forget();
  }
  if (this->Mask)
  {
    this->Mask->Builder->Forget();
  }
}

// Whether there are other bricks than before.
bool vtkFlatBlockVolumeMapper::vtkInternals::UpdateBuilders(
  int blockSize, const vtkFlatBlockBuilder::Bricks& bricks)
{
  bool isNew = this->Mask && this->UpdateMask(blockSize, bricks);
  for (std::size_t i = 0; i < this->Channels.size(); ++i)
  {
    const flatblock::Channel& channel = *this->Channels[i];
    const bool isSecond = i == this->Input.Components.Numbers.size();
    channel.Scalars->Update(this->Input, isSecond ? this->Input.SecondScalars : this->Input.Scalars,
      isSecond ? 0 : this->Input.Components.Numbers[i]);
    isNew = channel.Builder->Update(channel.Scalars, blockSize, bricks) || isNew;
  }
  if (isNew && !this->IsPlain())
  {
    std::vector<const flatblock::BrickSource*> sources;
    for (const auto& channel : this->Channels)
    {
      sources.push_back(&channel->Builder->GetSource());
    }
    if (this->Mask)
    {
      sources.push_back(&this->Mask->Builder->GetSource());
    }
    this->Interleaved =
      std::make_unique<flatblock::InterleavedBricks>(std::move(sources), this->Mask != nullptr);
  }
  return isNew;
}

const flatblock::BrickSource& vtkFlatBlockVolumeMapper::vtkInternals::GetSource() const
{
  return this->Interleaved ? *this->Interleaved : this->Builder->GetSource();
}

vtkTypeInt64 vtkFlatBlockVolumeMapper::vtkInternals::CountHoles() const
{
  vtkTypeInt64 holes = 0;
  for (const auto& channel : this->Channels)
  {
    holes += channel->Builder->GetNumberOfNonFiniteSamples();
  }
  return holes;
}

vtkMTimeType vtkFlatBlockVolumeMapper::vtkInternals::GetFunctionTime() const
{
  vtkMTimeType time = 0;
  for (const auto& channel : this->Channels)
  {
    time = std::max(time, channel->TransferFunction->GetMTime());
  }
  for (std::size_t i = 0; this->Mask && i < this->Mask->Labels.size(); ++i)
  {
    time = std::max(time, this->Mask->Labels[i]->TransferFunction->GetMTime());
  }
  return time;
}

flatblock::ComponentTables vtkFlatBlockVolumeMapper::vtkInternals::GetTables() const
{
  flatblock::ComponentTables components;
  for (const auto& channel : this->Channels)
  {
    components.push_back(
      { &channel->TransferFunction->GetTable(), channel->Builder->GetSource().GetEncoding(),
        channel->Weight, GetFullColor(channel->Scalars->GetValues()) });
  }
  for (std::size_t i = 0; this->Mask && i < this->Mask->Labels.size(); ++i)
  {
    components.push_back({ &this->Mask->Labels[i]->TransferFunction->GetTable(),
      this->Builder->GetSource().GetEncoding(), 1.0, 1.0 });
  }
  return components;
}

bool vtkFlatBlockVolumeMapper::vtkInternals::IsBlockVisible(std::size_t block) const
{
  const auto shows = [block](const flatblock::Channel& channel)
  {
    const flatblock::ValueRange& range = channel.Builder->GetShownRanges()[block];
    return !channel.TransferFunction->GetDecisiveValues().IsTransparent(
      range.Lowest, range.Highest);
  };
  if (this->Mask)
  {
    return this->IsMaskedBlockVisible(block);
  }
  if (!this->AreIndependent)
  {
    return shows(*this->Channels[this->Lead]);
  }
  return std::any_of(this->Channels.begin(), this->Channels.end(),
    [&shows](const auto& channel) { return channel->Weight > 0.0 && shows(*channel); });
}

void vtkFlatBlockVolumeMapper::vtkInternals::UpdateVisibleBlocks()
{
  std::vector<double> weights;
  for (const auto& channel : this->Channels)
  {
    weights.push_back(channel->Weight);
  }
  if (std::max({ this->GetFunctionTime(), this->Builder->GetMTime(), this->Builder->GetShownTime(),
        this->Mask ? this->Mask->Builder->GetMTime() : 0 }) < this->VisibleBlocksTime &&
      weights == this->VisibleWeights)
  {
    return;
  }
  this->VisibleWeights = weights;
  this->VisibleBlocks.resize(this->Builder->GetBlockRanges().size());
  for (std::size_t block = 0; block < this->VisibleBlocks.size(); ++block)
  {
    this->VisibleBlocks[block] = this->IsBlockVisible(block) ? 1 : 0;
  }
  this->VisibleBlocksTime.Modified();
}
