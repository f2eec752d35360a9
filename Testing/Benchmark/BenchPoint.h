/// One setting of one mapper.
#pragma once

#include "AccuracyScenes.h"

#include <functional>

namespace flatblock::benchmarks
{
/// A mapper that is made anew for each point, so that nothing has to be set back.
struct Setting
{
  Subject& Shown;
  vtkFlatBlockVolumeMapper* Mapper;
  vtkVolumeProperty* Property;
  vtkTypeInt64 BytesBeside;   ///< on the card, all but the atlas
  vtkTypeInt64 BytesOfVolume; ///< of its samples
  bool IsInteractive = false; ///< frames are
};

struct Point
{
  std::string Mapper; ///< class name
  std::string Knob;
  std::string Value;
  std::function<void(Setting&)> Apply;                                ///< of ours
  std::function<vtkSmartPointer<vtkVolumeMapper>(Subject&)> MakePeer; ///< of all others

  bool IsOurs() const { return !this->MakePeer; }
  std::string GetName() const { return this->Mapper + "/" + this->Knob + "=" + this->Value; }
};

/// All settings of ours; every second value of most knobs where `isQuick`.
std::vector<Point> ListOwnPoints(bool isQuick);
std::vector<Point> ListPeerPoints(bool isQuick);

/// Distance between samples so that the box's diagonal has so many.
inline double GetStepForSamples(Subject& subject, int samples)
{
  const auto* image = vtkImageData::SafeDownCast(subject.Shown.Mapper->GetInputDataObject(0, 0));
  return const_cast<vtkImageData*>(image)->GetLength() / samples;
}
} // namespace flatblock::benchmarks
