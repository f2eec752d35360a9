#include "ReferencePieces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace flatblock::testing
{
namespace
{
// A piece's error may be this share of what it draws, and of its share of the ray's length: so they
// add up to a few times that. Where both are next to nothing, 1e-11 is good enough.
constexpr double Tolerance = 5e-8;
constexpr double LeastTolerance = 1e-11;
// What lies behind exp(-24) < 1e-10 is not seen.
constexpr double MostDepth = 24.0;
// A piece of 2^-60 of a cell is taken as it is.
constexpr int MostSplits = 60;
} // namespace

PositionTable::PositionTable(const ReferenceTable& table)
  : Lowest(table.Lowest), Entries(table.Entries), SumsBefore(1)
{
  const std::size_t size = this->Entries.size();
  if (size == 0 || (size > 1 && !(table.Highest > table.Lowest)))
  {
    throw std::invalid_argument("A table needs an entry, and a range for more than one.");
  }
  this->Scale = size > 1 ? static_cast<double>(size - 1) / (table.Highest - table.Lowest) : 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    this->AddSums(i);
  }
}

std::pair<double, double> PositionTable::GetBend(std::size_t entry) const
{
  const auto& here = this->Entries[entry];
  const auto& left = this->Entries[entry == 0 ? 0 : entry - 1];
  const auto& right = this->Entries[std::min(entry + 1, this->Entries.size() - 1)];
  std::array<double, 4> bends;
  for (int c = 0; c < 4; ++c)
  {
    bends[c] = std::abs((right[c] - here[c]) - (here[c] - left[c]));
  }
  return { std::max({ bends[0], bends[1], bends[2] }), bends[3] };
}

void PositionTable::AddSums(std::size_t entry)
{
  const auto [color, extinction] = this->GetBend(entry);
  Sums sums = this->SumsBefore.back();
  sums.Color += color;
  sums.Extinction += extinction;
  sums.Bends += color > 0.0 || extinction > 0.0 ? 1 : 0;
  sums.Visible += this->Entries[entry][3] > 0.0 ? 1 : 0;
  this->SumsBefore.push_back(sums);
}

std::size_t PositionTable::Clamp(double position) const
{
  return static_cast<std::size_t>(
    std::clamp(position, 0.0, static_cast<double>(this->Entries.size() - 1)));
}

bool PositionTable::IsTransparent(double lowest, double highest) const
{
  const std::size_t first = this->Clamp(std::floor(lowest));
  const std::size_t last = this->Clamp(std::ceil(highest));
  return this->SumsBefore[last + 1].Visible == this->SumsBefore[first].Visible;
}

std::array<double, 4> PositionTable::GetEntry(double position) const
{
  const double floor = std::floor(position);
  std::array<double, 4> entry = this->Entries[this->Clamp(floor)];
  const auto& right = this->Entries[this->Clamp(floor + 1.0)];
  for (int c = 0; c < 4; ++c)
  {
    entry[c] += (position - floor) * (right[c] - entry[c]);
  }
  return entry;
}

std::pair<std::size_t, std::size_t> PositionTable::GetInside(double lowest, double highest) const
{
  const auto size = static_cast<double>(this->Entries.size());
  return { static_cast<std::size_t>(std::clamp(std::floor(lowest) + 1.0, 0.0, size)),
    static_cast<std::size_t>(std::clamp(std::ceil(highest), 0.0, size)) };
}

// A bend at x moves the table from its chord by its size times (x - lowest) (highest - x) / width:
// the outermost two by that, those between by a quarter of the width at most.
std::pair<double, double> PositionTable::GetDeviation(double lowest, double highest) const
{
  const auto [first, end] = this->GetInside(lowest, highest);
  if (first >= end || this->SumsBefore[end].Bends == this->SumsBefore[first].Bends)
  {
    return { 0.0, 0.0 };
  }
  std::pair<double, double> result = { 0.0, 0.0 };
  const auto add = [&, low = lowest, high = highest](std::size_t entry)
  {
    const auto [color, extinction] = this->GetBend(entry);
    const auto at = static_cast<double>(entry);
    const double arm = (at - low) * (high - at) / (high - low);
    result.first += color * arm;
    result.second += extinction * arm;
  };
  add(first);
  if (end - first > 1)
  {
    add(end - 1);
  }
  if (end - first > 2)
  {
    // A sum may have lost small bends after large ones.
    const long double lost =
      std::numeric_limits<long double>::epsilon() * static_cast<long double>(end - first);
    const Sums& before = this->SumsBefore[first + 1];
    const Sums& until = this->SumsBefore[end - 1];
    const Sums& all = this->SumsBefore.back();
    const long double quarter = 0.25L * (highest - lowest);
    result.first += static_cast<double>(quarter * (until.Color - before.Color + lost * all.Color));
    result.second +=
      static_cast<double>(quarter * (until.Extinction - before.Extinction + lost * all.Extinction));
  }
  return result;
}

