/// A transfer function, sampled over an interval of values.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace flatblock
{
/// Entries of equal distance over [lowest, highest]; values between two entries are interpolated
/// linearly, values beyond take the nearest end's entry.
class TransferTable
{
public:
  /// Red, green, blue (not multiplied by opacity) and opacity, each in [0, 1].
  using Entry = std::array<float, 4>;

  TransferTable() = default;

  /// @param entries  at least one, with the opacity of one step along the ray
  TransferTable(double lowest, double highest, std::vector<Entry> entries);

  double GetLowest() const { return this->Lowest; }
  double GetHighest() const { return this->Highest; }
  const std::vector<Entry>& GetEntries() const { return this->Entries; }

  /// Whether every value in [lowest, highest] has zero opacity. O(1), by differences of a running
  /// count.
  bool IsTransparent(double lowest, double highest) const;

private:
  double GetPosition(double value) const;

  double Lowest = 0.0;
  double Highest = 0.0;
  std::vector<Entry> Entries;
  std::vector<std::size_t> OpaqueBefore; ///< entries [0, i) with opacity above zero
};

/// Opacity of a path of `steps` unit distances through a medium that has `opacity` over one:
/// 1 - (1 - opacity)^steps, without cancellation for small opacities.
double CorrectOpacity(double opacity, double steps);
} // namespace flatblock
