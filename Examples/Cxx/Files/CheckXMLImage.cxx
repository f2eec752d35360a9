#include "CheckXMLImage.h"

#include "vtkDataArray.h"
#include "vtkXMLDataElement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>

namespace
{
namespace fs = std::filesystem;

using Extent = std::array<double, 6>; // doubles, in which no product overflows

bool ReadExtent(vtkXMLDataElement* element, const char* key, Extent& extent)
{
  constexpr double Most = 1 << 30;
  int numbers[6];
  bool isGood = element->GetVectorAttribute(key, 6, numbers) == 6;
  for (std::size_t i = 0; isGood && i < 6; ++i)
  {
    extent[i] = numbers[i];
    isGood = std::abs(extent[i]) <= Most && (i % 2 == 0 || extent[i] >= extent[i - 1]);
  }
  return isGood;
}

double CountSamples(const Extent& e)
{
  return (e[1] - e[0] + 1.0) * (e[3] - e[2] + 1.0) * (e[5] - e[4] + 1.0);
}

double CountCells(const Extent& e)
{
  return std::max(1.0, e[1] - e[0]) * std::max(1.0, e[3] - e[2]) * std::max(1.0, e[5] - e[4]);
}

bool AreNumbers(const char* text)
{
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  double number = 0.0;
  int count = 0;
  while (words >> number && std::isfinite(number))
  {
    ++count;
  }
  return words.eof() && count == 3;
}

// Bytes that the file says follow at a place, or -1 where it ends before.
double ReadBlockSize(const AppendedData& appended, std::uintmax_t position)
{
  std::ifstream stream(fs::u8path(appended.File), std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(position));
  std::array<char, 8> bytes = {};
  if (!stream.read(bytes.data(), appended.BytesPerSize))
  {
    return -1.0;
  }
  if (appended.IsSwapped)
  {
    std::reverse(bytes.begin(), bytes.begin() + appended.BytesPerSize);
  }
  std::uint64_t size = 0; // of a little-endian machine
  std::memcpy(&size, bytes.data(), bytes.size());
  const auto end = position + static_cast<std::uintmax_t>(appended.BytesPerSize);
  const double rest = static_cast<double>(fs::file_size(fs::u8path(appended.File)) - end);
  return static_cast<double>(size) <= rest ? static_cast<double>(size) : -1.0;
}

std::string CheckArray(vtkXMLDataElement* array, double samples, const AppendedData& appended)
{
  const char* name = array->GetAttribute("Name");
  const std::string of = std::string(" of array '") + (name ? name : "") + "'";
  int type = 0;
  int components = 1;
  if (!array->GetWordTypeAttribute("type", type) || vtkDataArray::GetDataTypeSize(type) < 1)
  {
    return "the type" + of + " is none of numbers.";
  }
  if (array->GetAttribute("NumberOfComponents") &&
      (!array->GetScalarAttribute("NumberOfComponents", components) || components < 1))
  {
    return "the number of components" + of + " is none above 0.";
  }
  const char* format = array->GetAttribute("format");
  if (!appended.IsPlain || !format || std::strcmp(format, "appended") != 0)
  {
    return {};
  }
  long long offset = -1;
  std::istringstream(array->GetAttribute("offset") ? array->GetAttribute("offset") : "") >> offset;
  const double wanted = samples * components * vtkDataArray::GetDataTypeSize(type);
  if (offset < 0 ||
      ReadBlockSize(appended, appended.Position + static_cast<std::uintmax_t>(offset)) != wanted)
  {
    return "the samples" + of + " are not where the file says, or not as many.";
  }
  return {};
}

std::string CheckPiece(vtkXMLDataElement* piece, const AppendedData& appended, double& cells)
{
  Extent extent;
  if (!ReadExtent(piece, "Extent", extent))
  {
    return "the Extent of a Piece is none.";
  }
  cells += CountCells(extent);
  std::string problem;
  for (int i = 0; problem.empty() && i < piece->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* data = piece->GetNestedElement(i);
    const bool isOfPoints = std::strcmp(data->GetName(), "PointData") == 0;
    for (int j = 0; problem.empty() && isOfPoints && j < data->GetNumberOfNestedElements(); ++j)
    {
      problem = CheckArray(data->GetNestedElement(j), CountSamples(extent), appended);
    }
  }
  return problem;
}

bool IsOfNoNumbers(vtkXMLDataElement* array)
{
  const char* type = array->GetAttribute("type");
  return type && (std::strcmp(type, "String") == 0 || std::strcmp(type, "Bit") == 0);
}

// As parallel writers leave pieces where a process has none of the image.
bool IsEmptyPiece(vtkXMLDataElement* element)
{
  int e[6];
  return std::strcmp(element->GetName(), "Piece") == 0 &&
         element->GetVectorAttribute("Extent", 6, e) == 6 && e[1] < e[0] && e[3] < e[2] &&
         e[5] < e[4];
}

template <typename Condition>
void Remove(vtkXMLDataElement* from, const Condition& condition)
{
  for (int i = from->GetNumberOfNestedElements() - 1; i >= 0; --i)
  {
    if (condition(from->GetNestedElement(i)))
    {
      from->RemoveNestedElement(from->GetNestedElement(i));
    }
  }
}
} // namespace

void KeepNumbers(vtkXMLDataElement* image)
{
  Remove(image, [](vtkXMLDataElement* element)
    { return IsEmptyPiece(element) || std::strcmp(element->GetName(), "FieldData") == 0; });
  for (int i = 0; i < image->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* piece = image->GetNestedElement(i);
    for (int j = 0; j < piece->GetNumberOfNestedElements(); ++j)
    {
      Remove(piece->GetNestedElement(j), IsOfNoNumbers); // of points or of cells
    }
  }
}

std::string CheckXMLImage(vtkXMLDataElement* image, const AppendedData& appended)
{
  Extent whole;
  if (!ReadExtent(image, "WholeExtent", whole))
  {
    return "its WholeExtent is none.";
  }
  for (const char* key : { "Origin", "Spacing" })
  {
    if (image->GetAttribute(key) && !AreNumbers(image->GetAttribute(key)))
    {
      return std::string("its ") + key + " is '" + image->GetAttribute(key) +
             "', but three numbers are expected.";
    }
  }
  double cells = 0.0;
  std::string problem;
  for (int i = 0; problem.empty() && i < image->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = image->GetNestedElement(i);
    if (std::strcmp(element->GetName(), "Piece") == 0)
    {
      problem = CheckPiece(element, appended, cells);
    }
  }
  if (problem.empty() && cells != CountCells(whole))
  {
    return "its pieces are not its WholeExtent.";
  }
  return problem;
}
