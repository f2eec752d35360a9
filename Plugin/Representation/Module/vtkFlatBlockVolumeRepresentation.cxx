#include "vtkFlatBlockVolumeRepresentation.h"

#include "FlatBlockPieces.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFlatBlockPiecesMapper.h"
#include "vtkFlatBlockStatus.h"
#include "vtkFlatBlockVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>

vtkStandardNewMacro(vtkFlatBlockVolumeRepresentation);

namespace
{
const char* const OwnBounds = "FlatBlockOwnBounds"; // of the cells that are no ghosts

// The images of what is delivered to this process, which RequestData() has made ready.
std::vector<vtkImageData*> GetDelivered(vtkDataObject* data)
{
  std::vector<vtkImageData*> images;
  auto* partitions = vtkPartitionedDataSet::SafeDownCast(data);
  for (unsigned int i = 0; partitions && i < partitions->GetNumberOfPartitions(); ++i)
  {
    images.push_back(vtkImageData::SafeDownCast(partitions->GetPartition(i)));
  }
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    images.push_back(image);
  }
  return images;
}

vtkDataArray* FindArray(const std::vector<vtkImageData*>& images)
{
  if (images.empty())
  {
    return nullptr;
  }
  vtkPointData* arrays = images.front()->GetPointData();
  return arrays->GetScalars() ? arrays->GetScalars() : arrays->GetArray(0);
}

// From transparent black to opaque white over the array's range.
void ShowInGray(vtkDataArray* array, vtkVolumeProperty* property)
{
  double range[2];
  array->GetFiniteRange(range);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(range[0], 0.0, 0.0, 0.0);
  color->AddRGBPoint(range[1], 1.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(range[0], 0.0);
  opacity->AddPoint(range[1], 1.0);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
}

void Apply(int quality, vtkFlatBlockVolumeMapper* mapper)
{
  switch (quality)
  {
  case vtkFlatBlockVolumeRepresentation::INTERACTIVE:
    return mapper->SetQualityToInteractive();
  case vtkFlatBlockVolumeRepresentation::BALANCED:
    return mapper->SetQualityToBalanced();
  case vtkFlatBlockVolumeRepresentation::ACCURATE:
    return mapper->SetQualityToAccurate();
  case vtkFlatBlockVolumeRepresentation::REFERENCE:
    return mapper->SetQualityToReference();
  case vtkFlatBlockVolumeRepresentation::AUTOMATIC:
    return mapper->SetQualityToAutomatic();
  default:
    return;
  }
}

// The view says it to its subclasses alone.
class ScreenshotView : public vtkPVRenderView
{
public:
  static bool IsCapturing(vtkPVRenderView* view)
  {
    return (view->*&ScreenshotView::GetInCaptureScreenshot)();
  }
};
} // namespace

vtkFlatBlockVolumeRepresentation::vtkFlatBlockVolumeRepresentation()
{
  this->VolumeMapper = vtkSmartPointer<vtkFlatBlockVolumeMapper>::New();
}

vtkFlatBlockVolumeRepresentation::~vtkFlatBlockVolumeRepresentation() = default;

void vtkFlatBlockVolumeRepresentation::SetSettings(vtkFlatBlockVolumeMapper* settings)
{
  if (settings && this->VolumeMapper != settings)
  {
    this->VolumeMapper = settings;
    this->MarkModified();
  }
}

vtkFlatBlockVolumeMapper* vtkFlatBlockVolumeRepresentation::GetSettings() const
{
  return static_cast<vtkFlatBlockVolumeMapper*>(this->VolumeMapper.Get());
}

void vtkFlatBlockVolumeRepresentation::SetCurvatureColor(vtkColorTransferFunction* color)
{
  this->CurvatureColor = color;
}

void vtkFlatBlockVolumeRepresentation::SetCurvatureOpacity(vtkPiecewiseFunction* opacity)
{
  this->CurvatureOpacity = opacity;
}

vtkFlatBlockVolumeMapper* vtkFlatBlockVolumeRepresentation::GetMapper(int piece)
{
  const auto& mappers = this->Pieces->GetMappers();
  return piece >= 0 && piece < static_cast<int>(mappers.size()) ? mappers[piece].Get() : nullptr;
}

int vtkFlatBlockVolumeRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

