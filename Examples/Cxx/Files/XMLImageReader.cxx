#include "XMLImageReader.h"

#include "CheckXMLImage.h"

#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <cstring>

#include <dlfcn.h>

namespace
{
class UndeferredParser : public vtkXMLDataParser
{
public:
  static UndeferredParser* New();
  vtkTypeMacro(UndeferredParser, vtkXMLDataParser);

  AppendedData GetAppended(const char* file) const
  {
    AppendedData appended;
    vtkXMLDataElement* root = this->RootElement;
    vtkXMLDataElement* data = root->FindNestedElementWithName("AppendedData");
    const char* encoding = data ? data->GetAttribute("encoding") : nullptr;
    appended.File = file;
    appended.Position = static_cast<std::uintmax_t>(this->AppendedDataPosition);
    appended.BytesPerSize = this->HeaderType == 64 ? 8 : 4;
    appended.IsSwapped = this->ByteOrder == BigEndian;
    appended.IsPlain =
      encoding && std::strcmp(encoding, "raw") == 0 && !root->GetAttribute("compressor");
    return appended;
  }

protected:
  int CreateParser() override
  {
    using SetReparseDeferralEnabled = unsigned char (*)(void* parser, unsigned char enabled);
    const int created = this->Superclass::CreateParser();
    // Asked for by name, since an older libexpat neither has it nor needs it.
    const auto setEnabled = reinterpret_cast<SetReparseDeferralEnabled>(
      dlsym(RTLD_DEFAULT, "XML_SetReparseDeferralEnabled"));
    if (created && setEnabled)
    {
      setEnabled(this->Parser, 0);
    }
    return created;
  }
};
vtkStandardNewMacro(UndeferredParser);
} // namespace

vtkStandardNewMacro(XMLImageReader);

void XMLImageReader::CreateXMLParser()
{
  this->XMLParser = UndeferredParser::New();
}

int XMLImageReader::ReadPrimaryElement(vtkXMLDataElement* image)
{
  KeepNumbers(image);
  const std::string problem = CheckXMLImage(
    image, static_cast<UndeferredParser*>(this->XMLParser)->GetAppended(this->FileName));
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  return this->Superclass::ReadPrimaryElement(image);
}
