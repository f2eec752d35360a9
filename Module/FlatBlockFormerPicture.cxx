#include "vtk_glew.h"

#include "FlatBlockFormerPicture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace flatblock
{
namespace
{
std::array<int, 2> GetSize(vtkRenderer* renderer)
{
  const int* size = renderer->GetRenderWindow()->GetSize();
  return { size[0], size[1] };
}
} // namespace

void FormerPictures::Remember(vtkRenderer* renderer)
{
  if (!renderer->GetSelector())
  {
    this->Forget(renderer->GetRenderWindow());
    this->Pictures.push_back({ renderer->GetRenderWindow(), GetSize(renderer) });
  }
}

bool FormerPictures::Has(vtkRenderer* renderer) const
{
  const auto isIt = [renderer](const Picture& picture)
  { return picture.Window == renderer->GetRenderWindow() && picture.Size == GetSize(renderer); };
  return !renderer->GetSelector() &&
         std::any_of(this->Pictures.begin(), this->Pictures.end(), isIt);
}

void FormerPictures::Forget(vtkWindow* window)
{
  const auto isGone = [window](const Picture& picture)
  { return !picture.Window || picture.Window == window; };
  this->Pictures.erase(
    std::remove_if(this->Pictures.begin(), this->Pictures.end(), isGone), this->Pictures.end());
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
