/// How far the run is: a bar on a terminal, a line a scene elsewhere.
#pragma once

#include <cstddef>
#include <string>

namespace flatblock::benchmarks
{
class Progress
{
public:
  explicit Progress(std::size_t steps);

  void BeginScene(const std::string& name);
  /// Names the step that begins.
  void Step(const std::string& name);
  /// Clears the bar.
  void End();

private:
  bool IsTerminal;
  std::size_t Steps;
  std::size_t Begun = 0;
};
} // namespace flatblock::benchmarks
