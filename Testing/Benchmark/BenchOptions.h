/// What the command line asks for.
#pragma once

#include <string>

namespace flatblock::benchmarks
{
struct BenchOptions
{
  std::string Command; ///< as typed
  std::string Output = "flatblock-bench";
  std::string Input;
  std::string Frames; ///< CSV of an interactive session, instead of the sweep
  std::string Filter; ///< regular expression on "scene/mapper/knob=value"
  int Size = 128;     ///< samples along an axis of what is generated
  int Window = 256;   ///< pixels along a side
  unsigned int Seed = 1;
  bool IsQuick = false;
  bool IsList = false;
  bool IsHelp = false;
};

extern const char* const BenchUsage;

/// @throws std::runtime_error that names the word that could not be understood
BenchOptions ParseBenchOptions(int argc, char** argv);
} // namespace flatblock::benchmarks
