#include "vtkPVMReader.h"

#include "DDSCodec.h"
#include "PVMFormat.h"
#include "VolumeFiles.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkPVMReader);
vtkPVMReader::vtkPVMReader() = default;
vtkPVMReader::~vtkPVMReader() = default;

namespace
{
// Of four texts; longer ones are no texts.
constexpr std::uintmax_t MostRest = std::uintmax_t(1) << 20;

struct Header
{
  flatblock::PVMFormat Format;
  bool IsCompressed = false;
  std::vector<std::uint8_t> Stream; // the file, where it is compressed
};

// Of a stream that is not decoded yet.
void CheckStream(const flatblock::PVMFormat& format, const std::vector<std::uint8_t>& stream)
{
  const std::uintmax_t total = flatblock::CountDDS(stream.data(), stream.size());
  const std::uintmax_t end = format.Offset + flatblock::CountBytes(format);
  if (total < end || total > end + MostRest)
  {
    flatblock::CheckPVMSize(format, total, {});
  }
}

Header ReadHeader(const std::string& file)
{
  Header header;
  const std::uintmax_t size = flatblock::GetFileSize(file);
  const std::vector<std::uint8_t> bytes =
    flatblock::ReadBytes(file, 0, flatblock::MostPVMHeaderBytes);
  header.IsCompressed = flatblock::IsDDS(bytes.data(), bytes.size());
  if (!header.IsCompressed)
  {
    header.Format = flatblock::ParsePVM(bytes.data(), bytes.size());
    const std::uintmax_t end = header.Format.Offset + flatblock::CountBytes(header.Format);
    flatblock::CheckPVMSize(header.Format, size, flatblock::ReadBytes(file, end, MostRest));
    return header;
  }
  header.Stream = flatblock::ReadBytes(file, 0, std::numeric_limits<std::uintmax_t>::max());
  const std::vector<std::uint8_t> decoded =
    flatblock::DecodeDDS(header.Stream.data(), header.Stream.size(), flatblock::MostPVMHeaderBytes);
  header.Format = flatblock::ParsePVM(decoded.data(), decoded.size());
  CheckStream(header.Format, header.Stream);
  return header;
}

// The file may be another one by now than when its extent was asked for.
void CheckExtent(const flatblock::PVMFormat& format, const int extent[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (extent[2 * axis] < 0 || extent[2 * axis + 1] >= format.Samples[axis])
    {
      throw std::runtime_error("it has fewer samples than before.");
    }
  }
}

template <typename T>
void CopyRows(
  const std::uint8_t* bytes, const std::array<int, 3>& samples, const int extent[6], T* out)
{
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      const std::uint8_t* row =
        bytes +
        ((static_cast<std::size_t>(z) * samples[1] + y) * samples[0] + extent[0]) * sizeof(T);
      for (int x = extent[0]; x <= extent[1]; ++x)
      {
        T value = 0;
        for (std::size_t i = 0; i < sizeof(T); ++i)
        {
          value = static_cast<T>(value << 8 * (sizeof(T) > 1) | *row++);
        }
        *out++ = value;
      }
    }
  }
}
} // namespace

unsigned long vtkPVMReader::GetErrorCode()
{
  constexpr unsigned long Failed = vtkErrorCode::FileFormatError;
  return this->HasFailed ? Failed : this->Superclass::GetErrorCode();
}

int vtkPVMReader::CanReadFile(const char* file)
{
  try
  {
    ReadHeader(file);
    return 3;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

void vtkPVMReader::Fail(const char* problem)
{
  this->HasFailed = true;
  this->SetDataExtent(0, -1, 0, -1, 0, -1);
  vtkErrorMacro(<< "'" << (this->GetFileName() ? this->GetFileName() : "") << "': " << problem);
}

// A failure has been told, and the pipeline must not add to it.
vtkTypeBool vtkPVMReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const vtkTypeBool isDone = this->Superclass::ProcessRequest(request, inputs, outputs);
  return this->HasFailed ? flatblock::AnnounceNothing(outputs) : isDone;
}

void vtkPVMReader::ExecuteInformation()
{
  this->HasFailed = false;
  try
  {
    if (!this->GetFileName())
    {
      throw std::runtime_error("no FileName is set.");
    }
    const Header header = ReadHeader(this->GetFileName());
    this->IsCompressed = header.IsCompressed;
    flatblock::SetFormat(this, header.Format);
  }
  catch (const std::exception& problem)
  {
    this->Fail(problem.what());
  }
  this->Superclass::ExecuteInformation();
}

void vtkPVMReader::ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* info)
{
  try
  {
    if (!this->HasFailed && !this->IsCompressed)
    {
      return this->Superclass::ExecuteDataWithInformation(output, info);
    }
    if (!this->HasFailed)
    {
      return this->Decode(output, info);
    }
  }
  catch (const std::exception& problem)
  {
    this->Fail(problem.what());
  }
  output->Initialize();
}

void vtkPVMReader::Decode(vtkDataObject* output, vtkInformation* info)
{
  const Header header = ReadHeader(this->GetFileName());
  const flatblock::PVMFormat& format = header.Format;
  this->UpdateProgress(0.1);
  const auto end = static_cast<std::size_t>(format.Offset + flatblock::CountBytes(format));
  const std::vector<std::uint8_t> decoded =
    flatblock::DecodeDDS(header.Stream.data(), header.Stream.size(), end + MostRest);
  const auto samplesEnd =
    decoded.begin() + static_cast<std::ptrdiff_t>(std::min(end, decoded.size()));
  flatblock::CheckPVMSize(format, decoded.size(), { samplesEnd, decoded.end() });
  this->UpdateProgress(0.8);
  vtkImageData* image = this->AllocateOutputData(output, info);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->SetName("ImageFile"); // as the superclass calls those that it reads
  CheckExtent(format, image->GetExtent());
  if (scalars->GetDataTypeSize() != format.BytesPerSample)
  {
    throw std::runtime_error("its samples are of another size than before.");
  }
  const std::uint8_t* samples = decoded.data() + format.Offset;
  if (format.BytesPerSample == 1)
  {
    CopyRows(samples, format.Samples, image->GetExtent(),
      static_cast<std::uint8_t*>(scalars->GetVoidPointer(0)));
  }
  else
  {
    CopyRows(samples, format.Samples, image->GetExtent(),
      static_cast<std::uint16_t*>(scalars->GetVoidPointer(0)));
  }
  this->UpdateProgress(1.0);
}
