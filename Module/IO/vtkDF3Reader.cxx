#include "vtkDF3Reader.h"

#include "DF3Format.h"
#include "VolumeFiles.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDF3Reader);
vtkDF3Reader::vtkDF3Reader() = default;
vtkDF3Reader::~vtkDF3Reader() = default;

namespace
{
flatblock::VolumeFormat ReadFormat(const char* file)
{
  const std::vector<std::uint8_t> header = flatblock::ReadBytes(file, 0, flatblock::DF3HeaderBytes);
  return flatblock::ParseDF3(header.data(), header.size(), flatblock::GetFileSize(file));
}
} // namespace

unsigned long vtkDF3Reader::GetErrorCode()
{
  constexpr unsigned long Failed = vtkErrorCode::FileFormatError;
  return this->HasFailed ? Failed : this->Superclass::GetErrorCode();
}

int vtkDF3Reader::CanReadFile(const char* file)
{
  try
  {
    ReadFormat(file);
    return 3;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

// A failure has been told, and the pipeline must not add to it.
vtkTypeBool vtkDF3Reader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const vtkTypeBool isDone = this->Superclass::ProcessRequest(request, inputs, outputs);
  return this->HasFailed ? flatblock::AnnounceNothing(outputs) : isDone;
}

void vtkDF3Reader::ExecuteInformation()
{
  this->HasFailed = true;
  try
  {
    if (!this->GetFileName())
    {
      throw std::runtime_error("no FileName is set.");
    }
    flatblock::SetFormat(this, ReadFormat(this->GetFileName()));
    this->HasFailed = false;
  }
  catch (const std::exception& problem)
  {
    this->SetDataExtent(0, -1, 0, -1, 0, -1);
    vtkErrorMacro(<< "'" << (this->GetFileName() ? this->GetFileName() : "")
                  << "': " << problem.what());
  }
  this->Superclass::ExecuteInformation();
}

void vtkDF3Reader::ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* info)
{
  if (this->HasFailed)
  {
    output->Initialize();
    return;
  }
  this->Superclass::ExecuteDataWithInformation(output, info);
}
