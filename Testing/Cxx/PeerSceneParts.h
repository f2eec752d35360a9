/// What scenes of VTK's tests are made of.
#pragma once

#include "Rendering.h"

#include "vtkGPUVolumeRayCastMapper.h"

#include <array>

namespace flatblock::testing
{
constexpr std::array<int, 3> PeerSamples = { 48, 44, 52 };

/// Does something to both mappers, which have it under one name.
template <typename Action>
void Both(Scene& scene, const Action& action)
{
  action(scene.Mapper.Get());
  action(vtkGPUVolumeRayCastMapper::SafeDownCast(scene.Peer));
}

/// Bytes that go up and down in all directions; tenfold where a type has room for them.
double ValueAt(int x, int y, int z);
vtkSmartPointer<vtkImageData> MakeImage(int type = VTK_UNSIGNED_CHAR);
/// What both mappers draw, the camera, and the functions of its values.
void SetImage(Scene& scene, vtkImageData* image, double step = 0.5);
void SetFunctions(Scene& scene, double opacity = 0.3, double scale = 1.0, double shift = 0.0);
void SetPlain(Scene& scene);
void Shade(Scene& scene);
/// What is cut off: by a plane in world coordinates; by two.
void AddPlane(vtkVolumeMapper* mapper, const std::array<double, 3>& origin,
  const std::array<double, 3>& normal);
void Clip(Scene& scene);
void SetGradientOpacity(Scene& scene);
} // namespace flatblock::testing