double PositionTable::GetMiddleEntry(double lowest, double highest) const
{
  const auto [first, end] = this->GetInside(lowest, highest);
  if (first >= end)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::clamp(
    std::round(0.5 * (lowest + highest)), static_cast<double>(first), static_cast<double>(end - 1));
}

void RaySum::Append(const RaySum& behind)
{
  const double transmittance = std::exp(-this->Depth);
  for (int c = 0; c < 3; ++c)
  {
    this->Color[c] += transmittance * behind.Color[c];
  }
  this->Depth += behind.Depth;
}

RayRule::RayRule(int degree) : Degree(degree)
{
  const double inner = std::sqrt(5.0 - 2.0 * std::sqrt(10.0 / 7.0)) / 6.0;
  const double outer = std::sqrt(5.0 + 2.0 * std::sqrt(10.0 / 7.0)) / 6.0;
  const double root = 13.0 * std::sqrt(70.0);
  const std::array<double, Nodes> offsets = { -outer, -inner, 0.0, inner, outer };
  this->Weights = { 322.0 - root, 322.0 + root, 512.0, 322.0 + root, 322.0 - root };
  for (int node = 0; node < Nodes; ++node)
  {
    const double at = 0.5 + offsets[node];
    const auto basis = [at](int n, int i)
    { return i > n ? 0.0 : Binomial(n, i) * std::pow(at, i) * std::pow(1.0 - at, n - i); };
    for (int i = 0; i <= degree + 1; ++i)
    {
      this->FieldBasis[node][i] = basis(degree, i);
      this->DepthBasis[node][i] = basis(degree + 1, i);
    }
  }
}

RaySum RayRule::Integrate(
  const RayPiece& piece, const std::array<double, 4>& low, const std::array<double, 4>& high) const
{
  // The depth's coefficients are the sums of the extinction's.
  std::array<double, RayPiece::MostDegree + 2> depths = {};
  for (int i = 0; i <= this->Degree; ++i)
  {
    const double extinction = low[3] + piece.Field[i] * (high[3] - low[3]);
    depths[i + 1] = depths[i] + extinction * piece.Length / (this->Degree + 1);
  }
  double total = 0.0;
  double mean = 0.0;
  for (int node = 0; node < Nodes; ++node)
  {
    double share = 0.0;
    double depth = this->DepthBasis[node][this->Degree + 1] * depths[this->Degree + 1];
    for (int i = 0; i <= this->Degree; ++i)
    {
      share += this->FieldBasis[node][i] * piece.Field[i];
      depth += this->DepthBasis[node][i] * depths[i];
    }
    const double weight =
      this->Weights[node] * (low[3] + share * (high[3] - low[3])) * std::exp(-depth);
    total += weight;
    mean += weight * share;
  }
  mean = total > 0.0 ? mean / total : piece.Field[0];
  RaySum sum;
  sum.Depth = depths[this->Degree + 1];
  for (int c = 0; c < 3; ++c)
  {
    sum.Color[c] = -std::expm1(-sum.Depth) * (low[c] + mean * (high[c] - low[c]));
  }
  return sum;
}

// By de Casteljau.
std::pair<RayPiece, RayPiece> RayRule::Split(const RayPiece& piece, double at) const
{
  std::pair<RayPiece, RayPiece> parts;
  auto& [front, back] = parts;
  front.Length = at * piece.Length;
  back.Length = (1.0 - at) * piece.Length;
  back.Field = piece.Field;
  for (int level = 0; level <= this->Degree; ++level)
  {
    front.Field[level] = back.Field[0];
    for (int i = 0; i < this->Degree - level; ++i)
    {
      back.Field[i] = (1.0 - at) * back.Field[i] + at * back.Field[i + 1];
    }
  }
  return parts;
}

