#include "BenchProgress.h"

#include <algorithm>
#include <iostream>
#include <unistd.h>

namespace flatblock::benchmarks
{
Progress::Progress(std::size_t steps) : IsTerminal(isatty(STDERR_FILENO) == 1), Steps(steps) {}

void Progress::BeginScene(const std::string& name)
{
  if (!this->IsTerminal)
  {
    std::cerr << name << std::endl;
  }
}

void Progress::Step(const std::string& name)
{
  if (!this->IsTerminal)
  {
    return;
  }
  constexpr std::size_t Width = 24;
  const std::size_t done =
    std::min(Width, Width * this->Begun / std::max<std::size_t>(1, this->Steps));
  ++this->Begun;
  // So that it stays on one line of a narrow terminal.
  std::cerr << "\r\033[K[" << std::string(done, '#') << std::string(Width - done, '.') << "] "
            << this->Begun << "/" << this->Steps << " " << name.substr(0, 44) << std::flush;
}

void Progress::End()
{
  if (this->IsTerminal)
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}
} // namespace flatblock::benchmarks
