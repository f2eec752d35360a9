#include "BenchCanvas.h"

#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <stdexcept>

namespace flatblock::benchmarks
{
void DrawToPNG(
  vtkAbstractContextItem* item, const std::array<int, 2>& size, const std::string& file)
{
  vtkNew<vtkContextView> view;
  view->GetRenderWindow()->OffScreenRenderingOn();
  view->GetRenderWindow()->SetMultiSamples(0);
  view->GetRenderWindow()->SetSize(size[0], size[1]);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  view->GetScene()->AddItem(item);
  view->GetRenderWindow()->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(view->GetRenderWindow());
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("Cannot write '" + file + "'.");
  }
}
} // namespace flatblock::benchmarks
