#include "XMLImageReader.h"

#include "vtkObjectFactory.h"
#include "vtkXMLDataParser.h"

#include <dlfcn.h>

namespace
{
class UndeferredParser : public vtkXMLDataParser
{
public:
  static UndeferredParser* New();
  vtkTypeMacro(UndeferredParser, vtkXMLDataParser);

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
