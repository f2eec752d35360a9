#include "BlockSummary.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flatblock
{
void BlockSummary::Set(int first, int last, const std::vector<std::uint32_t>& counts)
{
  constexpr std::uint32_t MostCount = (1U << 24) - 1;
  constexpr std::size_t PairsOfBins = Bins * Bins;
  this->First = first;
  this->Last = last;
  this->Pairs.clear();
  this->Ends.clear();
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    if (counts[i] > 0)
    {
      const auto pair = static_cast<std::uint32_t>(i % PairsOfBins);
      this->Pairs.push_back(std::min(counts[i], MostCount) << 8 | pair);
    }
    if (i % PairsOfBins == PairsOfBins - 1)
    {
      this->Ends.push_back(static_cast<std::uint16_t>(this->Pairs.size()));
    }
  }
  this->Pairs.shrink_to_fit();
}

void BlockSummary::Estimate(const ClassifiedTable& table, float* distortion, float* bounds) const
{
  std::array<ClassifiedColor, Bins> colors;
  std::array<float, Bins> widths; // how far a bin's colours may be from the one that stands for it
  const int size = this->Last - this->First + 1;
  for (int bin = 0; bin < Bins; ++bin)
  {
    const int first = this->First + (bin * size + Bins - 1) / Bins;
    const int last = this->First + ((bin + 1) * size + Bins - 1) / Bins - 1;
    const int middle = std::clamp((first + last) / 2, this->First, this->Last);
    colors[bin] = table.GetColors()[static_cast<std::size_t>(middle)];
    // Positions are rounded to their nearest entry.
    widths[bin] =
      table.GetLargestDifference(table.GetValue(first - 0.5), table.GetValue(last + 0.5));
  }
  std::size_t i = 0;
  for (std::size_t level = 0; level < this->Ends.size(); ++level)
  {
    double sum = 0.0;
    double boundSum = 0.0;
    double count = 0.0;
    for (; i < this->Ends[level]; ++i)
    {
      const std::uint32_t fine = (this->Pairs[i] & 255U) / Bins;
      const std::uint32_t coarse = this->Pairs[i] % Bins;
      const auto samples = static_cast<double>(this->Pairs[i] >> 8);
      const ClassifiedColor apart = colors[fine] - colors[coarse];
      const ClassifiedColor squares = apart * apart;
      sum += samples * ((double(squares[0]) + squares[1]) + (double(squares[2]) + squares[3]));
      const double width = double(widths[fine]) + widths[coarse];
      boundSum += samples * width * width;
      count += samples;
    }
    distortion[level] = static_cast<float>(std::sqrt(sum / std::max(count, 1.0)));
    bounds[level] = static_cast<float>(std::sqrt(boundSum / std::max(count, 1.0)));
  }
}
} // namespace flatblock
