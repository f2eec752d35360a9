#include "BenchCranium.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace flatblock::benchmarks
{
namespace
{
constexpr const char* Archive = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";

// The folder inside the archive has a random name.
std::string GetCommand()
{
  if (const char* file = std::getenv("FLATBLOCK_SKULL"))
  {
    return "cat '" + std::string(file) + "'";
  }
  return "tar -xzOf " + std::string(Archive) + " --wildcards '*/matrix.dat'";
}
} // namespace

vtkSmartPointer<vtkImageData> ReadCranium()
{
  if (!std::getenv("FLATBLOCK_SKULL") && !std::filesystem::exists(Archive))
  {
    return {};
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(256, 256, 108);
  image->SetSpacing(0.957, 0.957, 1.5);
  image->AllocateScalars(VTK_SHORT, 1);
  const auto expected = static_cast<std::size_t>(image->GetNumberOfPoints());
  std::FILE* pipe = popen(GetCommand().c_str(), "r");
  if (!pipe)
  {
    return {};
  }
  const std::size_t taken = std::fread(image->GetScalarPointer(), 2, expected, pipe);
  const bool isWhole = pclose(pipe) == 0 && taken == expected;
  return isWhole ? image : nullptr;
}
} // namespace flatblock::benchmarks
