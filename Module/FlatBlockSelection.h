/// A pass of vtkHardwareSelector: the uniforms of Selection.glsl.
#pragma once

#include <array>
#include <optional>

class vtkHardwareSelector;
class vtkRenderer;
class vtkShaderProgram;

namespace flatblock
{
struct VolumeInput;

/// What a pass writes.
struct Selection
{
  enum class Pass
  {
    Prop,
    Low,
    High
  };
  Pass Bits = Pass::Prop;
  std::array<float, 3> PropColor = { 0.0F, 0.0F, 0.0F };
  std::array<float, 3> SampleToId = { 0.0F, 0.0F, 0.0F };
  std::array<int, 3> Ids = { 1, 1, 1 }; ///< of cells or points, an axis
};

/// Tells a selector, where there is one, that a prop is drawn: it knows its colour from then on.
class SelectorGuard
{
public:
  explicit SelectorGuard(vtkHardwareSelector* selector);
  ~SelectorGuard();
  SelectorGuard(const SelectorGuard&) = delete;
  void operator=(const SelectorGuard&) = delete;

private:
  vtkHardwareSelector* Selector;
};

/// Whether the renderer's selector has a pass that volumes take part in; tells it how many ids
/// there are.
std::optional<Selection> GetSelection(vtkRenderer* renderer, const VolumeInput& input);

void SetSelection(vtkShaderProgram* program, const Selection& selection);
} // namespace flatblock
