/// OpenGL's errors, which nobody else may have asked for.
#pragma once

namespace flatblock
{
/// Forgets those that came before, so that the next one is our own. VTK's function of this kind
/// does nothing in a release build.
void ClearGLErrors();
} // namespace flatblock
