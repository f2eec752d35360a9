#include "CheckNrrd.h"

#include "TextHeader.h"

#include <map>

namespace
{
double GetBytesPerSample(const TextHeader& header)
{
  static const std::map<std::string, int> sizes = { { "signed char", 1 }, { "int8", 1 },
    { "int8_t", 1 }, { "uchar", 1 }, { "unsigned char", 1 }, { "uint8", 1 }, { "uint8_t", 1 },
    { "short", 2 }, { "short int", 2 }, { "signed short", 2 }, { "signed short int", 2 },
    { "int16", 2 }, { "int16_t", 2 }, { "ushort", 2 }, { "unsigned short", 2 },
    { "unsigned short int", 2 }, { "uint16", 2 }, { "uint16_t", 2 }, { "int", 4 },
    { "signed int", 4 }, { "int32", 4 }, { "int32_t", 4 }, { "uint", 4 }, { "unsigned int", 4 },
    { "uint32", 4 }, { "uint32_t", 4 }, { "longlong", 8 }, { "long long", 8 },
    { "long long int", 8 }, { "signed long long", 8 }, { "signed long long int", 8 },
    { "int64", 8 }, { "int64_t", 8 }, { "ulonglong", 8 }, { "unsigned long long", 8 },
    { "unsigned long long int", 8 }, { "uint64", 8 }, { "uint64_t", 8 }, { "float", 4 },
    { "double", 8 } };
  const auto found = sizes.find(header.Get("type"));
  if (found == sizes.end())
  {
    header.Refuse("type is '" + header.Get("type") + "', which is none of NRRD's numbers.");
  }
  return found->second;
}

void CheckData(
  const TextHeader& header, const std::string& data, std::uintmax_t offset, double samples)
{
  const std::string encoding = header.Get("encoding");
  if (encoding == "raw")
  {
    header.CheckRaw(data, offset, samples * GetBytesPerSample(header));
  }
  else if (encoding == "gzip" || encoding == "gz")
  {
    header.CheckPacked(data, offset, samples * GetBytesPerSample(header));
  }
  else if (encoding == "ascii" || encoding == "text" || encoding == "txt")
  {
    header.CheckText(data, offset, samples);
  }
  else
  {
    header.Refuse("encoding is '" + encoding + "', but raw, gzip or ascii is expected.");
  }
}

double CountSamples(const TextHeader& header)
{
  const std::string axes = header.Get("dimension");
  if (axes != "3" && axes != "4")
  {
    header.Refuse("dimension is '" + axes + "', but 3, or 4 with one of colours, is expected.");
  }
  double samples = 1.0;
  for (const std::uintmax_t size : header.GetSizes("sizes", axes == "3" ? 3 : 4))
  {
    samples *= static_cast<double>(size);
  }
  return samples;
}
} // namespace

void CheckNrrd(const std::string& file)
{
  const TextHeader header(file, ':', "");
  const std::string& magic = header.GetFirstLine();
  if (magic.size() != 8 || magic.rfind("NRRD000", 0) != 0 || magic[7] < '1' || magic[7] > '5')
  {
    header.Refuse("it begins with none of NRRD0001 to NRRD0005.");
  }
  const double samples = CountSamples(header);
  GetBytesPerSample(header);
  const char* key = header.Get("data file").empty() ? "datafile" : "data file";
  const std::string data = header.Get(key);
  if (data.empty() && !header.IsComplete())
  {
    header.Refuse("its header ends before an empty line.");
  }
  // What is skipped by lines or bytes, or in several files, is left to the reader.
  const bool isMany = data.rfind("LIST", 0) == 0 || data.find('%') != std::string::npos;
  if (isMany || !header.Get("byte skip").empty() || !header.Get("line skip").empty())
  {
    return;
  }
  CheckData(header, data.empty() ? file : header.GetDataFile(key),
    data.empty() ? header.GetSize() : 0, samples);
}
