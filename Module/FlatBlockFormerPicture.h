/// What a window showed before the frame that it is drawing.
#pragma once

#include <array>

class vtkRenderer;
class vtkRenderWindow;

namespace flatblock
{
/// Which picture a window shows: one of another window or size is another one.
struct WindowPicture
{
  const vtkRenderWindow* Window = nullptr; // only compared with
  std::array<int, 2> Size = { 0, 0 };

  bool operator==(const WindowPicture& other) const
  {
    return this->Window == other.Window && this->Size == other.Size;
  }
};
WindowPicture GetPictureOf(vtkRenderer* renderer);

/// Gives up a frame: no other props are drawn, and within the renderer's viewport the window goes
/// on to show its former picture, be it on screen or not.
///
/// @param hasPicture  that the window, of its present size, has shown
void ShowFormerPicture(vtkRenderer* renderer, bool hasPicture);
} // namespace flatblock
