/// How loops over much data end early: by a wish of the caller's, or by an exception in one of
/// their threads, which OpenMP lets none out of.
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace flatblock
{
/// What a loop throws where it was wished to end.
class Interrupted : public std::exception
{
public:
  const char* what() const noexcept override { return "Interrupted."; }
};

/// While one exists, loops that this thread begins ask whether to end: this thread only, and at
/// most every 20 milliseconds. The innermost one is asked.
class InterruptionScope
{
public:
  explicit InterruptionScope(std::function<bool()> wish);
  ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

  bool IsWished();

  /// @return that of this thread, nullptr where there is none
  static InterruptionScope* Get();

private:
  std::function<bool()> Wish;
  InterruptionScope* Outer;
  std::chrono::steady_clock::time_point LastAsked = std::chrono::steady_clock::now();
  bool WasWished = false;
};

/// For loops of one thread.
/// @throws Interrupted
void CheckInterruption();

/// A loop of many threads. Each turn goes through Do(), and after them the thread that began calls
/// Finish().
class ParallelLoop
{
public:
  /// Does a turn, unless the loop is to end.
  template <typename Body>
  void Do(Body&& body) noexcept
  {
    if (this->IsEnding())
    {
      return;
    }
    try
    {
      body();
    }
    catch (...)
    {
      this->Keep(std::current_exception());
    }
  }

  /// Whether turns are no longer done.
  bool IsEnding() noexcept;

  /// @throws what a turn threw first, or Interrupted
  void Finish();

private:
  void Keep(const std::exception_ptr& problem) noexcept;

  InterruptionScope* Scope = InterruptionScope::Get();
  std::thread::id Beginner = std::this_thread::get_id();
  std::atomic<bool> Ending{ false };
  std::mutex Mutex;
  std::exception_ptr Problem;
};
} // namespace flatblock
