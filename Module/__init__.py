"""Volume rendering from flat blocks: vtkFlatBlockVolumeMapper for VTK."""

import vtkmodules.vtkRenderingOpenGL2  # its factories make the windows that the mapper draws in

from .vtkFlatBlockVolumeRendering import vtkFlatBlockRayCastMapper, vtkFlatBlockVolumeMapper

__all__ = ["vtkFlatBlockRayCastMapper", "vtkFlatBlockVolumeMapper"]
