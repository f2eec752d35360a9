#include "GuessRaw.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <stdexcept>
#include <vector>

namespace
{
[[noreturn]] void Ask(const std::string& file, const std::string& why)
{
  throw std::runtime_error(
    "'" + file + "' has no header, and " + why + ": say --raw NX NY NZ TYPE what is in it.");
}

// Of lower-case letters and digits.
std::vector<std::string> SplitName(const std::string& file)
{
  std::vector<std::string> words = { "" };
  for (const char c : std::filesystem::u8path(file).stem().string())
  {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
    {
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    else
    {
      words.emplace_back();
    }
  }
  return words;
}

bool SetDimensions(const std::vector<std::string>& words, RawFormat& raw)
{
  static const std::regex numbers("([0-9]{1,6})x([0-9]{1,6})x([0-9]{1,6})");
  std::smatch found;
  for (const std::string& word : words)
  {
    if (std::regex_match(word, found, numbers))
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        raw.Dimensions[axis] = std::stoi(found[axis + 1]);
      }
      return true;
    }
  }
  return false;
}

void SetType(const std::vector<std::string>& words, RawFormat& raw)
{
  for (const std::string& word : words)
  {
    const int type = FindScalarType(word);
    raw.ScalarType = type != 0 ? type : raw.ScalarType;
    raw.BigEndian = raw.BigEndian || word == "be" || word == "bigendian";
  }
}
} // namespace

int FindScalarType(const std::string& name)
{
  static const std::map<std::string, int> types = { { "uint8", VTK_UNSIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "uint16", VTK_UNSIGNED_SHORT }, { "int16", VTK_SHORT },
    { "uint32", VTK_UNSIGNED_INT }, { "int32", VTK_INT }, { "float", VTK_FLOAT },
    { "double", VTK_DOUBLE } };
  const auto found = types.find(name);
  return found == types.end() ? 0 : found->second;
}

RawFormat GuessRaw(const std::string& file, std::uintmax_t size)
{
  constexpr int MostSamples = 4096;
  RawFormat raw;
  const std::vector<std::string> words = SplitName(file);
  SetType(words, raw);
  if (!SetDimensions(words, raw))
  {
    const int bytes = raw.ScalarType != 0 ? vtkDataArray::GetDataTypeSize(raw.ScalarType) : 1;
    std::uintmax_t side = 2;
    while (side < MostSamples && side * side * side * bytes < size)
    {
      side *= 2;
    }
    if (side * side * side * bytes != size)
    {
      Ask(file, "its name has no numbers like 256x256x128");
    }
    raw.Dimensions.fill(static_cast<int>(side));
  }
  const std::uintmax_t samples =
    static_cast<std::uintmax_t>(raw.Dimensions[0]) * raw.Dimensions[1] * raw.Dimensions[2];
  if (raw.ScalarType == 0)
  {
    if (samples != size)
    {
      Ask(file, "its name has no type of so many samples in " + std::to_string(size) + " bytes");
    }
    raw.ScalarType = VTK_UNSIGNED_CHAR;
  }
  if (std::any_of(raw.Dimensions.begin(), raw.Dimensions.end(), [](int n) { return n < 2; }) ||
      samples * vtkDataArray::GetDataTypeSize(raw.ScalarType) != size)
  {
    Ask(file, "what its name says is not what " + std::to_string(size) + " bytes hold");
  }
  return raw;
}
