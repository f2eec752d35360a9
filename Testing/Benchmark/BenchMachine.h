/// What the numbers were measured on, and when.
#pragma once

#include <string>

class vtkRenderWindow;

namespace flatblock::benchmarks
{
std::string GetToday();
std::string GetProcessor();
/// Renderer and version.
std::string GetOpenGL(vtkRenderWindow* window);
} // namespace flatblock::benchmarks
