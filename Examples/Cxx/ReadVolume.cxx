#include "ReadVolume.h"

#include "XMLImageReader.h"

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
#include "vtkPointData.h"
#include "vtkStructuredPointsReader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

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
      const std::string all = text;
      const std::size_t colon = all.find("): ");
      this->Text = colon == std::string::npos ? all : all.substr(colon + 3);
      this->Text.erase(this->Text.find_last_not_of(" \n") + 1);
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
  const RawFormat& raw = options.Raw;
  auto reader = vtkSmartPointer<vtkImageReader2>::New();
  reader->SetFileName(options.File.c_str());
  reader->SetFileDimensionality(3);
  reader->SetDataExtent(
    0, raw.Dimensions[0] - 1, 0, raw.Dimensions[1] - 1, 0, raw.Dimensions[2] - 1);
  reader->SetDataSpacing(raw.Spacing.data());
  reader->SetDataScalarType(raw.ScalarType);
  reader->SetNumberOfScalarComponents(1);
  if (raw.BigEndian)
  {
    reader->SetDataByteOrderToBigEndian();
  }
  else
  {
    reader->SetDataByteOrderToLittleEndian();
  }
  const auto wanted = static_cast<std::uintmax_t>(raw.Dimensions[0]) * raw.Dimensions[1] *
                      raw.Dimensions[2] * vtkDataArray::GetDataTypeSize(raw.ScalarType);
  const std::uintmax_t size = fs::file_size(options.File);
  if (size != wanted)
  {
    throw std::runtime_error("'" + options.File + "' has " + std::to_string(size) +
                             " bytes, but --raw asks for " + std::to_string(wanted) + ".");
  }
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeReaderFor(const Options& options)
{
  std::string name = options.File;
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (fs::is_directory(options.File))
  {
    auto reader = vtkSmartPointer<vtkDICOMImageReader>::New();
    reader->SetDirectoryName(options.File.c_str());
    return reader;
  }
  if (options.IsRaw)
  {
    return MakeRawReader(options);
  }
  if (EndsWith(name, ".nii") || EndsWith(name, ".nii.gz"))
  {
    return MakeReader<vtkNIFTIImageReader>(options.File);
  }
  if (EndsWith(name, ".nrrd") || EndsWith(name, ".nhdr"))
  {
    return MakeReader<vtkNrrdReader>(options.File);
  }
  if (EndsWith(name, ".mhd") || EndsWith(name, ".mha"))
  {
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
  if (EndsWith(name, ".raw"))
  {
    throw std::runtime_error(
      "'" + options.File + "' has no header: say --raw NX NY NZ TYPE what is in it.");
  }
  throw std::runtime_error(
    "'" + options.File +
    "' ends in none of .nii .nii.gz .nrrd .nhdr .mhd .mha .vti .vtk .raw, and is no folder.");
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
