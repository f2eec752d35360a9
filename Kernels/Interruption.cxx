#include "Interruption.h"

#include <utility>

namespace flatblock
{
namespace
{
thread_local InterruptionScope* Innermost = nullptr;
} // namespace

InterruptionScope::InterruptionScope(std::function<bool()> wish)
  : Wish(std::move(wish)), Outer(Innermost)
{
  Innermost = this;
}

InterruptionScope::~InterruptionScope()
{
  Innermost = this->Outer;
}

InterruptionScope* InterruptionScope::Get()
{
  return Innermost;
}

bool InterruptionScope::IsWished()
{
  constexpr std::chrono::milliseconds Interval(20);
  const auto now = std::chrono::steady_clock::now();
  if (!this->WasWished && now - this->LastAsked >= Interval)
  {
    this->WasWished = this->Wish();
    this->LastAsked = std::chrono::steady_clock::now(); // it may take its time
  }
  return this->WasWished;
}

void CheckInterruption()
{
  if (Innermost && Innermost->IsWished())
  {
    throw Interrupted();
  }
}

bool ParallelLoop::IsEnding() noexcept
{
  if (!this->Ending && this->Scope && std::this_thread::get_id() == this->Beginner)
  {
    try
    {
      if (this->Scope->IsWished())
      {
        throw Interrupted();
      }
    }
    catch (...)
    {
      this->Keep(std::current_exception());
    }
  }
  return this->Ending;
}

void ParallelLoop::Keep(const std::exception_ptr& problem) noexcept
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Problem = this->Problem ? this->Problem : problem;
  this->Ending = true;
}

void ParallelLoop::Finish()
{
  if (this->Problem)
  {
    std::rethrow_exception(this->Problem);
  }
}
} // namespace flatblock
