#include "PeerSceneParts.h"
#include "PeerScenes.h"

#include "Volumes.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flatblock::testing
{
namespace
{
double OtherValueAt(int x, int y, int z)
{
  return std::round(127.0 + 63.0 * (std::cos(0.13 * x + 1.0) + std::sin(0.2 * y - 0.1 * z)));
}

vtkSmartPointer<vtkImageData> MakeImageOfComponents(int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(PeerSamples.data());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int i = 0; i < components; ++i)
  {
    const auto one = MakeVolume(PeerSamples, VTK_UNSIGNED_CHAR,
      [i](int x, int y, int z)
      {
        return std::clamp(
          i % 2 ? OtherValueAt(x, y + 7 * i, z) : ValueAt(x + 9 * i, y, z), 0.0, 255.0);
      });
    image->GetPointData()->GetScalars()->CopyComponent(i, one->GetPointData()->GetScalars(), 0);
  }
  // So that the peer's tables of each component have its whole range.
  for (int i = 0; i < components; ++i)
  {
    image->SetScalarComponentFromDouble(0, 0, 0, i, 0.0);
    image->SetScalarComponentFromDouble(1, 0, 0, i, 255.0);
  }
  return image;
}

void SetComponents(Scene& scene, int components, bool areIndependent, bool isShaded)
{
  SetImage(scene, MakeImageOfComponents(components));
  SetFunctions(scene);
  scene.Property->SetIndependentComponents(areIndependent ? 1 : 0);
  for (int i = 0; i < components; ++i)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(130.0, 0.0);
    opacity->AddPoint(240.0, 0.2);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 0.1, 0.1, 0.1);
    color->AddRGBPoint(255.0, i % 2, i / 2 % 2, 1.0 - 0.3 * i);
    scene.Property->SetScalarOpacity(i, opacity);
    scene.Property->SetColor(i, color);
    scene.Property->SetComponentWeight(i, areIndependent ? 1.0 / components : 1.0);
    scene.Property->SetShade(i, isShaded ? 1 : 0);
    scene.Property->SetSpecular(i, 0.0);
  }
}

vtkSmartPointer<vtkImageData> MakeMask(bool isBinary)
{
  return MakeVolume(PeerSamples, VTK_UNSIGNED_CHAR,
    [isBinary](int x, int y, int z)
    {
      const int label = x > 30 ? 1 : (std::hypot(x - 16, y - 20, z - 26) < 14.0 ? 2 : 0);
      return isBinary ? (label ? 255 : 0) : label;
    });
}

void SetMask(Scene& scene, bool isBinary, double blendFactor, bool isShaded)
{
  SetImage(scene, MakeImage(), 1.0); // the length that the peer takes opacities of labels for
  SetFunctions(scene, 0.15);
  scene.Property->SetShade(isShaded ? 1 : 0);
  scene.Property->SetSpecular(0.0);
  for (int label = 1; label <= 2 && !isBinary; ++label)
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, label - 1, 0.9, 2 - label);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(100.0, 0.0);
    opacity->AddPoint(200.0, 0.1);
    scene.Property->SetLabelColor(label, color);
    scene.Property->SetLabelScalarOpacity(label, opacity);
  }
  const auto mask = MakeMask(isBinary);
  Both(scene,
    [&](auto* mapper)
    {
      mapper->SetMaskInput(mask);
      mapper->SetMaskType(isBinary ? 0 : 1);
      mapper->SetMaskBlendFactor(static_cast<float>(blendFactor));
    });
}

void SetCells(Scene& scene, bool isBlanked)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(PeerSamples[0] + 1, PeerSamples[1] + 1, PeerSamples[2] + 1);
  image->GetCellData()->SetScalars(MakeImage()->GetPointData()->GetScalars());
  if (isBlanked)
  {
    vtkUnsignedCharArray* ghosts = image->AllocateCellGhostArray();
    for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples() / 3; ++i)
    {
      ghosts->SetValue(i, vtkDataSetAttributes::HIDDENCELL);
    }
  }
  SetImage(scene, image);
  SetFunctions(scene);
}

void SetOrientation(Scene& scene)
{
  const auto image = MakeImage();
  image->SetDirectionMatrix(0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0);
  image->SetSpacing(1.0, 1.3, 0.8);
  image->SetOrigin(5.0, -3.0, 8.0);
  SetImage(scene, image);
  SetFunctions(scene);
}

void SetGhosts(Scene& scene)
{
  const auto image = MakeImage();
  vtkUnsignedCharArray* ghosts = image->AllocatePointGhostArray();
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples() / 3; ++i)
  {
    ghosts->SetValue(i, vtkDataSetAttributes::HIDDENPOINT);
  }
  SetImage(scene, image);
  SetFunctions(scene);
}
} // namespace

