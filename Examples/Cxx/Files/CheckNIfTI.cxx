#include "CheckNIfTI.h"

#include "DataSize.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>

namespace
{
constexpr std::size_t Size1 = 348;
constexpr std::size_t Size2 = 540;

// Bytes of a header of either version, and where its fields lie.
class Header
{
public:
  explicit Header(const std::string& file) : File(file)
  {
    const gzFile stream = gzopen(file.c_str(), "rb");
    const int read = stream ? gzread(stream, this->Bytes.data(), Size2) : -1;
    this->Packed = stream && gzdirect(stream) == 0;
    if (stream)
    {
      gzclose(stream);
    }
    this->Count = static_cast<std::size_t>(std::max(read, 0));
    this->Swapped = this->Find(true);
    if (!this->Swapped && !this->Find(false))
    {
      this->Refuse("it does not begin with a header of 348 or 540 bytes.");
    }
    const char* magic = this->Version == 1 ? &this->Bytes[344] : &this->Bytes[4];
    if (std::memcmp(magic, this->Version == 1 ? "n+1" : "n+2", 4) != 0)
    {
      this->Refuse("its header has no 'n+1' or 'n+2', so that it holds no samples.");
    }
  }

  [[noreturn]] void Refuse(const std::string& why) const
  {
    throw std::runtime_error("'" + this->File + "' could not be read: " + why);
  }

  bool IsPacked() const { return this->Packed; }
  long long GetSize(std::size_t axis) const // 0: how many axes there are
  {
    return this->Version == 1 ? this->Get<std::int16_t>(40 + 2 * axis)
                              : this->Get<std::int64_t>(16 + 8 * axis);
  }
  int GetType() const { return this->Get<std::int16_t>(this->Version == 1 ? 70 : 12); }
  double GetOffset() const
  {
    return this->Version == 1 ? this->Get<float>(108)
                              : static_cast<double>(this->Get<std::int64_t>(168));
  }
  double GetSpacing(std::size_t axis) const
  {
    return this->Version == 1 ? this->Get<float>(76 + 4 * axis) : this->Get<double>(104 + 8 * axis);
  }
  // Whether the quaternion is used, and whether the affine is.
  bool HasQuaternion() const { return this->GetCode(this->Version == 1 ? 252 : 344) > 0; }
  bool HasAffine() const { return this->GetCode(this->Version == 1 ? 254 : 348) > 0; }
  // The quaternion with its offset, and the three rows of the affine.
  double GetPlacing(std::size_t i) const
  {
    return this->Version == 1 ? this->Get<float>(256 + 4 * i) : this->Get<double>(352 + 8 * i);
  }

private:
  int GetCode(std::size_t offset) const
  {
    return this->Version == 1 ? this->Get<std::int16_t>(offset) : this->Get<std::int32_t>(offset);
  }

  bool Find(bool swapped)
  {
    this->Swapped = swapped;
    const auto size = static_cast<std::size_t>(this->Get<std::int32_t>(0));
    this->Version = size == Size2 ? 2 : 1;
    return (size == Size1 || size == Size2) && this->Count >= size;
  }

  template <typename T>
  T Get(std::size_t offset) const
  {
    std::array<char, sizeof(T)> bytes;
    std::copy_n(
      this->Bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), bytes.begin());
    if (this->Swapped)
    {
      std::reverse(bytes.begin(), bytes.end());
    }
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  std::string File;
  std::array<char, Size2> Bytes = {};
  std::size_t Count = 0;
  int Version = 1;
  bool Swapped = false;
  bool Packed = false;
};

double GetBytesPerSample(const Header& header)
{
  static const std::map<int, int> sizes = { { 2, 1 }, { 4, 2 }, { 8, 4 }, { 16, 4 }, { 32, 8 },
    { 64, 8 }, { 128, 3 }, { 256, 1 }, { 512, 2 }, { 768, 4 }, { 1024, 8 }, { 1280, 8 },
    { 1792, 16 }, { 2304, 4 } };
  const auto found = sizes.find(header.GetType());
  if (found == sizes.end())
  {
    header.Refuse(
      "its datatype is " + std::to_string(header.GetType()) + ", which VTK cannot read.");
  }
  return found->second;
}

double CountSamples(const Header& header)
{
  const long long axes = header.GetSize(0);
  if (axes < 1 || axes > 7)
  {
    header.Refuse("it has " + std::to_string(axes) + " axes, but 1 to 7 are expected.");
  }
  double samples = 1.0;
  for (std::size_t axis = 1; axis <= static_cast<std::size_t>(axes); ++axis)
  {
    const long long size = header.GetSize(axis);
    if (size < 1)
    {
      header.Refuse("dim[" + std::to_string(axis) + "] is " + std::to_string(size) + ".");
    }
    samples *= static_cast<double>(size);
  }
  return samples;
}

void CheckPlacing(const Header& header)
{
  constexpr double Most = 1e12;
  constexpr std::size_t OfQuaternion = 6;
  constexpr std::size_t OfBoth = 18;
  bool isGood = true;
  for (std::size_t axis = 1; axis <= 3; ++axis)
  {
    isGood = isGood && std::abs(header.GetSpacing(axis)) <= Most; // false for NaN
  }
  for (std::size_t i = 0; i < OfBoth; ++i)
  {
    const bool isUsed = i < OfQuaternion ? header.HasQuaternion() : header.HasAffine();
    isGood = isGood && (!isUsed || std::abs(header.GetPlacing(i)) <= Most);
  }
  if (!isGood)
  {
    header.Refuse("its spacing or orientation has a number that is not finite, or above 1e12.");
  }
}
} // namespace

void CheckNIfTI(const std::string& file)
{
  const Header header(file);
  constexpr double Most = 1e18;
  const double offset = header.GetOffset();
  const double samples = CountSamples(header) * GetBytesPerSample(header);
  CheckPlacing(header);
  if (!(offset >= Size1 && offset <= Most))
  {
    header.Refuse("its vox_offset is none from 348 on.");
  }
  const double bytes = samples + offset;
  const double present = static_cast<double>(
    header.IsPacked() ? CountUnpacked(file, 0, static_cast<std::uintmax_t>(std::min(bytes, Most)))
                      : CountBytes(file, 0));
  if (present != bytes)
  {
    header.Refuse(std::string("by its header it should hold ") +
                  (present > bytes ? "less" : "more") + " than it does.");
  }
}
