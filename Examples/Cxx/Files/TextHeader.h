/// The lines of keys and values with which MetaImage and NRRD files begin.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

class TextHeader
{
public:
  /// Reads lines up to the one that has the key, or is empty where the key is "", or to the end.
  /// Keys and values are without space around them.
  /// @throws std::runtime_error  where lines or the header are longer than any person's
  TextHeader(const std::string& file, char sign, const std::string& last);

  [[noreturn]] void Refuse(const std::string& why) const;

  /// @return "" where there is none
  std::string Get(const std::string& key) const;
  /// Whether the last line came before the end of the file.
  bool IsComplete() const { return this->Complete; }
  const std::string& GetFirstLine() const { return this->FirstLine; }
  /// Bytes of the header, the last line with them.
  std::uintmax_t GetSize() const { return this->Size; }

  /// Numbers of samples along each axis.
  /// @throws std::runtime_error  where they are not so many numbers above 0
  std::vector<std::uintmax_t> GetSizes(const std::string& key, std::size_t axes) const;

  /// @return a path beside the header's own, of a regular file
  std::string GetDataFile(const std::string& key) const;

  /// Of samples from an offset of the data on: as many as the header says, no more, no less.
  void CheckRaw(const std::string& data, std::uintmax_t offset, double bytes) const;
  void CheckPacked(const std::string& data, std::uintmax_t offset, double bytes) const;
  void CheckText(const std::string& data, std::uintmax_t offset, double numbers) const;

private:
  void CheckAmount(const char* unit, double wanted, double present) const;
  void TakeLine(const std::string& line, char sign);

  std::string File;
  std::string FirstLine;
  std::map<std::string, std::string> Entries;
  std::uintmax_t Size = 0;
  bool Complete = false;
};
