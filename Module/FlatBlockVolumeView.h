/// What is seen of a volume, and from where, in the terms of its samples.
#pragma once

#include "BlockVisibility.h"
#include "ViewRegion.h"

#include <array>

class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;

namespace flatblock
{
struct VolumeInput;

struct VolumeView
{
  std::array<double, 3> PointOfInterest = {}; ///< in samples
  std::array<double, 3> Spacing = {};         ///< world units of a sample's spacing
  std::array<double, 3> DataSetSpacing = {};  ///< the same in the data set's unit of length
  ViewRegion Region;
  Viewpoint Camera;
  bool HasPlainCamera = true; ///< rays come from where the camera says that it is
};

/// By the mapper's clipping planes and cropping.
Clipping GetClipping(vtkVolume* volume, vtkVolumeMapper* mapper, const VolumeInput& input);

/// From the renderer's camera, and the mapper's clipping planes and cropping.
///
/// @param pointOfInterest  world coordinates
VolumeView GetVolumeView(vtkRenderer* renderer, vtkVolume* volume, vtkVolumeMapper* mapper,
  const VolumeInput& input, const double pointOfInterest[3]);
} // namespace flatblock
