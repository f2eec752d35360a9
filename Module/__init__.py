"""Volume rendering from flat blocks: vtkFlatBlockVolumeMapper for VTK."""

import vtkmodules.vtkRenderingOpenGL2  # its factories make the windows that the mapper draws in

from .vtkFlatBlockVolumeRendering import vtkFlatBlockVolumeMapper

__all__ = ["vtkFlatBlockVolumeMapper"]
