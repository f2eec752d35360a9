/// vtkXMLImageDataReader for every libexpat.
#pragma once

#include "vtkXMLImageDataReader.h"

/// VTK 9.1 and 9.2 cannot read appended data where libexpat defers parsing, as it does from 2.6 on
/// and with Debian's security updates of 2.5: the parser is told not to. Refuses what CheckXMLImage
/// finds.
class XMLImageReader : public vtkXMLImageDataReader
{
public:
  static XMLImageReader* New();
  vtkTypeMacro(XMLImageReader, vtkXMLImageDataReader);

protected:
  void CreateXMLParser() override;
  int ReadPrimaryElement(vtkXMLDataElement* image) override;
};
