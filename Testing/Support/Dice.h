/// Random choices that a seed determines.
#pragma once

#include <cmath>
#include <initializer_list>
#include <random>

namespace flatblock::testing
{
class Dice
{
public:
  explicit Dice(unsigned seed) : Random(seed) {}

  double Between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  int Below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(this->Random); }
  double Power(double low, double high) { return std::pow(10.0, this->Between(low, high)); }
  bool Chance(double share) { return this->Between(0.0, 1.0) < share; }

  template <typename T>
  T OneOf(std::initializer_list<T> choices)
  {
    return choices.begin()[this->Below(static_cast<int>(choices.size()))];
  }

private:
  std::mt19937 Random;
};
} // namespace flatblock::testing
