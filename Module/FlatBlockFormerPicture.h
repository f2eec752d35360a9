/// What a window showed before the frame that it is drawing.
#pragma once

#include "vtkRenderWindow.h"
#include "vtkWeakPointer.h"

#include <array>
#include <vector>

class vtkRenderer;
class vtkWindow;

namespace flatblock
{
/// Which windows show a picture that was drawn as a whole. One of another size is another one, and
/// pictures of selectors are not for people.
class FormerPictures
{
public:
  /// Also forgets those of windows that are no more.
  void Remember(vtkRenderer* renderer);
  bool Has(vtkRenderer* renderer) const;
  void Forget(vtkWindow* window);

private:
  struct Picture
  {
    vtkWeakPointer<vtkRenderWindow> Window;
    std::array<int, 2> Size;
  };
  std::vector<Picture> Pictures;
};

/// Gives up a frame: no other props are drawn, and within the renderer's viewport the window goes
/// on to show its former picture, be it on screen or not.
///
/// @param hasPicture  that the window, of its present size, has shown
void ShowFormerPicture(vtkRenderer* renderer, bool hasPicture);
} // namespace flatblock
