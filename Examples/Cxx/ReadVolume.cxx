#include "ReadVolume.h"

#include "CheckMetaImage.h"
#include "GuessRaw.h"
#include "XMLImageReader.h"

#include "vtkDF3Reader.h"
#include "vtkDICOMImageReader.h"
#include "vtkDataArray.h"
#include "vtkImageReader2.h"
#include "vtkMath.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPNGReader.h"
#include "vtkPVMReader.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkStructuredPointsReader.h"
#include "vtkTIFFReader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace
{
namespace fs = std::filesystem;

// Readers say what is wrong in pieces, some of them of no use to a person: keep the first.
class FirstError : public vtkOutputWindow
{
public:
  static FirstError* New();
  vtkTypeMacro(FirstError, vtkOutputWindow);
  void DisplayErrorText(const char* text) override
  {
    if (this->Text.empty())
    {
      this->Text = StripError(text);
    }
  }
  void DisplayText(const char*) override {}
  std::string Text;
};
vtkStandardNewMacro(FirstError);

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

template <typename Reader>
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& file)
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
    return MakeReader<Reader>(images.front()); // which may have many pages
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

vtkSmartPointer<vtkAlgorithm> MakeReaderFor(const Options& options)
{
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
    return MakeReader<vtkPVMReader>(options.File);
  }
  if (EndsWith(name, ".df3"))
  {
    return MakeReader<vtkDF3Reader>(options.File);
  }
  if (EndsWith(name, ".nii") || EndsWith(name, ".nii.gz"))
  {
    return MakeReader<vtkNIFTIImageReader>(options.File);
  }
  if (EndsWith(name, ".nrrd") || EndsWith(name, ".nhdr"))
  {
    return MakeReader<vtkNrrdReader>(options.File);
  }
  if (EndsWith(name, ".tif") || EndsWith(name, ".tiff"))
  {
    return MakeReader<vtkTIFFReader>(options.File);
  }
  if (EndsWith(name, ".mhd") || EndsWith(name, ".mha"))
  {
    CheckMetaImage(options.File);
    return MakeReader<vtkMetaImageReader>(options.File);
  }
  if (EndsWith(name, ".vti"))
  {
    return MakeReader<XMLImageReader>(options.File);
  }
  if (EndsWith(name, ".vtk"))
  {
    return MakeReader<vtkStructuredPointsReader>(options.File);
  }
  throw std::runtime_error("'" + options.File +
                           "' ends in none of .nii .nii.gz .nrrd .nhdr .mhd .mha .vti .vtk .pvm "
                           ".df3 .raw, and is no folder.");
}

// DICOM's axes point to the left, the back and up; vtkDICOMImageReader turns the order of rows and
// of slices over.
vtkSmartPointer<vtkMatrix4x4> GetDICOMAnatomy(vtkDICOMImageReader* reader)
{
  const float* cosines = reader->GetImageOrientationPatient();
  double row[3];
  double column[3];
  std::copy(cosines, cosines + 3, row);
  std::copy(cosines + 3, cosines + 6, column);
  double normal[3];
  vtkMath::Cross(row, column, normal);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int i = 0; i < 3; ++i)
  {
    const double sign = i < 2 ? -1.0 : 1.0;
    matrix->SetElement(i, 0, sign * row[i]);
    matrix->SetElement(i, 1, -sign * column[i]);
    matrix->SetElement(i, 2, -sign * normal[i]);
  }
  return matrix;
}

vtkSmartPointer<vtkMatrix4x4> GetAnatomy(vtkAlgorithm* reader)
{
  vtkSmartPointer<vtkMatrix4x4> matrix;
  if (auto* nifti = vtkNIFTIImageReader::SafeDownCast(reader))
  {
    matrix = nifti->GetSFormMatrix() ? nifti->GetSFormMatrix() : nifti->GetQFormMatrix();
  }
  else if (auto* dicom = vtkDICOMImageReader::SafeDownCast(reader))
  {
    matrix = GetDICOMAnatomy(dicom);
  }
  return matrix && matrix->Determinant() != 0.0 ? matrix : nullptr;
}
} // namespace

std::string StripError(const std::string& text)
{
  const std::size_t colon = text.find("): ");
  std::string stripped = colon == std::string::npos ? text : text.substr(colon + 3);
  stripped.erase(stripped.find_last_not_of(" \n") + 1);
  return stripped;
}

LoadedVolume ReadVolume(const Options& options)
{
  if (!fs::exists(options.File))
  {
    throw std::runtime_error("'" + options.File + "' does not exist.");
  }
  const vtkSmartPointer<vtkAlgorithm> reader = MakeReaderFor(options);
  vtkSmartPointer<vtkOutputWindow> window = vtkOutputWindow::GetInstance();
  vtkNew<FirstError> errors;
  vtkOutputWindow::SetInstance(errors);
  reader->Update();
  vtkOutputWindow::SetInstance(window);

  LoadedVolume volume;
  volume.Image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  if (!errors->Text.empty())
  {
    throw std::runtime_error("'" + options.File + "' could not be read: " + errors->Text);
  }
  if (!volume.Image || !volume.Image->GetPointData()->GetScalars())
  {
    throw std::runtime_error("'" + options.File + "' holds no volume.");
  }
  volume.Anatomy = GetAnatomy(reader);
  return volume;
}