std::vector<PeerScene> GetPeerScenesOfData()
{
  return {
    { "CellData", 44.0, 0.99, [](Scene& s) { SetCells(s, false); }, "" },
    { "ChangedArray", 42.0, 0.99,
      [](Scene& s)
      {
        const auto image = MakeImage();
        const auto other = MakeVolume(PeerSamples, VTK_UNSIGNED_CHAR, OtherValueAt);
        other->GetPointData()->GetScalars()->SetName("other");
        image->GetPointData()->AddArray(other->GetPointData()->GetScalars());
        SetImage(s, image);
        SetFunctions(s);
        s.Draw();
        s.DrawWithPeer();
        Both(s,
          [](auto* m)
          {
            m->SelectScalarArray("other");
            m->SetScalarModeToUsePointFieldData();
          });
      },
      "" },
    { "CompositeBinaryMask", 45.0, 0.99, [](Scene& s) { SetMask(s, true, 1.0, false); }, "" },
    { "CompositeMask", 42.0, 0.98, [](Scene& s) { SetMask(s, false, 1.0, false); }, "" },
    { "CompositeMaskBlend", 42.0, 0.98, [](Scene& s) { SetMask(s, false, 0.5, false); }, "" },
    { "CompositeShadeMask", 43.0, 0.98, [](Scene& s) { SetMask(s, false, 1.0, true); }, "" },
    { "MIPBinaryMask", 34.0, 0.97,
      [](Scene& s)
      {
        SetMask(s, true, 1.0, false);
        SetFunctions(s, 0.9);
        Both(s, [](auto* m) { m->SetBlendModeToMaximumIntensity(); });
      },
      "" },
    { "FourComponentsMIP", 34.0, 0.96,
      [](Scene& s)
      {
        SetComponents(s, 4, true, false);
        Both(s, [](auto* m) { m->SetBlendMode(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND); });
      },
      "" },
    { "FourComponentsAverage", 34.0, 0.96,
      [](Scene& s)
      {
        SetComponents(s, 4, true, false);
        Both(s, [](auto* m) { m->SetBlendMode(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND); });
      },
      "" },
    { "FourComponentsAdditive", 34.0, 0.96,
      [](Scene& s)
      {
        SetComponents(s, 4, true, false);
        Both(s, [](auto* m) { m->SetBlendMode(vtkVolumeMapper::ADDITIVE_BLEND); });
      },
      "" },
    { "ThreeComponentsAdditive", 34.0, 0.96,
      [](Scene& s)
      {
        SetComponents(s, 3, true, false);
        Both(s, [](auto* m) { m->SetBlendMode(vtkVolumeMapper::ADDITIVE_BLEND); });
      },
      "" },
    { "LabelMap", 42.0, 0.98, [](Scene& s) { SetMask(s, false, 1.0, false); }, "" },
    { "DependentComponentsLightParameters", 44.0, 0.99,
      [](Scene& s) { SetComponents(s, 4, false, true); }, "" },
    { "FourComponentsComposite", 45.0, 0.99, [](Scene& s) { SetComponents(s, 4, true, false); },
      "" },
    { "FourComponentsDependentGradient", 45.0, 0.99,
      [](Scene& s)
      {
        SetComponents(s, 4, false, true);
        SetGradientOpacity(s);
      },
      "" },
    { "IndependentComponentsLightParameters", 44.0, 0.98,
      [](Scene& s) { SetComponents(s, 4, true, true); }, "" },
    { "ThreeComponentsIndependent", 47.0, 0.99, [](Scene& s) { SetComponents(s, 3, true, false); },
      "" },
    { "TwoComponentsDependent", 49.0, 0.99, [](Scene& s) { SetComponents(s, 2, false, false); },
      "" },
    { "TwoComponentsDependentGradient", 48.0, 0.99,
      [](Scene& s)
      {
        SetComponents(s, 2, false, false);
        SetGradientOpacity(s);
      },
      "" },
    { "TwoComponentsIndependent", 48.0, 0.99, [](Scene& s) { SetComponents(s, 2, true, false); },
      "" },
    { "OrientedVolume", 47.0, 0.99, SetOrientation, "" },
    { "VolumeOrientation", 47.0, 0.99, SetOrientation, "" },
    { "VolumeGhostArrays", 45.0, 0.99, SetGhosts, "" },
    { "VolumeGhostArraysCellData", 45.0, 0.99, [](Scene& s) { SetCells(s, true); }, "" },
    { "VolumeUpdate", 42.0, 0.99,
      [](Scene& s)
      {
        SetPlain(s);
        s.Draw();
        s.DrawWithPeer();
        const auto other = MakeVolume(PeerSamples, VTK_UNSIGNED_CHAR, OtherValueAt);
        Both(s, [&](auto* m) { m->SetInputData(other); });
      },
      "" },
    { "LargeColorTransferFunction", 39.0, 0.98,
      [](Scene& s)
      {
        SetImage(s, MakeImage(VTK_SHORT));
        SetFunctions(s, 0.3, 10.0);
        std::vector<std::array<double, 4>> points;
        for (int i = 0; i <= 400; ++i)
          points.push_back(
            { 6.0 * i, 0.5 + 0.5 * std::sin(0.1 * i), 0.5 + 0.5 * std::cos(0.13 * i), i / 400.0 });
        s.SetColor(points);
      },
      "" },
  };
}
} // namespace flatblock::testing
