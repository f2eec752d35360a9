#include "FlatBlockVolumeView.h"

#include "FlatBlockVolumeInput.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <cmath>

namespace flatblock
{
namespace
{
// A plane is a row: it goes from world to samples by the matrix from samples to world.
std::array<double, 4> ToSamples(const double plane[4], vtkMatrix4x4* sampleToWorld)
{
  std::array<double, 4> row = {};
  for (int column = 0; column < 4; ++column)
  {
    for (int i = 0; i < 4; ++i)
    {
      row[column] += plane[i] * sampleToWorld->GetElement(i, column);
    }
  }
  return row;
}

void AddViewPlanes(vtkRenderer* renderer, vtkMatrix4x4* sampleToWorld, ViewRegion& region)
{
  double planes[24];
  renderer->GetActiveCamera()->GetFrustumPlanes(renderer->GetTiledAspectRatio(), planes);
  for (int plane = 0; plane < 6; ++plane)
  {
    region.Planes.push_back(ToSamples(planes + 4 * plane, sampleToWorld));
  }
}

void AddClippingPlanes(vtkVolumeMapper* mapper, vtkMatrix4x4* sampleToWorld, ViewRegion& region)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    // A plane may have a transform: it is asked instead of taken apart.
    const double atOrigin = plane->FunctionValue(0.0, 0.0, 0.0);
    const double world[4] = { plane->FunctionValue(1.0, 0.0, 0.0) - atOrigin,
      plane->FunctionValue(0.0, 1.0, 0.0) - atOrigin,
      plane->FunctionValue(0.0, 0.0, 1.0) - atOrigin, atOrigin };
    region.Planes.push_back(ToSamples(world, sampleToWorld));
  }
}

CroppingRegions GetCropping(vtkVolumeMapper* mapper, vtkMatrix4x4* sampleToDataSet)
{
  CroppingRegions cropping;
  const double* planes = mapper->GetCroppingRegionPlanes();
  std::copy(planes, planes + 6, cropping.Planes.begin());
  cropping.Flags = mapper->GetCroppingRegionFlags();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      cropping.SampleToDataSet[row][column] = sampleToDataSet->GetElement(row, column);
    }
  }
  return cropping;
}
} // namespace

VolumeView GetVolumeView(vtkRenderer* renderer, vtkVolume* volume, vtkVolumeMapper* mapper,
  const VolumeInput& input, const double pointOfInterest[3])
{
  VolumeView view;
  vtkNew<vtkMatrix4x4> sampleToWorld;
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), input.SampleToDataSet, sampleToWorld);
  for (int axis = 0; axis < 3; ++axis)
  {
    view.Spacing[axis] = std::hypot(sampleToWorld->GetElement(0, axis),
      sampleToWorld->GetElement(1, axis), sampleToWorld->GetElement(2, axis));
  }
  vtkNew<vtkMatrix4x4> worldToSample;
  vtkMatrix4x4::Invert(sampleToWorld, worldToSample);
  const double world[4] = { pointOfInterest[0], pointOfInterest[1], pointOfInterest[2], 1.0 };
  double samples[4];
  worldToSample->MultiplyPoint(world, samples);
  std::copy(samples, samples + 3, view.PointOfInterest.begin());
  AddViewPlanes(renderer, sampleToWorld, view.Region);
  AddClippingPlanes(mapper, sampleToWorld, view.Region);
  if (mapper->GetCropping())
  {
    view.Region.Cropping = GetCropping(mapper, input.SampleToDataSet);
  }
  return view;
}
} // namespace flatblock
