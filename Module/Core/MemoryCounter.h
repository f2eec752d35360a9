/// How much memory is allocated on the graphics card.
#pragma once

#include <algorithm>
#include <cstdint>

namespace flatblock
{
class MemoryCounter
{
public:
  std::int64_t GetBytes() const { return this->Bytes; }

  /// The most since the last ResetPeak().
  std::int64_t GetPeak() const { return this->Peak; }
  void ResetPeak() { this->Peak = this->Bytes; }

  void Change(std::int64_t bytes)
  {
    this->Bytes += bytes;
    this->Peak = std::max(this->Peak, this->Bytes);
  }

private:
  std::int64_t Bytes = 0;
  std::int64_t Peak = 0;
};

/// The share of one texture in a counter: to be set wherever the texture is allocated or released.
class CountedBytes
{
public:
  void SetCounter(MemoryCounter* counter) { this->Counter = counter; }
  std::int64_t Get() const { return this->Bytes; }
  void Set(std::int64_t bytes)
  {
    if (this->Counter)
    {
      this->Counter->Change(bytes - this->Bytes);
    }
    this->Bytes = bytes;
  }

private:
  MemoryCounter* Counter = nullptr;
  std::int64_t Bytes = 0;
};
} // namespace flatblock
