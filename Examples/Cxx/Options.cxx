#include "Options.h"

#include "GuessRaw.h"

#include "Presets.h"

#include "vtkType.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

const char* const Usage = R"(Draws a volume with vtkFlatBlockVolumeMapper.

FlatBlockView FILE [options]

FILE is .nii .nii.gz .nrrd .nhdr .mhd .mha .vti .vtk .pvm .df3 .tif, a folder of DICOM slices or of PNG or
TIFF images, or .raw, whose name may say what is in it (foot_256x256x256_uint8.raw), or else:
  --raw NX NY NZ TYPE      samples an axis and type: uint8 int8 uint16 int16 uint32 int32 float double
  --spacing SX SY SZ       of a raw file (1 1 1)
  --big-endian             byte order of a raw file
  --header BYTES           of a raw file, before its samples (0)

  --preset NAME            transfer function: mri, ct-bone, ct-skin, angio, grey
                           (chosen by the data's percentiles)
  --output FILE.png        where the picture goes (flatblock.png)
  --size WIDTH HEIGHT      pixels (800 800)
  --block-size 17|33|65    samples a block's side (33)
  --sample-distance D      between samples along a ray (half of the smallest spacing)
  --memory MIB             limit of graphics memory (256)
  --interactive            opens a window
  --default FILE           what is drawn where no FILE is named
  --help
)";

namespace
{
[[noreturn]] void Refuse(const std::string& message)
{
  throw std::runtime_error(message);
}

class Words
{
public:
  Words(int argc, char* argv[]) : Rest(argv + 1, argv + argc) {}
  bool IsEmpty() const { return this->Next == this->Rest.size(); }

  std::string Take(const std::string& what)
  {
    if (this->IsEmpty())
    {
      Refuse("After " + what + " something is missing.");
    }
    return this->Rest[this->Next++];
  }

  template <typename T>
  T TakeNumber(const std::string& what, T least, T most)
  {
    const std::string word = this->Take(what);
    std::istringstream stream(word);
    T number;
    stream >> number;
    if (stream.fail() || !stream.eof() || !(number >= least && number <= most))
    {
      std::ostringstream message;
      message << "'" << word << "' after " << what << " is not a number from " << least << " to "
              << most << ".";
      Refuse(message.str());
    }
    return number;
  }

private:
  std::vector<std::string> Rest;
  std::size_t Next = 0;
};

int ToScalarType(const std::string& name)
{
  const int type = FindScalarType(name);
  if (type == 0)
  {
    Refuse(
      "'" + name + "' after --raw is none of uint8 int8 uint16 int16 uint32 int32 float double.");
  }
  return type;
}

void TakeOption(const std::string& option, Words& words, Options& options)
{
  constexpr int Most = 1 << 20;
  if (option == "--raw")
  {
    options.IsRaw = true;
    for (int& n : options.Raw.Dimensions)
    {
      n = words.TakeNumber(option, 2, Most);
    }
    options.Raw.ScalarType = ToScalarType(words.Take(option));
  }
  else if (option == "--spacing")
  {
    for (double& s : options.Raw.Spacing)
    {
      s = words.TakeNumber(option, 1e-12, 1e12);
    }
  }
  else if (option == "--big-endian")
  {
    options.Raw.BigEndian = true;
  }
  else if (option == "--header")
  {
    options.Raw.HeaderBytes = words.TakeNumber(option, 0, 1 << 30);
  }
  else if (option == "--preset")
  {
    options.Preset = words.Take(option);
    const std::vector<std::string>& names = GetPresetNames();
    if (std::find(names.begin(), names.end(), options.Preset) == names.end())
    {
      Refuse("'" + options.Preset + "' is none of the presets mri, ct-bone, ct-skin, angio, grey.");
    }
  }
  else if (option == "--output")
  {
    options.Output = words.Take(option);
  }
  else if (option == "--size")
  {
    options.Size[0] = words.TakeNumber(option, 16, 16384);
    options.Size[1] = words.TakeNumber(option, 16, 16384);
  }
  else if (option == "--block-size")
  {
    options.BlockSize = words.TakeNumber(option, 17, 65);
    if (options.BlockSize != 17 && options.BlockSize != 33 && options.BlockSize != 65)
    {
      Refuse("A block has 17, 33 or 65 samples a side.");
    }
  }
  else if (option == "--sample-distance")
  {
    options.SampleDistance = words.TakeNumber(option, 0.0, 1e30);
  }
  else if (option == "--memory")
  {
    options.MemoryMiB = words.TakeNumber(option, 0.01, 1e6);
  }
  else if (option == "--default")
  {
    options.DefaultFile = words.Take(option);
  }
  else if (option == "--interactive")
  {
    options.Interactive = true;
  }
  else
  {
    Refuse("The option '" + option + "' is unknown.");
  }
}
} // namespace

Options ParseOptions(int argc, char* argv[])
{
  Options options;
  Words words(argc, argv);
  while (!words.IsEmpty())
  {
    const std::string word = words.Take("");
    if (word == "--help" || word == "-h")
    {
      options.Help = true;
      return options;
    }
    if (word.rfind("--", 0) == 0)
    {
      TakeOption(word, words, options);
    }
    else if (options.File.empty())
    {
      options.File = word;
    }
    else
    {
      Refuse("One file at a time: '" + options.File + "' or '" + word + "'?");
    }
  }
  if (options.File.empty())
  {
    options.File = options.DefaultFile;
  }
  if (options.File.empty())
  {
    Refuse("No file was named.");
  }
  return options;
}
