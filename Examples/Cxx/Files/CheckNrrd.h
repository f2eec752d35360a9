/// What vtkNrrdReader does not survive.
#pragma once

#include <string>

/// Reads the header of an NRRD file (http://teem.sourceforge.net/nrrd/format.html).
/// @throws std::runtime_error  that names the file, and the field that says something else than a
///   volume whose samples are there
void CheckNrrd(const std::string& file);
