/// What vtkMetaImageReader does not survive.
#pragma once

#include <string>

/// Reads the header of a MetaImage file.
/// @throws std::runtime_error  that names the file, and the key that says something else than a
///   volume of three axes whose samples are there
void CheckMetaImage(const std::string& file);
