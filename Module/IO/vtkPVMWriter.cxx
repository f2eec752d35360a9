#include "vtkPVMWriter.h"

#include "DDSCodec.h"
#include "PVMFormat.h"
#include "VolumeFiles.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <exception>
#include <stdexcept>

vtkStandardNewMacro(vtkPVMWriter);
vtkPVMWriter::vtkPVMWriter() = default;
vtkPVMWriter::~vtkPVMWriter()
{
  delete[] this->FileName;
}

int vtkPVMWriter::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkPVMWriter::WriteData()
{
  try
  {
    if (!this->FileName || !*this->FileName)
    {
      throw std::runtime_error("no FileName is set.");
    }
    auto* image = vtkImageData::SafeDownCast(this->GetInput());
    flatblock::VolumeFormat format;
    const std::vector<std::uint8_t> samples = flatblock::GetSamples(image, 2, format);
    std::vector<std::uint8_t> bytes = flatblock::MakePVM(format, samples.data());
    if (this->Compressed)
    {
      // Rows of samples whose bytes are sorted: those of a sample's first byte, so long as a row.
      const int strip = std::min(format.Samples[0], 65536);
      bytes = flatblock::EncodeDDS(bytes, format.BytesPerSample, strip);
    }
    flatblock::WriteBytes(this->FileName, { bytes });
  }
  catch (const std::exception& problem)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< "'" << (this->FileName ? this->FileName : "") << "': " << problem.what());
  }
}

void vtkPVMWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Compressed: " << this->Compressed << "\n";
}
