"""Volume rendering from flat blocks: vtkFlatBlockVolumeMapper for VTK, and readers of volume files."""

import vtkmodules.vtkRenderingOpenGL2  # its factories make the windows that the mapper draws in

from .vtkFlatBlockVolumeIO import vtkDF3Reader, vtkDF3Writer, vtkPVMReader, vtkPVMWriter
from .vtkFlatBlockVolumeRendering import vtkFlatBlockRayCastMapper, vtkFlatBlockVolumeMapper

__all__ = [
    "vtkDF3Reader",
    "vtkDF3Writer",
    "vtkFlatBlockRayCastMapper",
    "vtkFlatBlockVolumeMapper",
    "vtkPVMReader",
    "vtkPVMWriter",
]
