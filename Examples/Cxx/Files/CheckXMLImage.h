/// What vtkXMLImageDataReader does not notice or survive.
#pragma once

#include <cstdint>
#include <string>

class vtkXMLDataElement;

/// Where the samples of an XML file lie that are appended to it.
struct AppendedData
{
  std::string File;
  std::uintmax_t Position = 0; ///< of the first block
  int BytesPerSize = 4;        ///< of the number of bytes before each block
  bool IsSwapped = false;      ///< that number
  bool IsPlain = false;        ///< neither compressed nor as text
};

/// Removes what no picture needs, but what can make VTK's reader crash, refuse the file or take
/// much memory: arrays of texts or bits, fields, and pieces without samples.
void KeepNumbers(vtkXMLDataElement* image);

/// @param image  the element ImageData of a file of VTK's XML
/// @return "", or what is wrong with it
std::string CheckXMLImage(vtkXMLDataElement* image, const AppendedData& appended);
