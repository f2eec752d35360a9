#include "MakeReader.h"

#include "CheckMetaImage.h"
#include "CheckNIfTI.h"
#include "CheckNrrd.h"
#include "GuessRaw.h"
#include "XMLImageReader.h"

#include "vtkDF3Reader.h"
#include "vtkDICOMImageReader.h"
#include "vtkDataArray.h"
#include "vtkImageReader2.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkPNGReader.h"
#include "vtkPVMReader.h"
#include "vtkStringArray.h"
#include "vtkStructuredPointsReader.h"
#include "vtkTIFFReader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace
{
namespace fs = std::filesystem;

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

template <typename Reader>
vtkSmartPointer<vtkAlgorithm> MakeFileReader(const std::string& file)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(file.c_str());
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeRawReader(const Options& options)
{
  const std::uintmax_t size = fs::file_size(options.File);
  const std::uintmax_t header = static_cast<std::uintmax_t>(options.Raw.HeaderBytes);
  const RawFormat raw =
    options.IsRaw ? options.Raw : GuessRaw(options.File, size > header ? size - header : 0);
  auto reader = vtkSmartPointer<vtkImageReader2>::New();
  reader->SetFileName(options.File.c_str());
  reader->SetFileDimensionality(3);
  reader->SetDataExtent(
    0, raw.Dimensions[0] - 1, 0, raw.Dimensions[1] - 1, 0, raw.Dimensions[2] - 1);
  reader->SetDataSpacing(options.Raw.Spacing.data());
  reader->SetHeaderSize(header);
  reader->SetDataScalarType(raw.ScalarType);
  reader->SetNumberOfScalarComponents(1);
  if (raw.BigEndian || options.Raw.BigEndian)
  {
    reader->SetDataByteOrderToBigEndian();
  }
  else
  {
    reader->SetDataByteOrderToLittleEndian();
  }
  const auto wanted = static_cast<std::uintmax_t>(raw.Dimensions[0]) * raw.Dimensions[1] *
                      raw.Dimensions[2] * vtkDataArray::GetDataTypeSize(raw.ScalarType);
  if (size != wanted + header)
  {
    throw std::runtime_error("'" + options.File + "' has " + std::to_string(size) +
                             " bytes, but --raw asks for " + std::to_string(wanted + header) + ".");
  }
  return reader;
}

void CheckReadable(const std::string& file)
{
  std::error_code problem;
  if (!fs::exists(file, problem))
  {
    throw std::runtime_error("'" + file + "' does not exist.");
  }
  if (!fs::is_directory(file, problem) &&
      (!fs::is_regular_file(file, problem) || !std::ifstream(file, std::ios::binary)))
  {
    throw std::runtime_error("'" + file + "' is no file that can be read.");
  }
}

// That it is one, and whole: its last tag is the root's.
void CheckXMLFile(const std::string& file)
{
  constexpr std::streamoff Tail = 4096;
  vtkNew<XMLImageReader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    throw std::runtime_error(
      "'" + file + "' could not be read: it is no XML file of VTK's images.");
  }
  std::ifstream stream(file, std::ios::binary);
  const auto size = static_cast<std::streamoff>(fs::file_size(file));
  stream.seekg(std::max<std::streamoff>(0, size - Tail));
  const std::string tail{ std::istreambuf_iterator<char>(stream),
    std::istreambuf_iterator<char>() };
  if (tail.find("</VTKFile>") == std::string::npos)
  {
    throw std::runtime_error("'" + file + "' could not be read: it ends before </VTKFile>.");
  }
}

std::string ToLower(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

// Of a folder, by their names.
std::vector<std::string> FindImages(const std::string& folder)
{
  std::vector<std::string> images;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    const std::string name = ToLower(entry.path().string());
    if (EndsWith(name, ".png") || EndsWith(name, ".tif") || EndsWith(name, ".tiff"))
    {
      images.push_back(entry.path().string());
    }
  }
  std::sort(images.begin(), images.end());
  return images;
}

// VTK's readers take the first one's size for that of all.
template <typename Reader>
void CheckSizes(const std::vector<std::string>& images)
{
  int first[6];
  for (const std::string& image : images)
  {
    vtkNew<Reader> reader;
    reader->SetFileName(image.c_str());
    reader->UpdateInformation();
    const int* extent = reader->GetDataExtent();
    if (image == images.front())
    {
      std::copy(extent, extent + 6, first);
    }
    if (!std::equal(extent, extent + 6, first))
    {
      throw std::runtime_error("'" + image + "' is not as large as '" + images.front() + "'.");
    }
  }
}

template <typename Reader>
vtkSmartPointer<vtkAlgorithm> MakeStackReader(const std::vector<std::string>& images)
{
  if (images.size() == 1)
  {
    return MakeFileReader<Reader>(images.front()); // which may have many pages
  }
  CheckSizes<Reader>(images);
  vtkNew<vtkStringArray> names;
  for (const std::string& image : images)
  {
    names->InsertNextValue(image);
  }
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileNames(names);
  return reader;
}

} // namespace

vtkSmartPointer<vtkAlgorithm> MakeReader(const Options& options)
{
  CheckReadable(options.File);
  const std::string name = ToLower(options.File);
  if (fs::is_directory(options.File))
  {
    const std::vector<std::string> images = FindImages(options.File);
    if (!images.empty())
    {
      return EndsWith(ToLower(images.front()), ".png") ? MakeStackReader<vtkPNGReader>(images)
                                                       : MakeStackReader<vtkTIFFReader>(images);
    }
    auto reader = vtkSmartPointer<vtkDICOMImageReader>::New();
    reader->SetDirectoryName(options.File.c_str());
    return reader;
  }
  if (options.IsRaw || EndsWith(name, ".raw"))
  {
    return MakeRawReader(options);
  }
  if (EndsWith(name, ".pvm"))
  {
    return MakeFileReader<vtkPVMReader>(options.File);
  }
  if (EndsWith(name, ".df3"))
  {
    return MakeFileReader<vtkDF3Reader>(options.File);
  }
  if (EndsWith(name, ".nii") || EndsWith(name, ".nii.gz"))
  {
    CheckNIfTI(options.File);
    return MakeFileReader<vtkNIFTIImageReader>(options.File);
  }
  if (EndsWith(name, ".nrrd") || EndsWith(name, ".nhdr"))
  {
    CheckNrrd(options.File);
    return MakeFileReader<vtkNrrdReader>(options.File);
  }
  if (EndsWith(name, ".tif") || EndsWith(name, ".tiff"))
  {
    return MakeFileReader<vtkTIFFReader>(options.File);
  }
  if (EndsWith(name, ".mhd") || EndsWith(name, ".mha"))
  {
    CheckMetaImage(options.File);
    return MakeFileReader<vtkMetaImageReader>(options.File);
  }
  if (EndsWith(name, ".vti"))
  {
    CheckXMLFile(options.File);
    return MakeFileReader<XMLImageReader>(options.File);
  }
  if (EndsWith(name, ".vtk"))
  {
    return MakeFileReader<vtkStructuredPointsReader>(options.File);
  }
  throw std::runtime_error("'" + options.File +
                           "' ends in none of .nii .nii.gz .nrrd .nhdr .mhd .mha .vti .vtk .pvm "
                           ".df3 .tif .raw, and is no folder.");
}
