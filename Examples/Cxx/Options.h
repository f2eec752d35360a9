/// What the user asks for on the command line.
#pragma once

#include <array>
#include <string>

struct RawFormat
{
  std::array<int, 3> Dimensions = { 0, 0, 0 };
  int ScalarType = 0;
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };
  bool BigEndian = false;
  int HeaderBytes = 0; ///< before the samples
};

struct Options
{
  std::string File;
  std::string DefaultFile;
  bool IsRaw = false;
  RawFormat Raw;
  std::string Preset; ///< empty: from the data's percentiles
  std::string Output = "flatblock.png";
  std::array<int, 2> Size = { 800, 800 };
  int BlockSize = 33;
  double SampleDistance = 0.0;
  double MemoryMiB = 256.0;
  bool Interactive = false;
  bool Help = false;
};

extern const char* const Usage;

/// @throws std::runtime_error that names the word that could not be understood
Options ParseOptions(int argc, char* argv[]);
