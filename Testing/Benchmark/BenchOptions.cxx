#include "BenchOptions.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace flatblock::benchmarks
{
const char* const BenchUsage =
  R"(Measures vtkFlatBlockVolumeMapper and VTK's own mappers: time, memory, error.

flatblock-bench [options]

  --output DIR     where results.json, results.csv, report.md, report.html and plots go
                   (flatblock-bench)
  --input FILE     one more scene: .nrrd .nhdr .nii .nii.gz .mha .mhd .vti .vtk
  --size N         samples along an axis of generated volumes, 16 to 1024 (128)
  --window W       pixels along a side of the window, 64 to 4096 (256)
  --seed N         of the vessel tree, 0 to 1000000 (1)
  --filter REGEX   only points whose "scene/mapper/knob=value" holds a match, of any case
  --frames FILE    instead: plays a turn of interactive frames and a still of each scene that
                   the filter leaves, and logs every frame to FILE, as CSV
  --quick          few scenes and points, volumes of 64, a window of 128
  --list           lists the points and ends
  --help
)";

namespace
{
int ToNumber(const std::string& option, const std::string& word, long least, long most)
{
  char* end = nullptr;
  const long number = std::strtol(word.c_str(), &end, 10);
  if (word.empty() || *end != '\0')
  {
    throw std::runtime_error(option + " takes a number, and '" + word + "' is none.");
  }
  if (number < least || number > most)
  {
    throw std::runtime_error(option + " takes " + std::to_string(least) + " to " +
                             std::to_string(most) + ", not " + word + ".");
  }
  return static_cast<int>(number);
}

void CheckInput(const std::string& file)
{
  if (!std::ifstream(file).good() || std::filesystem::is_directory(file))
  {
    throw std::runtime_error("--input: cannot read '" + file + "'.");
  }
}

void CheckFilter(const std::string& filter)
{
  try
  {
    const std::regex expression(filter, std::regex::icase);
  }
  catch (const std::regex_error& error)
  {
    throw std::runtime_error(
      "--filter: '" + filter + "' is no regular expression: " + error.what());
  }
}

void TakeOption(BenchOptions& options, const std::string& option, const std::string& value)
{
  if (option == "--output")
  {
    options.Output = value;
  }
  else if (option == "--input")
  {
    CheckInput(value);
    options.Input = value;
  }
  else if (option == "--frames")
  {
    options.Frames = value;
  }
  else if (option == "--filter")
  {
    CheckFilter(value);
    options.Filter = value;
  }
  else if (option == "--size")
  {
    options.Size = ToNumber(option, value, 16, 1024);
  }
  else if (option == "--window")
  {
    options.Window = ToNumber(option, value, 64, 4096);
  }
  else if (option == "--seed")
  {
    options.Seed = static_cast<unsigned int>(ToNumber(option, value, 0, 1000000));
  }
  else
  {
    throw std::runtime_error("Unknown option '" + option + "'; --help lists them.");
  }
}

bool TakeSwitch(BenchOptions& options, const std::string& option)
{
  options.IsHelp = options.IsHelp || option == "--help";
  options.IsList = options.IsList || option == "--list";
  options.IsQuick = options.IsQuick || option == "--quick";
  return option == "--help" || option == "--list" || option == "--quick";
}
} // namespace

BenchOptions ParseBenchOptions(int argc, char** argv)
{
  BenchOptions options;
  for (int i = 0; i < argc; ++i)
  {
    const std::string word = argv[i];
    options.Command += (i ? " " : "") + (word.find(' ') == word.npos ? word : "'" + word + "'");
    options.IsQuick = options.IsQuick || (i > 0 && word == "--quick");
  }
  if (options.IsQuick)
  {
    options.Size = 64;
    options.Window = 128;
  }
  for (int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    if (TakeSwitch(options, option))
    {
      continue;
    }
    // An unknown option is named before a missing value is.
    const bool hasValue = i + 1 < argc && std::string(argv[i + 1]).rfind("--", 0) != 0;
    if (!hasValue && std::string(BenchUsage).find("  " + option + " ") != std::string::npos)
    {
      throw std::runtime_error(option + " needs a value.");
    }
    TakeOption(options, option, hasValue ? argv[++i] : "");
  }
  return options;
}
} // namespace flatblock::benchmarks
