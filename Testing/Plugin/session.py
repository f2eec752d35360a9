"""What the tests of the plugin share: the plugin, a view, data, pictures as numbers.

FLATBLOCK_PLUGIN names the plugin's file.
"""

import os

from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import numpy

REPRESENTATION = "Flat-block Volume"


def load_plugin(remote=False):
    simple.LoadPlugin(os.environ["FLATBLOCK_PLUGIN"], remote=remote, ns=globals())


def make_view(size=256):
    view = simple.CreateRenderView()
    view.ViewSize = [size, size]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.2, 0.3, 0.4]
    view.UseFXAA = 0  # it finds other edges where a pixel differs by a step
    return view


def look(view, azimuth=30.0, elevation=40.0, zoom=1.3):
    simple.ResetCamera(view)
    camera = view.GetActiveCamera()
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    camera.OrthogonalizeViewUp()
    camera.Zoom(zoom)


def make_wavelet(half=30):
    wavelet = simple.Wavelet(WholeExtent=[-half, half] * 3)
    wavelet.UpdatePipeline()
    return wavelet


def show(source, view, array="RTData", shade=1):
    """In colors and opacity over the range of the wavelet."""
    display = simple.Show(source, view)
    simple.ColorBy(display, ("POINTS", array))
    simple.GetColorTransferFunction(array).RescaleTransferFunction(37.0, 277.0)
    simple.GetOpacityTransferFunction(array).RescaleTransferFunction(37.0, 277.0)
    display.SetRepresentationType(REPRESENTATION)
    display.ScalarOpacityUnitDistance = 4.0
    display.Shade = shade
    return display


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())[:, :3]
    return pixels.reshape(height, width, 3).astype(float)


def draw(view, file, size=256):
    simple.SaveScreenshot(file, view, ImageResolution=[size, size])
    return read(file)


def difference(a, b):
    return abs(a - b).max()


def psnr(a, b):
    mean = numpy.mean((a - b) ** 2)
    return 200.0 if mean == 0.0 else 10.0 * numpy.log10(255.0**2 / mean)


def get_mapper(display):
    """What draws, for Python that has imported flatblock."""
    return display.GetClientSideObject().GetActiveRepresentation().GetActor().GetMapper()


def get_status(display):
    display.UpdatePropertyInformation()
    return display.GetProperty("FlatBlockStatus")[0]


def end(code=0):
    """sys.exit() in pvpython crashes ParaView."""
    os.sys.stdout.flush()
    os._exit(code)
