/// Scenes that tests draw, and measures of the pictures.
#pragma once

#include "vtkCamera.h"
#include "vtkFlatBlockVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <functional>
#include <string>
#include <vector>

namespace flatblock::testing
{
/// A volume in an off-screen window of 256 x 256 pixels, without multisampling. It is drawn by
/// vtkFlatBlockVolumeMapper, or by the peer, vtkGPUVolumeRayCastMapper, at the same sample
/// distance.
class Scene
{
public:
  Scene();

  /// Both mappers draw this image with this step.
  void SetVolume(vtkImageData* image, double sampleDistance);

  /// Points of the scalar opacity: value, opacity.
  void SetOpacity(const std::vector<std::pair<double, double>>& points);

  /// Points of the colour: value, red, green, blue.
  void SetColor(const std::vector<std::array<double, 4>>& points);

  /// A ramp of colour and of opacity up to `opacity` over [lowest, highest].
  void SetRamp(double lowest, double highest, double opacity);

  /// Looks at everything from the given azimuth and elevation, in degrees.
  void LookFrom(double azimuth, double elevation, double zoom = 1.0);

  vtkSmartPointer<vtkImageData> Draw();
  vtkSmartPointer<vtkImageData> DrawWithPeer();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkFlatBlockVolumeMapper> Mapper;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkVolume> Volume;
  vtkSmartPointer<vtkVolumeMapper> Peer;
};

/// Bytes of index texture, tables and depth in the windows of tests, at most: all but the atlas.
constexpr vtkTypeInt64 Beside = 1 << 19;

/// A translucent shell of the Marschner-Lobb signal in 8^3 blocks of 17, half of them visible.
void ShowShell(Scene& scene, vtkTypeInt64 maxMemoryInBytes);

/// Bricks of all levels.
vtkTypeInt64 CountBricks(vtkFlatBlockVolumeMapper* mapper);

/// The window's picture, RGB, 8 bit.
vtkSmartPointer<vtkImageData> Grab(vtkRenderWindow* window);

/// Peak signal-to-noise ratio of two RGB pictures in dB, 200 for equal ones.
double PSNR(vtkImageData* a, vtkImageData* b);

/// Largest difference of a channel, in 1/255.
double LargestDifference(vtkImageData* a, vtkImageData* b);

/// Share of pixels of which a channel differs by more than so many 255ths.
double ShareThatDiffers(vtkImageData* a, vtkImageData* b, int most);

/// Whether a picture is not all of one colour: what is compared must show something.
bool ShowsSomething(vtkImageData* picture);

/// Compares the window with Testing/Data/Baseline/NAME.png by VTK's own regression test. Where it
/// fails, the picture and the difference lie in the build tree's Testing/Temporary.
bool MatchesBaseline(vtkRenderWindow* window, const std::string& name);

/// Errors and warnings that VTK reports while `action` runs.
struct Messages
{
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
Messages Listen(const std::function<void()>& action);
} // namespace flatblock::testing
