#include "ClassifiedTable.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace flatblock
{
namespace
{
double ToLinear(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

bool AreEqual(const ClassifiedColor& a, const ClassifiedColor& b)
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && a[3] == b[3];
}
} // namespace

ClassifiedColor ToClassifiedColor(double red, double green, double blue, double opacity)
{
  if (!(opacity > 0.0))
  {
    return {};
  }
  const double r = ToLinear(red * opacity);
  const double g = ToLinear(green * opacity);
  const double b = ToLinear(blue * opacity);
  const double x = 0.4124564 * r + 0.3575761 * g + 0.1804375 * b;
  const double y = 0.2126729 * r + 0.7151522 * g + 0.0721750 * b;
  const double z = 0.0193339 * r + 0.1191920 * g + 0.9503041 * b;
  // The white of the matrix, so that grey has neither u* nor v*.
  constexpr double WhiteX = 0.95047;
  constexpr double WhiteZ = 1.08883;
  constexpr double WhiteSum = WhiteX + 15.0 + 3.0 * WhiteZ;
  constexpr double Epsilon = 216.0 / 24389.0;
  constexpr double Kappa = 24389.0 / 27.0;
  const double lightness = y > Epsilon ? 116.0 * std::cbrt(y) - 16.0 : Kappa * y;
  const double sum = x + 15.0 * y + 3.0 * z;
  const double u = sum > 0.0 ? 13.0 * lightness * (4.0 * x / sum - 4.0 * WhiteX / WhiteSum) : 0.0;
  const double v = sum > 0.0 ? 13.0 * lightness * (9.0 * y / sum - 9.0 / WhiteSum) : 0.0;
  return { { static_cast<float>(lightness), static_cast<float>(u), static_cast<float>(v),
    static_cast<float>(100.0 * opacity) } };
}

ClassifiedTable::ClassifiedTable(double lowest, double highest, std::vector<ClassifiedColor> colors)
  : Lowest(lowest), Highest(highest), Colors(std::move(colors)),
    ChangesBefore(this->Colors.size() + 1, 0)
{
  const double span = highest - lowest;
  this->Scale = span > 0.0 ? static_cast<double>(this->Colors.size() - 1) / span : 0.0;
  for (std::size_t i = 0; i < this->Colors.size(); ++i)
  {
    const bool isSame = i == 0 || AreEqual(this->Colors[i], this->Colors[i - 1]);
    this->ChangesBefore[i + 1] = this->ChangesBefore[i] + (isSame ? 0 : 1);
  }
  this->MakeBoxes();
}

void ClassifiedTable::MakeBoxes()
{
  constexpr std::size_t MostBoxes = 4096;
  const std::size_t size = this->Colors.size();
  this->EntriesPerBox = (size - 1) / MostBoxes + 1;
  std::vector<Box> boxes;
  for (std::size_t first = 0; first < size; first += this->EntriesPerBox)
  {
    Box box = { this->Colors[first], this->Colors[first] };
    for (std::size_t i = first; i < std::min(first + this->EntriesPerBox, size); ++i)
    {
      Extend(box, { this->Colors[i], this->Colors[i] });
    }
    boxes.push_back(box);
  }
  for (std::size_t run = 1; run < boxes.size(); run *= 2)
  {
    this->Boxes.push_back(boxes);
    for (std::size_t i = 0; i + run < boxes.size(); ++i)
    {
      Extend(boxes[i], boxes[i + run]);
    }
  }
  this->Boxes.push_back(std::move(boxes));
}

void ClassifiedTable::Extend(Box& box, const Box& other)
{
  for (int c = 0; c < 4; ++c)
  {
    box.Low[c] = std::min(box.Low[c], other.Low[c]);
    box.High[c] = std::max(box.High[c], other.High[c]);
  }
}

double ClassifiedTable::GetPosition(double value) const
{
  const double position = (value - this->Lowest) * this->Scale;
  return position > 0.0 ? std::min(position, static_cast<double>(this->Colors.size() - 1)) : 0.0;
}

double ClassifiedTable::GetValue(double position) const
{
  return this->Scale > 0.0 ? this->Lowest + position / this->Scale : this->Lowest;
}

bool ClassifiedTable::IsConstant(double lowest, double highest) const
{
  const auto first = static_cast<std::size_t>(this->GetPosition(lowest));
  const auto last = static_cast<std::size_t>(std::ceil(this->GetPosition(highest)));
  return lowest > highest || this->ChangesBefore[last + 1] == this->ChangesBefore[first + 1];
}

// Those of two runs that overlap and cover the interval.
std::pair<const ClassifiedTable::Box*, const ClassifiedTable::Box*> ClassifiedTable::GetBoxes(
  double lowest, double highest) const
{
  const std::size_t first =
    static_cast<std::size_t>(this->GetPosition(lowest)) / this->EntriesPerBox;
  const std::size_t last =
    static_cast<std::size_t>(std::ceil(this->GetPosition(highest))) / this->EntriesPerBox;
  std::size_t level = 0;
  while ((std::size_t(2) << level) <= last - first + 1)
  {
    ++level;
  }
  return { &this->Boxes[level][first], &this->Boxes[level][last + 1 - (std::size_t(1) << level)] };
}

float ClassifiedTable::GetLeastOpacity(double lowest, double highest) const
{
  if (lowest > highest)
  {
    return 0.0F;
  }
  const auto [a, b] = this->GetBoxes(lowest, highest);
  return 0.01F * std::min(a->Low[3], b->Low[3]);
}

float ClassifiedTable::GetLargestDifference(double lowest, double highest) const
{
  if (lowest > highest)
  {
    return 0.0F;
  }
  const auto [a, b] = this->GetBoxes(lowest, highest);
  float squares = 0.0F;
  for (int c = 0; c < 4; ++c)
  {
    const float apart = std::max(a->High[c], b->High[c]) - std::min(a->Low[c], b->Low[c]);
    squares += apart * apart;
  }
  return std::sqrt(squares);
}

std::pair<double, double> FindDifference(const ClassifiedTable& a, const ClassifiedTable& b)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  const auto& left = a.GetColors();
  const auto& right = b.GetColors();
  if (left.size() != right.size() || a.GetLowest() != b.GetLowest() ||
      a.GetHighest() != b.GetHighest())
  {
    return { -Infinity, Infinity };
  }
  std::size_t first = 0;
  while (first < left.size() && AreEqual(left[first], right[first]))
  {
    ++first;
  }
  if (first == left.size())
  {
    return { Infinity, -Infinity };
  }
  std::size_t last = left.size() - 1;
  while (AreEqual(left[last], right[last]))
  {
    --last;
  }
  // Between two entries colours are interpolated: so it reaches to the entries beside.
  const double entry = (a.GetHighest() - a.GetLowest()) /
                       static_cast<double>(std::max<std::size_t>(left.size(), 2) - 1);
  return { first == 0 ? -Infinity : a.GetLowest() + (static_cast<double>(first) - 1.0) * entry,
    last + 1 == left.size() ? Infinity
                            : a.GetLowest() + (static_cast<double>(last) + 1.0) * entry };
}
} // namespace flatblock
