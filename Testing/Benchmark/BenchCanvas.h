/// Pictures of what VTK's 2D context draws.
#pragma once

#include <array>
#include <string>

class vtkAbstractContextItem;

namespace flatblock::benchmarks
{
/// Over white.
/// @throws std::runtime_error where the file cannot be written
void DrawToPNG(
  vtkAbstractContextItem* item, const std::array<int, 2>& size, const std::string& file);
} // namespace flatblock::benchmarks
