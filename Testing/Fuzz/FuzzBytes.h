/// Bytes of a fuzzer as numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

class FuzzBytes
{
public:
  FuzzBytes(const std::uint8_t* bytes, std::size_t count) : Next(bytes), Left(count) {}

  bool IsEmpty() const { return this->Left == 0; }

  /// 0 for bytes beyond the last one.
  template <typename T>
  T Take()
  {
    T value = {};
    const std::size_t count = this->Left < sizeof(T) ? this->Left : sizeof(T);
    std::memcpy(&value, this->Next, count);
    this->Next += count;
    this->Left -= count;
    return value;
  }

  /// From 0 to most.
  int TakeUpTo(int most) { return this->Take<std::uint16_t>() % (most + 1); }

private:
  const std::uint8_t* Next;
  std::size_t Left;
};

/// Ends the program, and so tells the fuzzer.
inline void Require(bool isTrue)
{
  if (!isTrue)
  {
    std::abort();
  }
}
