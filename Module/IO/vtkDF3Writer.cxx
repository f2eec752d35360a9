#include "vtkDF3Writer.h"

#include "DF3Format.h"
#include "VolumeFiles.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <exception>
#include <stdexcept>

vtkStandardNewMacro(vtkDF3Writer);
vtkDF3Writer::vtkDF3Writer() = default;
vtkDF3Writer::~vtkDF3Writer()
{
  delete[] this->FileName;
}

int vtkDF3Writer::FillInputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkDF3Writer::WriteData()
{
  try
  {
    if (!this->FileName || !*this->FileName)
    {
      throw std::runtime_error("no FileName is set.");
    }
    auto* image = vtkImageData::SafeDownCast(this->GetInput());
    flatblock::VolumeFormat format;
    const std::vector<std::uint8_t> samples = flatblock::GetSamples(image, 4, format);
    flatblock::WriteBytes(this->FileName, { flatblock::MakeDF3Header(format.Samples), samples });
  }
  catch (const std::exception& problem)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< "'" << (this->FileName ? this->FileName : "") << "': " << problem.what());
  }
}

void vtkDF3Writer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
