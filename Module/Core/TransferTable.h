/// A transfer function, sampled over an interval of values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flatblock
{
/// Entries of equal distance over [lowest, highest]; values between two entries are interpolated
/// linearly, values beyond take the nearest end's entry.
class TransferTable
{
public:
  /// Red, green, blue (not multiplied by anything), each in [0, 1], and extinction per unit of
  /// length, in [0, MostExtinction].
  using Entry = std::array<float, 4>;

  TransferTable() = default;

  /// @param entries  at least two
  TransferTable(double lowest, double highest, std::vector<Entry> entries);

  double GetLowest() const { return this->Lowest; }
  double GetHighest() const { return this->Highest; }
  const std::vector<Entry>& GetEntries() const { return this->Entries; }

  /// Of a value, counted in entries; beyond them where it lies beyond the table.
  double GetPosition(double value) const;

  /// Whether every value in [lowest, highest] has no extinction; so also where lowest > highest,
  /// and there is no value. O(1), by differences of a running count.
  bool IsTransparent(double lowest, double highest) const;

  /// What the values of an interval look like: nothing, all the same, or neither.
  enum class Kind : std::uint8_t
  {
    Varying,
    Transparent,
    Constant
  };
  Kind GetKind(double lowest, double highest) const;

private:
  struct Interval
  {
    std::size_t Begin;
    std::size_t End;
  };
  Interval FindEntries(double lowest, double highest) const;

  double Lowest = 0.0;
  double Highest = 0.0;
  std::vector<Entry> Entries;
  std::vector<std::size_t> VisibleBefore; ///< entries [0, i) with extinction above zero
  std::vector<std::size_t> ChangesBefore; ///< entries [0, i) that differ from the one before
};

/// What is opaque has this extinction: a sixteenth of the unit of length lets nothing through.
constexpr double MostExtinction = 256.0;

/// Extinction of a medium that has `opacity` over a length of `distance` units:
/// -ln(1 - opacity) / distance, at most MostExtinction; without cancellation for small opacities.
double GetExtinction(double opacity, double distance);
} // namespace flatblock