// Of several ranks each draws its own cells, but gradients and splines reach for those around.
int vtkFlatBlockVolumeRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int isDone = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  constexpr int Around = 2;
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = inputs[0]->GetInformationObject(i);
    if (info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
    {
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), Around);
    }
  }
  return isDone;
}

// The stock representation crops ghosts off; here they stay, and are cut off where rays are drawn.
void vtkFlatBlockVolumeRepresentation::KeepGhosts(vtkImageData* image)
{
  auto* own = vtkImageData::SafeDownCast(this->Cache);
  if (!image || !own || !image->HasAnyGhostCells() || this->UseSeparateOpacityArray ||
      !image->GetDirectionMatrix()->IsIdentity())
  {
    return;
  }
  vtkNew<vtkDoubleArray> bounds;
  bounds->SetName(OwnBounds);
  bounds->SetNumberOfComponents(6);
  bounds->InsertNextTuple(own->GetBounds());
  vtkNew<vtkImageData> whole;
  whole->ShallowCopy(image);
  flatblock::ForgetDuplicates(whole);
  whole->GetFieldData()->AddArray(bounds);
  this->Cache = whole;
}

// The stock representation takes one image: what is made of several goes to it as its input, or
// past it.
int vtkFlatBlockVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* data = inputs[0]->GetNumberOfInformationObjects() == 1
                 ? vtkCompositeDataSet::GetData(inputs[0], 0)
                 : nullptr;
  if (!data)
  {
    const int isDone = this->Superclass::RequestData(request, inputs, outputs);
    this->KeepGhosts(vtkImageData::GetData(inputs[0], 0));
    return isDone;
  }
  const auto images = flatblock::GetImages(data);
  if (const auto merged = flatblock::MergeImages(images))
  {
    vtkNew<vtkInformation> info;
    info->Copy(inputs[0]->GetInformationObject(0));
    info->Set(vtkDataObject::DATA_OBJECT(), merged);
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), merged->GetExtent(), 6);
    vtkNew<vtkInformationVector> input;
    input->Append(info);
    vtkInformationVector* one[] = { input };
    return this->Superclass::RequestData(request, one, outputs);
  }
  vtkNew<vtkPartitionedDataSet> pieces;
  this->DataSize = 0;
  for (unsigned int i = 0; i < images.size(); ++i)
  {
    pieces->SetPartition(i, images[i]);
    this->DataSize += images[i]->GetActualMemorySize();
  }
  pieces->GetBounds(this->DataBounds);
  this->Actor->SetEnableLOD(0);
  this->OutlineSource->SetBounds(this->DataBounds);
  this->OutlineSource->Update();
  this->Cache = pieces;
  // NOLINTNEXTLINE(bugprone-parent-virtual-call): the one in between takes one image.
  return this->vtkVolumeRepresentation::RequestData(request, inputs, outputs);
}

bool vtkFlatBlockVolumeRepresentation::AddToView(vtkView* view)
{
  this->View = vtkPVRenderView::SafeDownCast(view);
  return this->Superclass::AddToView(view);
}

bool vtkFlatBlockVolumeRepresentation::RemoveFromView(vtkView* view)
{
  this->ReleaseMemory();
  this->View = nullptr;
  return this->Superclass::RemoveFromView(view);
}

void vtkFlatBlockVolumeRepresentation::SetVisibility(bool isVisible)
{
  this->Superclass::SetVisibility(isVisible);
  if (!isVisible)
  {
    this->ReleaseMemory();
  }
}

void vtkFlatBlockVolumeRepresentation::ReleaseMemory()
{
  if (this->View && this->View->GetRenderWindow())
  {
    this->Pieces->ReleaseGraphicsResources(this->View->GetRenderWindow());
  }
}

void vtkFlatBlockVolumeRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  this->Pieces->SetImages(GetDelivered(this->VolumeMapper->GetInputDataObject(0, 0)));
  this->ShowChosenArray();
  this->ChooseComponent();
  this->UpdateWanted();
  this->Pieces->CopySettings(this->Wanted);
  this->Actor->SetMapper(this->Pieces->GetMappers().size() == 1
                           ? static_cast<vtkVolumeMapper*>(this->Pieces->GetMappers().front())
                           : this->Pieces.Get());
}

