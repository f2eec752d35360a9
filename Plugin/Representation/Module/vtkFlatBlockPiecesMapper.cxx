#include "vtkFlatBlockPiecesMapper.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkFlatBlockVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>

vtkStandardNewMacro(vtkFlatBlockPiecesMapper);
vtkFlatBlockPiecesMapper::vtkFlatBlockPiecesMapper() = default;
vtkFlatBlockPiecesMapper::~vtkFlatBlockPiecesMapper() = default;

namespace
{
using Box = std::array<double, 6>;

// The eye, or for parallel rays the direction to it, in the data's coordinates.
std::array<double, 4> GetEye(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  std::array<double, 4> eye = { 0.0, 0.0, 0.0, 1.0 };
  camera->GetPosition(eye.data());
  if (camera->GetParallelProjection() != 0)
  {
    camera->GetDirectionOfProjection(eye.data());
    eye = { -eye[0], -eye[1], -eye[2], 0.0 };
  }
  vtkNew<vtkMatrix4x4> toData;
  vtkMatrix4x4::Invert(volume->GetMatrix(), toData);
  toData->MultiplyPoint(eye.data(), eye.data());
  return eye;
}

// Whether a plane between two boxes has `far` on the other side than the eye.
bool IsBehind(const Box& far, const Box& near, const std::array<double, 4>& eye)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = near[2 * axis];
    const double high = near[2 * axis + 1];
    if ((far[2 * axis + 1] <= low && eye[axis] > low * eye[3]) ||
        (far[2 * axis] >= high && eye[axis] < high * eye[3]))
    {
      return true;
    }
  }
  return false;
}

// Of boxes that don't overlap, from the farthest to the nearest.
std::vector<std::size_t> SortFromFar(
  const std::vector<Box>& boxes, const std::array<double, 4>& eye)
{
  std::vector<std::size_t> rest(boxes.size());
  std::vector<std::size_t> sorted;
  for (std::size_t i = 0; i < rest.size(); ++i)
  {
    rest[i] = i;
  }
  while (!rest.empty())
  {
    const auto isFarthest = [&](std::size_t candidate)
    {
      return std::none_of(rest.begin(), rest.end(),
        [&](std::size_t other)
        {
          return other != candidate && IsBehind(boxes[other], boxes[candidate], eye) &&
                 !IsBehind(boxes[candidate], boxes[other], eye);
        });
    };
    auto next = std::find_if(rest.begin(), rest.end(), isFarthest);
    next = next == rest.end() ? rest.begin() : next; // they hide one another in a circle
    sorted.push_back(*next);
    rest.erase(next);
  }
  return sorted;
}
} // namespace

void vtkFlatBlockPiecesMapper::SetImages(const std::vector<vtkImageData*>& images)
{
  this->Mappers.resize(images.size());
  this->Images.resize(images.size());
  // One of them stands for all, or a volume would take this for empty.
  this->SetInputDataObject(0, images.empty() ? nullptr : images.front());
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    if (!this->Mappers[i])
    {
      this->Mappers[i] = vtkSmartPointer<vtkFlatBlockVolumeMapper>::New();
    }
    if (this->Images[i] != images[i])
    {
      this->Images[i] = images[i];
      this->Mappers[i]->SetInputData(images[i]);
      this->Modified();
    }
  }
}

void vtkFlatBlockPiecesMapper::CopySettings(vtkFlatBlockVolumeMapper* settings)
{
  double all = 0.0;
  for (vtkImageData* image : this->Images)
  {
    all += static_cast<double>(image->GetNumberOfPoints());
  }
  const auto memory = static_cast<double>(settings->GetMaxMemoryInBytes());
  for (std::size_t i = 0; i < this->Mappers.size(); ++i)
  {
    const auto own = static_cast<double>(this->Images[i]->GetNumberOfPoints());
    const vtkMTimeType before = this->Mappers[i]->GetMTime();
    const vtkTypeInt64 share =
      this->Mappers.size() == 1
        ? settings->GetMaxMemoryInBytes()
        : std::max<vtkTypeInt64>(1, static_cast<vtkTypeInt64>(memory * own / all));
    settings->SetMaxMemoryInBytes(share);
    this->Mappers[i]->ShallowCopy(settings);
    if (this->Mappers[i]->GetMTime() != before)
    {
      this->Modified();
    }
  }
  settings->SetMaxMemoryInBytes(static_cast<vtkTypeInt64>(memory));
}

double* vtkFlatBlockPiecesMapper::GetBounds()
{
  vtkBoundingBox box;
  for (vtkFlatBlockVolumeMapper* mapper : this->Mappers)
  {
    box.AddBounds(mapper->GetBounds());
  }
  vtkMath::UninitializeBounds(this->Bounds);
  box.GetBounds(this->Bounds);
  return this->Bounds;
}

void vtkFlatBlockPiecesMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  std::vector<Box> boxes(this->Mappers.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    this->Mappers[i]->GetBounds(boxes[i].data());
  }
  for (const std::size_t i : SortFromFar(boxes, GetEye(renderer, volume)))
  {
    this->Mappers[i]->Render(renderer, volume);
  }
}

void vtkFlatBlockPiecesMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkFlatBlockVolumeMapper* mapper : this->Mappers)
  {
    mapper->ReleaseGraphicsResources(window);
  }
}

void vtkFlatBlockPiecesMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (vtkFlatBlockVolumeMapper* mapper : this->Mappers)
  {
    os << indent << "Mapper:\n";
    mapper->PrintSelf(os, indent.GetNextIndent());
  }
}
