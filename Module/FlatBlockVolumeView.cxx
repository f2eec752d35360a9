#include "FlatBlockVolumeView.h"

#include "FlatBlockRayGeometry.h"
#include "FlatBlockVolumeInput.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

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
    region.Frustum.push_back(ToSamples(planes + 4 * plane, sampleToWorld));
  }
}

// A plane may have a transform: it is asked instead of taken apart.
std::array<double, 4> PlaneToSamples(vtkImplicitFunction* plane, vtkMatrix4x4* sampleToWorld)
{
  const double atOrigin = plane->FunctionValue(0.0, 0.0, 0.0);
  const double world[4] = { plane->FunctionValue(1.0, 0.0, 0.0) - atOrigin,
    plane->FunctionValue(0.0, 1.0, 0.0) - atOrigin, plane->FunctionValue(0.0, 0.0, 1.0) - atOrigin,
    atOrigin };
  return ToSamples(world, sampleToWorld);
}

Planes GetClippingPlanes(vtkVolumeMapper* mapper, vtkMatrix4x4* sampleToWorld)
{
  Planes inSamples;
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    inSamples.push_back(PlaneToSamples(planes->GetItem(i), sampleToWorld));
  }
  return inSamples;
}

// Half of the values around a volume of cells lie beyond it.
void AddFacesOfCells(vtkImageData* image, Planes& planes)
{
  const int* points = image->GetDimensions();
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<double, 4> plane = { 0.0, 0.0, 0.0, -0.5 };
    plane[axis] = 1.0;
    planes.push_back(plane);
    plane[axis] = -1.0;
    plane[3] = points[axis] - 0.5;
    planes.push_back(plane);
  }
}

// A point where w is 1, a direction where it is 0.
std::array<double, 3> Transform(vtkMatrix4x4* matrix, const double vector[3], double w)
{
  const double from[4] = { vector[0], vector[1], vector[2], w };
  double to[4];
  matrix->MultiplyPoint(from, to);
  return { to[0], to[1], to[2] };
}

std::array<double, 4> GetNearPlane(vtkCamera* camera)
{
  const double* position = camera->GetPosition();
  const double* sight = camera->GetDirectionOfProjection();
  double at = camera->GetClippingRange()[0];
  for (int axis = 0; axis < 3; ++axis)
  {
    at += position[axis] * sight[axis];
  }
  return { sight[0], sight[1], sight[2], -at };
}

bool IsPlain(vtkCamera* camera)
{
  const double* shear = camera->GetViewShear();
  return !camera->GetUseOffAxisProjection() && shear[0] == 0.0 && shear[1] == 0.0;
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

Clipping GetClipping(vtkVolume* volume, vtkVolumeMapper* mapper, const VolumeInput& input)
{
  vtkNew<vtkMatrix4x4> sampleToWorld;
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), input.SampleToDataSet, sampleToWorld);
  Clipping clipping;
  clipping.Planes = GetClippingPlanes(mapper, sampleToWorld);
  if (input.IsCellData)
  {
    AddFacesOfCells(input.Image, clipping.Planes);
  }
  if (mapper->GetCropping())
  {
    clipping.Cropping = GetCropping(mapper, input.SampleToDataSet);
  }
  vtkImplicitFunction* slice = volume->GetProperty()->GetSliceFunction();
  if (mapper->GetBlendMode() == vtkVolumeMapper::SLICE_BLEND && slice)
  {
    clipping.Slice = PlaneToSamples(slice, sampleToWorld);
  }
  return clipping;
}

VolumeView GetVolumeView(vtkRenderer* renderer, vtkVolume* volume, vtkVolumeMapper* mapper,
  const VolumeInput& input, const double pointOfInterest[3])
{
  VolumeView view;
  vtkNew<vtkMatrix4x4> sampleToWorld;
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), input.SampleToDataSet, sampleToWorld);
  view.Spacing = GetSpacing(sampleToWorld);
  view.DataSetSpacing = GetSpacing(input.SampleToDataSet);
  vtkNew<vtkMatrix4x4> worldToSample;
  vtkMatrix4x4::Invert(sampleToWorld, worldToSample);
  vtkCamera* camera = renderer->GetActiveCamera();
  view.PointOfInterest = Transform(worldToSample, pointOfInterest, 1.0);
  view.Camera.IsParallel = camera->GetParallelProjection() != 0;
  view.Camera.Eye = Transform(worldToSample, camera->GetPosition(), 1.0);
  view.Camera.Sight = Transform(worldToSample, camera->GetDirectionOfProjection(), 0.0);
  view.Camera.NearPlane = ToSamples(GetNearPlane(camera).data(), sampleToWorld);
  view.HasPlainCamera = IsPlain(camera) && !renderer->GetRenderWindow()->GetStereoRender();
  AddViewPlanes(renderer, sampleToWorld, view.Region);
  view.Region.Clipping = GetClipping(volume, mapper, input);
  return view;
}
} // namespace flatblock
