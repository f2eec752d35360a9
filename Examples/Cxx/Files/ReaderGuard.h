/// Readers of others may crash, hang or ask for all memory where a file is damaged or made to: here
/// that ends in a message.
#pragma once

#include <cstdint>
#include <functional>

/// While one exists, the process is killed where it takes more than it should, and what libraries
/// write to the standard error is dropped. Only one at a time.
class ReaderGuard
{
public:
  /// @param seconds  of the processor, beyond one, that reading may take
  /// @param bytes  of memory, beyond a hundred MiB
  ReaderGuard(double seconds, std::uintmax_t bytes);
  ~ReaderGuard();
  ReaderGuard(const ReaderGuard&) = delete;
  ReaderGuard& operator=(const ReaderGuard&) = delete;

private:
  std::uintmax_t FormerLimit;
  int StandardError;
};

/// Does the work in a child process.
/// @param died  what else to do where the child was killed by a signal: within a ReaderGuard or not
/// @return the work's result, or what `died` returns
int RunInChild(
  const std::function<int()>& work, const std::function<int(int signal, bool wasReading)>& died);
