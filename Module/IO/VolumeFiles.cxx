#include "VolumeFiles.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkType.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace flatblock
{
namespace
{
namespace fs = std::filesystem;

template <typename T>
void AppendBigEnd(const T* samples, vtkIdType count, std::vector<std::uint8_t>& bytes)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int shift = 8 * (static_cast<int>(sizeof(T)) - 1); shift >= 0; shift -= 8)
    {
      bytes.push_back(static_cast<std::uint8_t>(samples[i] >> shift & 255));
    }
  }
}
} // namespace

std::uintmax_t GetFileSize(const std::string& file)
{
  std::error_code problem;
  const fs::path path = fs::u8path(file);
  if (!fs::is_regular_file(path, problem))
  {
    throw std::runtime_error(fs::exists(path, problem) ? "it is no file." : "it does not exist.");
  }
  const std::uintmax_t size = fs::file_size(path, problem);
  if (problem || !std::ifstream(path, std::ios::binary))
  {
    throw std::runtime_error("it cannot be opened for reading.");
  }
  return size;
}

std::vector<std::uint8_t> ReadBytes(
  const std::string& file, std::uintmax_t first, std::uintmax_t most)
{
  const std::uintmax_t size = GetFileSize(file);
  std::vector<std::uint8_t> bytes(
    static_cast<std::size_t>(first < size ? std::min(most, size - first) : 0));
  std::ifstream stream(fs::u8path(file), std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(first));
  if (!bytes.empty() && !stream.read(reinterpret_cast<char*>(bytes.data()),
                          static_cast<std::streamsize>(bytes.size())))
  {
    throw FormatError(first, "the file cannot be read.");
  }
  return bytes;
}

void SetFormat(vtkImageReader2* reader, const VolumeFormat& format)
{
  const int types[] = { 0, VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, 0, VTK_UNSIGNED_INT };
  const auto& samples = format.Samples;
  reader->SetFileDimensionality(3);
  reader->SetDataExtent(0, samples[0] - 1, 0, samples[1] - 1, 0, samples[2] - 1);
  reader->SetDataSpacing(format.Spacing.data());
  reader->SetDataOrigin(0.0, 0.0, 0.0);
  reader->SetDataScalarType(types[format.BytesPerSample]);
  reader->SetNumberOfScalarComponents(1);
  reader->SetDataByteOrderToBigEndian();
  reader->SetHeaderSize(static_cast<unsigned long>(format.Offset));
  reader->FileLowerLeftOn();
}

int AnnounceNothing(vtkInformationVector* outputs)
{
  const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
  outputs->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), nothing, 6);
  return 1;
}

std::vector<std::uint8_t> GetSamples(vtkImageData* image, int mostBytes, VolumeFormat& format)
{
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("The input has no scalars of one component.");
  }
  image->GetDimensions(format.Samples.data());
  image->GetSpacing(format.Spacing.data());
  format.BytesPerSample = scalars->GetDataTypeSize();
  const vtkIdType count = scalars->GetNumberOfTuples();
  const void* samples = scalars->GetVoidPointer(0);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(static_cast<std::size_t>(count) * format.BytesPerSample);
  if (scalars->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    AppendBigEnd(static_cast<const unsigned char*>(samples), count, bytes);
  }
  else if (scalars->GetDataType() == VTK_UNSIGNED_SHORT)
  {
    AppendBigEnd(static_cast<const unsigned short*>(samples), count, bytes);
  }
  else if (scalars->GetDataType() == VTK_UNSIGNED_INT && mostBytes >= 4)
  {
    AppendBigEnd(static_cast<const unsigned int*>(samples), count, bytes);
  }
  else
  {
    throw std::runtime_error("Scalars are of type " + std::string(scalars->GetDataTypeAsString()) +
                             ", but unsigned integers of 1" +
                             (mostBytes >= 4 ? ", 2 or 4" : " or 2") + " bytes are expected.");
  }
  return bytes;
}

void WriteBytes(const std::string& file, const std::vector<std::vector<std::uint8_t>>& parts)
{
  const fs::path path = fs::u8path(file);
  fs::path unfinished = path;
  unfinished += ".part";
  std::error_code problem;
  {
    std::ofstream stream(unfinished, std::ios::binary);
    for (const auto& part : parts)
    {
      stream.write(
        reinterpret_cast<const char*>(part.data()), static_cast<std::streamsize>(part.size()));
    }
    stream.close();
    if (!stream)
    {
      fs::remove(unfinished, problem);
      throw std::runtime_error("it cannot be written.");
    }
  }
  fs::rename(unfinished, path, problem);
  if (problem)
  {
    fs::remove(unfinished, problem);
    throw std::runtime_error("it cannot be written.");
  }
}
} // namespace flatblock
