#include "vtk_glew.h"

#include "BenchMachine.h"

#include "vtkRenderWindow.h"

#include <ctime>
#include <fstream>
#include <thread>

namespace flatblock::benchmarks
{
std::string GetToday()
{
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::localtime(&now));
  return text;
}

std::string GetProcessor()
{
  const std::string cores = std::to_string(std::thread::hardware_concurrency()) + " cores";
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line))
  {
    if (line.rfind("model name", 0) == 0)
    {
      return line.substr(line.find(':') + 2) + ", " + cores;
    }
  }
  return cores;
}

std::string GetOpenGL(vtkRenderWindow* window)
{
  window->MakeCurrent();
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  return std::string(renderer ? renderer : "unknown renderer") + ", OpenGL " +
         (version ? version : "unknown");
}
} // namespace flatblock::benchmarks
