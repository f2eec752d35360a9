#include "CheckMetaImage.h"

#include "TextHeader.h"

#include <map>

namespace
{
double GetBytesPerSample(const TextHeader& header)
{
  static const std::map<std::string, int> sizes = { { "MET_CHAR", 1 }, { "MET_UCHAR", 1 },
    { "MET_SHORT", 2 }, { "MET_USHORT", 2 }, { "MET_INT", 4 }, { "MET_UINT", 4 }, { "MET_LONG", 4 },
    { "MET_ULONG", 4 }, { "MET_LONG_LONG", 8 }, { "MET_ULONG_LONG", 8 }, { "MET_FLOAT", 4 },
    { "MET_DOUBLE", 8 } };
  const auto found = sizes.find(header.Get("ElementType"));
  if (found == sizes.end())
  {
    header.Refuse("ElementType is '" + header.Get("ElementType") + "', which is none of VTK's.");
  }
  const std::string key = "ElementNumberOfChannels";
  const double channels =
    header.Get(key).empty() ? 1.0 : static_cast<double>(header.GetSizes(key, 1).front());
  return found->second * channels;
}

bool IsTrue(const std::string& value)
{
  return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}

// Bytes before the samples; -1 takes the samples from the end.
double GetSkip(const TextHeader& header)
{
  const std::string size = header.Get("HeaderSize");
  if (size.empty() || size == "0" || size == "-1")
  {
    return size == "-1" ? -1.0 : 0.0;
  }
  return static_cast<double>(header.GetSizes("HeaderSize", 1).front());
}

void CheckKind(const TextHeader& header)
{
  if (!header.IsComplete() || header.Get("NDims").empty())
  {
    header.Refuse("its header ends before NDims and ElementDataFile.");
  }
  if (header.Get("NDims") != "3")
  {
    header.Refuse("NDims is '" + header.Get("NDims") + "', but 3 is expected.");
  }
  const std::string type = header.Get("ObjectType");
  if (type != "Image" && header.GetFirstLine().rfind("NDims", 0) != 0)
  {
    header.Refuse("ObjectType is '" + type + "', but Image is expected.");
  }
  const std::string data = header.Get("ElementDataFile");
  if (data.rfind("LIST", 0) == 0 || data.find('%') != std::string::npos)
  {
    header.Refuse("ElementDataFile names several files, but LOCAL or one is expected.");
  }
}
} // namespace

void CheckMetaImage(const std::string& file)
{
  const TextHeader header(file, '=', "ElementDataFile");
  CheckKind(header);
  const double size = GetBytesPerSample(header);
  double samples = 1.0;
  for (const std::uintmax_t n : header.GetSizes("DimSize", 3))
  {
    samples *= static_cast<double>(n);
  }
  const std::string data = header.Get("ElementDataFile");
  const bool isLocal = data == "LOCAL" || data == "Local" || data == "local";
  const std::string path = isLocal ? file : header.GetDataFile("ElementDataFile");
  const std::uintmax_t offset = isLocal ? header.GetSize() : 0;
  const std::string binary = header.Get("BinaryData");
  const double skip = GetSkip(header);
  if (!binary.empty() && !IsTrue(binary))
  {
    header.CheckText(path, offset, samples);
  }
  else if (IsTrue(header.Get("CompressedData")))
  {
    header.CheckPacked(path, offset, samples * size);
  }
  else if (skip >= 0.0)
  {
    header.CheckRaw(path, offset, samples * size + skip);
  }
}