void vtkFlatBlockVolumeRepresentation::ShowChosenArray()
{
  vtkInformation* chosen = this->GetInputArrayInformation(0);
  const char* name =
    chosen->Has(vtkDataObject::FIELD_NAME()) ? chosen->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  vtkDataArray* found =
    name && *name ? nullptr : FindArray(GetDelivered(this->VolumeMapper->GetInputDataObject(0, 0)));
  if (!found)
  {
    this->Actor->SetProperty(this->Property);
    return;
  }
  if (found != this->ShownInGray || found->GetMTime() > this->GrayProperty->GetMTime())
  {
    ShowInGray(found, this->GrayProperty);
    this->ShownInGray = found;
  }
  this->GrayProperty->SetScalarOpacityUnitDistance(this->Property->GetScalarOpacityUnitDistance());
  this->GrayProperty->SetInterpolationType(this->Property->GetInterpolationType());
  this->Actor->SetProperty(this->GrayProperty);
  this->VolumeMapper->SelectScalarArray(found->GetName());
  this->VolumeMapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  this->Actor->SetVisibility(true);
}

// As the stock representation tells its mapper.
void vtkFlatBlockVolumeRepresentation::ChooseComponent()
{
  vtkFlatBlockVolumeMapper* settings = this->GetSettings();
  if (this->UseTransfer2D)
  {
    const bool hasArray = !this->UseGradientForTransfer2D && !this->ColorArray2Name.empty();
    settings->SetTransfer2DYAxisArray(hasArray ? this->ColorArray2Name.c_str() : nullptr);
    return;
  }
  settings->SetTransfer2DYAxisArray(nullptr);
  vtkColorTransferFunction* color = this->Property->GetRGBTransferFunction();
  const bool isIndependent = this->Property->GetIndependentComponents() != 0;
  settings->SetVectorMode(isIndependent && this->Actor->GetProperty() == this->Property
                            ? color->GetVectorMode()
                            : vtkFlatBlockVolumeMapper::DISABLED);
  settings->SetVectorComponent(color->GetVectorComponent());
}

void vtkFlatBlockVolumeRepresentation::UpdateWanted()
{
  this->Wanted->ShallowCopy(this->VolumeMapper);
  Apply(this->Quality, this->Wanted);
  this->Wanted->SetMaxMemoryInBytes(vtkTypeInt64(this->MemoryLimit) << 20);
  this->Wanted->SetCurvatureColor(this->UseCurvatureColor ? this->CurvatureColor.Get() : nullptr);
  this->Wanted->SetCurvatureOpacity(
    this->UseCurvatureOpacity ? this->CurvatureOpacity.Get() : nullptr);
  this->CutGhostsOff();
  if (this->Projection > 0)
  {
    this->Wanted->SetBlendMode(this->Projection);
  }
  auto* controller = vtkMultiProcessController::GetGlobalController();
  const bool isAlone = !controller || controller->GetNumberOfProcesses() == 1;
  this->Wanted->SetProgressiveStills(
    this->Progressive && isAlone && this->View && !ScreenshotView::IsCapturing(this->View));
}

void vtkFlatBlockVolumeRepresentation::CutGhostsOff()
{
  auto* image = vtkImageData::SafeDownCast(this->VolumeMapper->GetInputDataObject(0, 0));
  vtkDataArray* own = image ? image->GetFieldData()->GetArray(OwnBounds) : nullptr;
  if (!own)
  {
    return;
  }
  std::array<double, 6> planes;
  own->GetTuple(0, planes.data());
  for (int axis = 0; axis < 3 && this->Wanted->GetCropping() != 0; ++axis)
  {
    const double* cropped = this->Wanted->GetCroppingRegionPlanes();
    planes[2 * axis] = std::max(planes[2 * axis], cropped[2 * axis]);
    planes[2 * axis + 1] = std::min(planes[2 * axis + 1], cropped[2 * axis + 1]);
  }
  this->Wanted->SetCropping(1);
  this->Wanted->SetCroppingRegionPlanes(planes.data());
}

void vtkFlatBlockVolumeRepresentation::SetStatus(vtkFlatBlockStatus* status)
{
  if (status)
  {
    status->SetPieces(this->Pieces);
  }
}

void vtkFlatBlockVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "Projection: " << this->Projection << "\n";
  os << indent << "UseCurvatureColor: " << this->UseCurvatureColor << "\n";
  os << indent << "UseCurvatureOpacity: " << this->UseCurvatureOpacity << "\n";
  os << indent << "Progressive: " << this->Progressive << "\n";
  this->Pieces->PrintSelf(os, indent.GetNextIndent());
}
