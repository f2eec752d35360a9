"""Seconds a frame against vtkGPUVolumeRayCastMapper, in one run: frame_times.py [FILE.nii.gz]

Both mappers draw the same volume, 512 x 512 pixels, unshaded, with steps of half a voxel; the
frames of the two alternate, and the medians of 15 are compared.
"""

import statistics
import sys
import time

import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from flatblock import vtkFlatBlockVolumeMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkVolumeProperty,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

FRAMES = 15
DEFAULT = "/usr/share/mricron/templates/ch2better.nii.gz"


def make_property():
    color = vtkColorTransferFunction()
    color.AddRGBPoint(30, 0.3, 0.1, 0.1)
    color.AddRGBPoint(80, 0.8, 0.6, 0.5)
    color.AddRGBPoint(130, 1.0, 1.0, 0.9)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(30, 0.0)
    opacity.AddPoint(90, 0.3)
    opacity.AddPoint(130, 0.8)
    prop = vtkVolumeProperty()
    prop.SetColor(color)
    prop.SetScalarOpacity(opacity)
    prop.SetInterpolationTypeToLinear()
    return prop


class Window:
    def __init__(self, mapper, reader, step):
        mapper.SetInputConnection(reader.GetOutputPort())
        mapper.SetSampleDistance(step)
        volume = vtkVolume()
        volume.SetMapper(mapper)
        volume.SetProperty(make_property())
        self.renderer = vtkRenderer()
        self.renderer.AddVolume(volume)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(512, 512)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.Azimuth(150)
        camera.Elevation(35)
        self.renderer.ResetCamera()
        camera.Zoom(1.4)

    def seconds(self):
        start = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        return time.perf_counter() - start


reader = vtkNIFTIImageReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else DEFAULT)
reader.Update()
step = 0.5 * min(reader.GetOutput().GetSpacing())
peer = vtkGPUVolumeRayCastMapper()
peer.SetAutoAdjustSampleDistances(0)
windows = {
    "vtkFlatBlockVolumeMapper": Window(vtkFlatBlockVolumeMapper(), reader, step),
    "vtkGPUVolumeRayCastMapper": Window(peer, reader, step),
}
first = {name: window.seconds() for name, window in windows.items()}
frames = {name: [] for name in windows}
for _ in range(FRAMES):
    for name, window in windows.items():
        frames[name].append(window.seconds())
medians = [statistics.median(frames[name]) for name in windows]
for name, median in zip(windows, medians):
    print("%-28s first frame %.3f s, median frame %.3f s" % (name, first[name], median))
print("ratio %.2f" % (medians[0] / medians[1]))
