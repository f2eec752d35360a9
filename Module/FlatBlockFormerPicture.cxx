#include "vtk_glew.h"

#include "FlatBlockFormerPicture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

namespace flatblock
{
WindowPicture GetPictureOf(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const int* size = window->GetSize();
  return { window, { size[0], size[1] } };
}

void ShowFormerPicture(vtkRenderer* renderer, bool hasPicture)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  renderer->GetRenderWindow()->SetAbortRender(1); // which keeps what is on a screen
  if (!window || !hasPicture)
  {
    return;
  }
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  window->BlitDisplayFramebuffer(0, origin[0], origin[1], size[0], size[1], origin[0], origin[1],
    size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
}
} // namespace flatblock
