/// What a window showed before the frame that it is drawing.
#pragma once

class vtkRenderer;

namespace flatblock
{
/// Gives up a frame: no other props are drawn, and within the renderer's viewport the window goes
/// on to show its former picture, be it on screen or not.
///
/// @param hasPicture  that the window, of its present size, has shown
void ShowFormerPicture(vtkRenderer* renderer, bool hasPicture);
} // namespace flatblock
