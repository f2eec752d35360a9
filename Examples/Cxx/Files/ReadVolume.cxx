#include "ReadVolume.h"

#include "DataSize.h"
#include "MakeReader.h"
#include "ReaderGuard.h"

#include "vtkDICOMImageReader.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <locale>
#include <new>
#include <sstream>
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
      this->Text = StripError(text);
    }
  }
  // A volume that its reader is not sure of would mislead. Not so what a folder has beside slices.
  void DisplayWarningText(const char* text) override
  {
    if (!this->IsFolder)
    {
      this->DisplayErrorText(text);
    }
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayText(const char*) override {}
  std::string Text;
  bool IsFolder = false;
};
vtkStandardNewMacro(FirstError);

// While one exists, VTK's messages come to it.
class Listening
{
public:
  explicit Listening(const std::string& file) : File(file), Former(vtkOutputWindow::GetInstance())
  {
    this->Errors->IsFolder = fs::is_directory(file);
    vtkOutputWindow::SetInstance(this->Errors);
  }
  ~Listening() { vtkOutputWindow::SetInstance(this->Former); }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

  void Check() const
  {
    const std::string& text = this->Errors->Text;
    if (text.rfind("'" + this->File + "'", 0) == 0)
    {
      throw std::runtime_error(text);
    }
    if (!text.empty())
    {
      const char* as = this->Errors->IsFolder ? " as slices" : "";
      throw std::runtime_error("'" + this->File + "' could not be read" + as + ": " + text);
    }
  }

private:
  std::string File;
  vtkSmartPointer<vtkOutputWindow> Former;
  vtkNew<FirstError> Errors;
};

struct FileSizes
{
  std::uintmax_t Files = 0;
  std::uintmax_t Bytes = 0;
};

FileSizes MeasureFiles(const std::string& file)
{
  std::error_code problem;
  if (!fs::is_directory(file, problem))
  {
    return { 1, fs::file_size(file, problem) };
  }
  FileSizes sizes;
  for (const auto& entry : fs::directory_iterator(file))
  {
    ++sizes.Files;
    sizes.Bytes += entry.is_regular_file(problem) ? entry.file_size(problem) : 0;
  }
  return sizes;
}

double GetBytesPerSample(vtkInformation* announced)
{
  vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
    announced, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  if (!scalars)
  {
    return 1.0;
  }
  const int type = scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE());
  const int components = scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
  return static_cast<double>(std::max(1, vtkDataArray::GetDataTypeSize(type))) *
         std::max(1, components);
}

std::string ToText(double number)
{
  constexpr int Digits = 15;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(Digits);
  text << number;
  return text.str();
}

void CheckSpacing(vtkInformation* announced, const std::string& file)
{
  constexpr double Least = 1e-12;
  constexpr double Most = 1e12;
  const double* spacing = announced->Get(vtkDataObject::SPACING());
  if (spacing && !std::all_of(spacing, spacing + 3,
                   [](double s) { return std::abs(s) >= Least && std::abs(s) <= Most; }))
  {
    throw std::runtime_error("'" + file + "' could not be read: its spacing is (" +
                             ToText(spacing[0]) + ", " + ToText(spacing[1]) + ", " +
                             ToText(spacing[2]) +
                             "), but three numbers from 1e-12 to 1e12 are expected.");
  }
}

std::string GetEnding(const std::string& file)
{
  std::string ending = fs::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

// Of the samples that a reader is about to read.
double CheckAnnouncement(vtkInformation* announced, const std::string& file)
{
  constexpr double MostTimes = 16384; // that a compression makes less
  std::array<int, 6> extent = { 0, -1, 0, -1, 0, -1 };
  announced->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data());
  double bytes = GetBytesPerSample(announced);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double samples = static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis] + 1.0;
    if (samples < 2.0)
    {
      throw std::runtime_error(
        "'" + file + "' holds no volume, which has at least two samples along each axis.");
    }
    bytes *= samples;
  }
  CheckSpacing(announced, file);
  const std::uintmax_t present = MeasureFiles(file).Bytes;
  const std::string ending = GetEnding(file);
  const bool isElsewhere = ending == ".mhd" || ending == ".nhdr"; // and was looked at
  if (!isElsewhere && bytes > static_cast<double>(present) * MostTimes)
  {
    throw std::runtime_error("'" + file + "' could not be read: it asks for " + ToText(bytes) +
                             " bytes of samples, more than its " + std::to_string(present) +
                             " bytes can hold.");
  }
  return bytes;
}

// Of the processor, beyond a second, for so many bytes that are read. Generous, for slow machines.
double GetSeconds(const FileSizes& sizes, double bytes)
{
  constexpr double SecondsPerFile = 0.005;
  constexpr double BytesPerSecond = 4e6;
  return SecondsPerFile * static_cast<double>(sizes.Files) +
         (static_cast<double>(sizes.Bytes) + bytes) / BytesPerSecond;
}

// What a packed PVM takes beyond its samples: twice its bytes, and as many seconds as it takes to
// go through all samples, before its header is known and once more.
struct Decoding
{
  Decoding(const std::string& file, const FileSizes& sizes)
  {
    constexpr double MostTimes = 102.0;
    constexpr double BytesPerSecond = 16e6;
    if (GetEnding(file) == ".pvm")
    {
      this->Bytes = 2 * sizes.Bytes;
      this->Seconds = MostTimes * static_cast<double>(sizes.Bytes) / BytesPerSecond;
    }
  }
  std::uintmax_t Bytes = 0;
  double Seconds = 0.0;
};

// For counting what is packed.
double GetSecondsToCount(const FileSizes& sizes)
{
  constexpr double BytesPerSecond = 64e6;
  return static_cast<double>(std::min(MostTimesUnpacked * sizes.Bytes, MostToUnpack)) /
         BytesPerSecond;
}

vtkSmartPointer<vtkAlgorithm> Open(const Options& options, double& bytes)
{
  const FileSizes sizes = MeasureFiles(options.File);
  const Decoding decoding(options.File, sizes);
  const ReaderGuard guard(
    GetSeconds(sizes, 0.0) + GetSecondsToCount(sizes) + decoding.Seconds, decoding.Bytes);
  const Listening listening(options.File);
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(options);
  listening.Check();
  reader->UpdateInformation();
  listening.Check();
  bytes = CheckAnnouncement(reader->GetOutputInformation(0), options.File);
  return reader;
}

void Read(vtkAlgorithm* reader, const std::string& file, double bytes)
{
  constexpr double Copies = 3.0; // that readers hold at the same time
  const FileSizes sizes = MeasureFiles(file);
  const Decoding decoding(file, sizes);
  const double most = Copies * bytes;
  const ReaderGuard guard(
    GetSeconds(sizes, most) + decoding.Seconds, static_cast<std::uintmax_t>(most) + decoding.Bytes);
  const Listening listening(file);
  reader->Update();
  listening.Check();
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
  double bytes = 0.0;
  LoadedVolume volume;
  try
  {
    const vtkSmartPointer<vtkAlgorithm> reader = Open(options, bytes);
    Read(reader, options.File, bytes);
    volume.Image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
    volume.Anatomy = GetAnatomy(reader);
  }
  catch (const std::bad_alloc&)
  {
    throw std::runtime_error(
      "'" + options.File + "' could not be read: that takes more memory than it should.");
  }
  if (!volume.Image || !volume.Image->GetPointData()->GetScalars())
  {
    throw std::runtime_error("'" + options.File + "' holds no volume.");
  }
  return volume;
}