// By the Illinois variant of regula falsi.
double RayRule::Find(const RayPiece& piece, double position) const
{
  const auto& field = piece.Field;
  const auto* end = field.data() + this->Degree + 1;
  if (!std::is_sorted(field.data(), end) && !std::is_sorted(field.data(), end, std::greater<>()))
  {
    return 0.5;
  }
  std::array<double, 2> ends = { 0.0, 1.0 };
  std::array<double, 2> values = { field[0] - position, field[this->Degree] - position };
  const double enough = 4.0 * std::numeric_limits<double>::epsilon() * (1.0 + position);
  double at = 0.5;
  for (int step = 0, last = -1; step < 50; ++step)
  {
    at = (ends[0] * values[1] - ends[1] * values[0]) / (values[1] - values[0]);
    const double value = this->Split(piece, at).second.Field[0] - position;
    if (std::abs(value) <= enough)
    {
      break;
    }
    const int side = (value > 0.0) == (values[0] > 0.0) ? 0 : 1;
    values[1 - side] *= side == last ? 0.5 : 1.0;
    ends[side] = at;
    values[side] = value;
    last = side;
  }
  return at > 0.0 && at < 1.0 ? at : 0.5;
}

RayWalk::RayWalk(const PositionTable& table, const RayRule& rule, double length)
  : Table(table), Rule(rule), Length(length)
{
}

bool RayWalk::IsOpaque() const
{
  return this->Result.Depth > MostDepth;
}

void RayWalk::Add(const RayPiece& piece, int splits)
{
  const auto [low, high] =
    std::minmax_element(piece.Field.begin(), piece.Field.begin() + this->Rule.GetDegree() + 1);
  if (this->IsOpaque() || this->Table.IsTransparent(*low, *high))
  {
    return;
  }
  RaySum sum;
  if (this->Integrate(piece, *low, *high, sum) || splits == MostSplits)
  {
    this->Result.Append(sum);
    return;
  }
  const auto [front, back] = this->Rule.Split(piece, this->FindSplit(piece, *low, *high));
  this->Add(front, splits + 1);
  this->Add(back, splits + 1);
}

// At an entry, so that the table has no bend there any more; where that can't be, in the middle.
double RayWalk::FindSplit(const RayPiece& piece, double low, double high) const
{
  constexpr double Least = 1e-9; // rounding is far below
  const double entry = this->Table.GetMiddleEntry(low, high);
  return entry - low > Least && high - entry > Least ? this->Rule.Find(piece, entry) : 0.5;
}

bool RayWalk::Integrate(const RayPiece& piece, double low, double high, RaySum& sum) const
{
  const auto first = this->Table.GetEntry(low);
  const auto last = this->Table.GetEntry(high);
  RayPiece shares = piece;
  for (double& value : shares.Field)
  {
    value = high > low ? (value - low) / (high - low) : 0.0;
  }
  const auto [front, back] = this->Rule.Split(shares, 0.5);
  sum = this->Rule.Integrate(front, first, last);
  sum.Append(this->Rule.Integrate(back, first, last));
  const double seen = std::exp(-this->Result.Depth);
  const double opacity = -std::expm1(-sum.Depth);
  const double tolerance =
    Tolerance * (seen * opacity + piece.Length / this->Length) + LeastTolerance;
  const auto [color, extinction] = this->Table.GetDeviation(low, high);
  if (seen * (extinction * piece.Length + color * opacity) > tolerance)
  {
    return false;
  }
  const RaySum whole = this->Rule.Integrate(shares, first, last);
  bool isGood = true;
  for (int c = 0; c < 3; ++c)
  {
    // One colour is exact at any depth; else the rule needs to see more than the front.
    isGood =
      isGood && (first[c] == last[c] ||
                  (sum.Depth < 8.0 && seen * std::abs(sum.Color[c] - whole.Color[c]) <= tolerance));
  }
  return isGood;
}

std::array<double, 4> RayWalk::GetPixel() const
{
  const auto& color = this->Result.Color;
  return { color[0], color[1], color[2], -std::expm1(-this->Result.Depth) };
}

double Binomial(int n, int k)
{
  return k == 0 ? 1.0 : Binomial(n, k - 1) * (n - k + 1) / k;
}
} // namespace flatblock::testing
