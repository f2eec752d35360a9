/// Sizes that seldom change.
#pragma once

#include <cstdint>

namespace flatblock
{
/// The next number of which at most the three highest bits are set: less than a quarter more.
inline std::int64_t RoundUp(std::int64_t number)
{
  std::int64_t step = 1;
  while (number > 8 * step)
  {
    step *= 2;
  }
  return (number + step - 1) / step * step;
}
} // namespace flatblock
