/// What readers and writers of volume files share.
#pragma once

#include "VolumeFormat.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;
class vtkImageReader2;
class vtkInformationVector;

namespace flatblock
{
/// Throws std::runtime_error where the file can't be opened.
std::uintmax_t GetFileSize(const std::string& file);

/// At most so many bytes, from one on; fewer where the file ends.
std::vector<std::uint8_t> ReadBytes(
  const std::string& file, std::uintmax_t first, std::uintmax_t most);

/// Tells a reader where samples lie: integers, big end first, in the order of VTK's.
void SetFormat(vtkImageReader2* reader, const VolumeFormat& format);

/// Announces an empty image, so that a pipeline has nothing to add to an error that was told.
/// @return 1, for the pipeline
int AnnounceNothing(vtkInformationVector* outputs);

/// Samples of an image as unsigned integers, big end first.
/// @throws std::runtime_error  where it has none of at most so many bytes
std::vector<std::uint8_t> GetSamples(vtkImageData* image, int mostBytes, VolumeFormat& format);

/// Under another name first, so that what was there stays where it fails.
void WriteBytes(const std::string& file, const std::vector<std::vector<std::uint8_t>>& parts);
} // namespace flatblock
