/// Pictures of floats, and what the reference ray caster says they should be.
#pragma once

#include "Metrics.h"
#include "ReferenceRayCaster.h"
#include "Rendering.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

namespace flatblock::testing
{
/// A framebuffer of 32-bit floats, RGBA, with a depth buffer, in a window's context. Everything
/// that is drawn while it exists goes to it.
class FloatFramebuffer
{
public:
  FloatFramebuffer(vtkRenderWindow* window, int width, int height);
  ~FloatFramebuffer();
  FloatFramebuffer(const FloatFramebuffer&) = delete;
  void operator=(const FloatFramebuffer&) = delete;

  /// x fastest, from the lower left.
  Picture Read();

private:
  int Width;
  int Height;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
};

/// The scene's volume alone, over nothing: premultiplied colour, and opacity.
Picture DrawFloats(Scene& scene);

/// What the scene shows, and from where, in the reference's terms.
ReferenceVolume ReadReferenceVolume(Scene& scene);
ReferenceView GetReferenceView(Scene& scene);

/// The same by the reference, every `stride`-th pixel of every `stride`-th row. Where the property
/// shades that is trilinear, by a headlight.
Picture DrawReference(
  Scene& scene, int stride = 1, ReferenceFilter filter = ReferenceFilter::Trilinear);

/// Those pixels of a picture of so many pixels a row.
Picture TakeEvery(const Picture& picture, int width, int stride);

/// Whether all numbers of a picture are finite, and its colours and opacities within [0, 1] but for
/// rounding.
bool IsSound(const Picture& picture);
} // namespace flatblock::testing
