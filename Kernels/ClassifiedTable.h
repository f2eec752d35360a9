/// A transfer function as people see it.
#pragma once

#include "DistortionArithmetic.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flatblock
{
/// CIE 1976 L*, u*, v* (D65 white) of an sRGB colour, components in [0, 1], weighted by its opacity
/// over black; and the opacity, scaled to L*'s range of 100. sRGB as in IEC 61966-2-1; CIELUV as in
/// CIE 15:2004, eq. 8.2-8.5, with u* = v* = 0 for black.
ClassifiedColor ToClassifiedColor(double red, double green, double blue, double opacity);

/// Colours of the values from Lowest to Highest, at equal distances, interpolated linearly; values
/// beyond take the nearest end's. For integers of 8 and 16 bit there is an entry for every value.
class ClassifiedTable
{
public:
  ClassifiedTable() = default;

  /// @param colors  at least one
  ClassifiedTable(double lowest, double highest, std::vector<ClassifiedColor> colors);

  double GetLowest() const { return this->Lowest; }
  double GetHighest() const { return this->Highest; }
  const std::vector<ClassifiedColor>& GetColors() const { return this->Colors; }

  /// Of a value, in entries. NaN counts as the lowest.
  double GetPosition(double value) const;

  /// Of a position, also beyond the ends.
  double GetValue(double position) const;

  /// Whether all values in [lowest, highest] have the same colour. O(1).
  bool IsConstant(double lowest, double highest) const;

  /// The smallest opacity of a value in [lowest, highest], from 0 to 1. O(log n).
  float GetLeastOpacity(double lowest, double highest) const;

  /// The largest distance between the colours of two values in [lowest, highest], or somewhat more:
  /// the diagonal of the box around runs of entries. O(log n).
  float GetLargestDifference(double lowest, double highest) const;

private:
  struct Box
  {
    ClassifiedColor Low;
    ClassifiedColor High;
  };

  static void Extend(Box& box, const Box& other);
  void MakeBoxes();
  std::pair<const Box*, const Box*> GetBoxes(double lowest, double highest) const;

  double Lowest = 0.0;
  double Highest = 0.0;
  double Scale = 0.0;
  std::vector<ClassifiedColor> Colors;
  std::vector<std::int32_t> ChangesBefore; ///< entries that differ from the one before them
  std::size_t EntriesPerBox = 1;
  std::vector<std::vector<Box>> Boxes; ///< around runs of 2^i boxes from each one on
};

/// The interval of values, as [first, second], outside of which both tables have the same colours;
/// first > second where they are equal. Everything where they cover different values.
std::pair<double, double> FindDifference(const ClassifiedTable& a, const ClassifiedTable& b);
} // namespace flatblock
