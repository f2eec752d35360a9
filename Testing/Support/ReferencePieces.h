/// What a ray meets between two points where its field is a polynomial: of ReferenceRayCaster.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace flatblock::testing
{
/// Red, green, blue in [0, 1], not multiplied by anything, and extinction per unit of length, in
/// [0, 1e6]. Entries lie at equal distances over [Lowest, Highest], and what is between two is
/// interpolated linearly, colour and extinction each. Beyond the ends the end's entry holds.
/// Lowest < Highest unless there is one entry.
struct ReferenceTable
{
  double Lowest = 0.0;
  double Highest = 1.0;
  std::vector<std::array<double, 4>> Entries;
};

/// A table over positions: entry i is at i, and what is before 0 or behind the last equals that.
class PositionTable
{
public:
  /// Throws std::invalid_argument without an entry, or without a range for more than one.
  explicit PositionTable(const ReferenceTable& table);

  double GetPosition(double value) const { return (value - this->Lowest) * this->Scale; }
  std::array<double, 4> GetEntry(double position) const;

  /// Whether the extinction is 0 over the interval, and at the entries around it.
  bool IsTransparent(double lowest, double highest) const;

  /// How far colour and extinction may lie from their chord over the interval.
  std::pair<double, double> GetDeviation(double lowest, double highest) const;

  /// The position of the entry inside the interval that is nearest to its middle, or NaN.
  double GetMiddleEntry(double lowest, double highest) const;

private:
  struct Sums
  {
    long double Color = 0.0L;
    long double Extinction = 0.0L;
    std::size_t Bends = 0;
    std::size_t Visible = 0;
  };

  /// Absolute second differences of colour and extinction.
  std::pair<double, double> GetBend(std::size_t entry) const;
  void AddSums(std::size_t entry);
  /// The first entry inside an interval, and the one behind the last.
  std::pair<std::size_t, std::size_t> GetInside(double lowest, double highest) const;
  std::size_t Clamp(double position) const;

  double Lowest;
  double Scale = 0.0; // positions per value
  std::vector<std::array<double, 4>> Entries;
  std::vector<Sums> SumsBefore; // of the bends' sizes and of entries, before each entry
};

/// The field over a piece of a ray: Bernstein coefficients, in positions.
struct RayPiece
{
  static constexpr int MostDegree = 9;
  std::array<double, MostDegree + 1> Field = {};
  double Length = 0.0;
};

/// Premultiplied colour and optical depth of a part of a ray.
struct RaySum
{
  std::array<double, 3> Color = {};
  double Depth = 0.0;

  void Append(const RaySum& behind);
};

/// Gauss's rule of 5 points for a field of one degree and a table that is straight over its values.
class RayRule
{
public:
  explicit RayRule(int degree);

  int GetDegree() const { return this->Degree; }

  /// `piece` holds shares of the way from entry `low` to entry `high`. The depth is exact; so is
  /// the opacity, as the rule only gives the colour's mean, weighted by what is seen of it.
  RaySum Integrate(const RayPiece& piece, const std::array<double, 4>& low,
    const std::array<double, 4>& high) const;

  /// `at` and what Find() returns are shares of the length.
  std::pair<RayPiece, RayPiece> Split(const RayPiece& piece, double at) const;
  /// Where the field passes a position between its least and its largest, or the middle where it
  /// may turn.
  double Find(const RayPiece& piece, double position) const;

private:
  static constexpr int Nodes = 5;
  int Degree;
  std::array<double, Nodes> Weights = {}; // up to a factor
  std::array<std::array<double, RayPiece::MostDegree + 2>, Nodes> FieldBasis = {};
  std::array<std::array<double, RayPiece::MostDegree + 2>, Nodes> DepthBasis = {};
};

/// Gathers the pieces of one ray from front to back, splitting each until it is good enough.
class RayWalk
{
public:
  /// `length` is the whole ray's.
  RayWalk(const PositionTable& table, const RayRule& rule, double length);

  /// Nothing behind can be seen.
  bool IsOpaque() const;

  void Add(const RayPiece& piece, int splits = 0);

  /// Premultiplied colour and opacity.
  std::array<double, 4> GetPixel() const;

private:
  /// The sum of a piece whose values are in [low, high]. False where it may be too wrong.
  bool Integrate(const RayPiece& piece, double low, double high, RaySum& sum) const;
  double FindSplit(const RayPiece& piece, double low, double high) const;

  const PositionTable& Table;
  const RayRule& Rule;
  double Length;
  RaySum Result;
};

/// n over k, for n <= 10.
double Binomial(int n, int k);
} // namespace flatblock::testing
