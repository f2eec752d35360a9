#include "vtkFlatBlockVolumeMapperInternals.h"

#include <algorithm>
#include <stdexcept>

// The components of the data that vtkFlatBlockVolumeMapper draws.

// All anew where they are others than before: so whatever was made of them is out of date.
void vtkFlatBlockVolumeMapper::vtkInternals::SetChannels(
  const flatblock::Components& components, vtkVolumeProperty* property)
{
  const std::size_t count = std::max<std::size_t>(components.Numbers.size(), 1);
  if (this->Channels.size() != count || this->AreIndependent != components.AreIndependent)
  {
    this->Channels.clear();
    this->Interleaved.reset();
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Channels.push_back(std::make_unique<flatblock::Channel>());
    }
    this->AreIndependent = components.AreIndependent;
  }
  std::size_t lead = count - 1;
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

// Whether there are other bricks than before.
bool vtkFlatBlockVolumeMapper::vtkInternals::UpdateBuilders(
  int blockSize, const vtkFlatBlockBuilder::Bricks& bricks)
{
  bool isNew = false;
  for (std::size_t i = 0; i < this->Channels.size(); ++i)
  {
    const flatblock::Channel& channel = *this->Channels[i];
    channel.Scalars->Update(this->Input, this->Input.Components.Numbers[i]);
    isNew = channel.Builder->Update(channel.Scalars, blockSize, bricks) || isNew;
  }
  if (isNew && this->Channels.size() > 1)
  {
    std::vector<const flatblock::BrickSource*> sources;
    for (const auto& channel : this->Channels)
    {
      sources.push_back(&channel->Builder->GetSource());
    }
    this->Interleaved = std::make_unique<flatblock::InterleavedBricks>(std::move(sources));
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
  return time;
}

flatblock::ComponentTables vtkFlatBlockVolumeMapper::vtkInternals::GetTables() const
{
  flatblock::ComponentTables components;
  for (const auto& channel : this->Channels)
  {
    components.push_back({ &channel->TransferFunction->GetTable(),
      channel->Builder->GetSource().GetEncoding(), channel->Weight });
  }
  return components;
}

bool vtkFlatBlockVolumeMapper::vtkInternals::IsBlockVisible(std::size_t block) const
{
  const auto shows = [block](const flatblock::Channel& channel)
  {
    const flatblock::ValueRange& range = channel.Builder->GetBlockRanges()[block];
    return !channel.TransferFunction->GetDecisiveValues().IsTransparent(
      range.Lowest, range.Highest);
  };
  if (!this->AreIndependent)
  {
    return shows(*this->Channels.back());
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
  if (std::max(this->GetFunctionTime(), this->Builder->GetMTime()) < this->VisibleBlocksTime &&
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
