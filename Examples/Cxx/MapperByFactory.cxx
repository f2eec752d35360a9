// A program that knows no mapper by name, as one that uses vtkSmartVolumeMapper: it asks VTK's
// object factory for a vtkVolumeMapper, and takes a smart one where none is registered.
//
// MapperByFactory PICTURE.png [--plain]
#include "vtkColorTransferFunction.h"
#include "vtkFlatBlockVolumeMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVersion.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <cstring>
#include <iostream>

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkFlatBlockVolumeMapper)

class FlatBlockFactory : public vtkObjectFactory
{
public:
  static FlatBlockFactory* New()
  {
    auto* factory = new FlatBlockFactory;
    factory->InitializeObjectBase();
    return factory;
  }
  vtkTypeMacro(FlatBlockFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Volumes from flat blocks"; }

protected:
  FlatBlockFactory()
  {
    this->RegisterOverride("vtkVolumeMapper", "vtkFlatBlockVolumeMapper", "from flat blocks", 1,
      vtkObjectFactoryCreatevtkFlatBlockVolumeMapper);
  }
};

vtkSmartPointer<vtkVolumeMapper> MakeVolumeMapper()
{
  auto* mapper = vtkVolumeMapper::SafeDownCast(vtkObjectFactory::CreateInstance("vtkVolumeMapper"));
  if (mapper)
  {
    return vtkSmartPointer<vtkVolumeMapper>::Take(mapper);
  }
  return vtkSmartPointer<vtkSmartVolumeMapper>::New();
}

void SetFunctions(vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(60.0, 0.1, 0.2, 0.8);
  color->AddRGBPoint(270.0, 1.0, 0.8, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(130.0, 0.0);
  opacity->AddPoint(270.0, 0.2);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
}

void Write(vtkRenderWindow* window, const char* file)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file);
  writer->Write();
}
} // namespace

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "MapperByFactory PICTURE.png [--plain]\n";
    return 1;
  }
  if (argc < 3 || std::strcmp(argv[2], "--plain") != 0)
  {
    vtkNew<FlatBlockFactory> factory;
    vtkObjectFactory::RegisterFactory(factory);
  }
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-40, 40, -40, 40, -40, 40);
  const vtkSmartPointer<vtkVolumeMapper> mapper = MakeVolumeMapper();
  mapper->SetInputConnection(wavelet->GetOutputPort());
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  SetFunctions(volume->GetProperty());
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(256, 256);
  window->AddRenderer(renderer);
  window->Render();
  Write(window, argv[1]);
  std::cout << mapper->GetClassName() << "\n";
  vtkObjectFactory::UnRegisterAllFactories();
  return 0;
}
