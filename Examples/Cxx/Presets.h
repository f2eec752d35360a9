/// Transfer functions for common kinds of volumes.
#pragma once

#include <string>
#include <vector>

class vtkImageData;
class vtkVolumeProperty;

/// mri, ct-bone, ct-skin, angio, grey.
const std::vector<std::string>& GetPresetNames();

/// Sets colour, opacity and the opacity's unit distance. The CT presets are in Hounsfield units;
/// the others follow percentiles of the samples above the background, as does the one without a
/// name.
void ApplyPreset(const std::string& name, vtkImageData* image, vtkVolumeProperty* property);
