/// What a raw file holds, as far as its name and size say.
#pragma once

#include "Options.h"

#include <cstdint>

/// VTK's number for uint8 and so on; 0 for other words.
int FindScalarType(const std::string& name);

/// From "NXxNYxNZ" in the name, and "uint8" and so on, "be" or "le" between other signs; where
/// there is no type, samples of one byte; where there are no numbers, a cube of a power of two of
/// them. What follows from nothing is asked for.
/// @throws std::runtime_error  that says what to tell with --raw, and why
RawFormat GuessRaw(const std::string& file, std::uintmax_t size);
