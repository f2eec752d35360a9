"""The plugin in ParaView: representation, property, picture.

pvpython test_plugin.py PLUGIN BASELINE OUTPUT
"""

import os
import sys

from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkNIFTIImageReader, vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

import flatblock  # lets Python see the mapper behind the representation
import numpy

MRI = os.environ.get("FLATBLOCK_MRI", "/usr/share/mricron/templates/ch2better.nii.gz")
SKIP = 125


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(float)


def convert_mri(folder):
    """ParaView itself does not open NIfTI; its reader of appended data fails with some libexpats."""
    reader = vtkNIFTIImageReader()
    reader.SetFileName(MRI)
    writer = vtkXMLImageDataWriter()
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetDataModeToBinary()
    writer.SetFileName(os.path.join(folder, "mri.vti"))
    writer.Write()
    return writer.GetFileName()


def psnr(a, b):
    mean = numpy.mean((a - b) ** 2)
    return 200.0 if mean == 0.0 else 10.0 * numpy.log10(255.0**2 / mean)


class Session:
    """A view of the MRI and pictures of it."""

    def __init__(self, output):
        self.output = output
        self.view = simple.CreateRenderView()
        self.view.ViewSize = [256, 256]
        self.view.OrientationAxesVisibility = 0
        self.view.UseColorPaletteForBackground = 0
        self.view.Background = [0.2, 0.3, 0.4]
        self.source = simple.OpenDataFile(convert_mri(output))
        self.source.UpdatePipeline()
        self.array = self.source.PointData.GetArray(0).Name

    def color(self):
        colors = simple.GetColorTransferFunction(self.array)
        colors.RGBPoints = [30, 0.3, 0.1, 0.1, 80, 0.8, 0.6, 0.5, 130, 1.0, 1.0, 0.9]
        opacity = simple.GetOpacityTransferFunction(self.array)
        opacity.Points = [30, 0.0, 0.5, 0.0, 90, 0.3, 0.5, 0.0, 130, 0.8, 0.5, 0.0]

    def look(self):
        self.view.ResetCamera()
        camera = self.view.GetActiveCamera()
        camera.Azimuth(150)
        camera.Elevation(35)
        camera.OrthogonalizeViewUp()
        camera.Zoom(1.4)

    def draw(self, name):
        file = os.path.join(self.output, "Plugin" + name + ".png")
        simple.SaveScreenshot(file, self.view, ImageResolution=[256, 256])
        return read(file)


def main(plugin, baseline, output):
    if not os.path.exists(MRI):
        print("mricron-data is not installed", flush=True)
        os._exit(SKIP)  # sys.exit() in pvpython crashes ParaView
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    session = Session(output)
    display = simple.Show(session.source, session.view)
    types = display.GetProperty("Representation").Available
    assert "Flat-block Volume" in types, types

    # No array is chosen: the representation picks one, and shows it in gray.
    simple.ColorBy(display, None)
    display.SetRepresentationType("Flat-block Volume")
    assert display.FlatBlockSize == "33", display.FlatBlockSize
    session.look()
    nothing_chosen = session.draw("NothingChosen")
    assert nothing_chosen.std(axis=0).min() > 10.0, "the picture is empty"
    assert abs(nothing_chosen.max(axis=0) - nothing_chosen.max()).max() < 10.0, "not gray"

    simple.ColorBy(display, ("POINTS", session.array))
    session.color()
    display.ScalarOpacityUnitDistance = 1.0
    flat = session.draw("Flat")
    difference = psnr(flat, read(baseline)) if os.path.exists(baseline) else 0.0
    print("to the baseline: %.1f dB" % difference)
    assert difference >= 45.0

    mapper = display.GetClientSideObject().GetActiveRepresentation().GetActor().GetMapper()
    blocks = mapper.GetNumberOfBlocks()
    display.FlatBlockSize = 17
    small = session.draw("Small")
    assert mapper.GetBlockSize() == 17
    assert mapper.GetNumberOfBlocks() > 4 * blocks, (blocks, mapper.GetNumberOfBlocks())
    assert psnr(flat, small) >= 55.0, psnr(flat, small)

    display.SetRepresentationType("Volume")
    stock = session.draw("Stock")
    print("to the stock representation: %.1f dB" % psnr(flat, stock))
    assert psnr(flat, stock) >= 30.0

    display.SetRepresentationType("Flat-block Volume")
    assert psnr(small, session.draw("Again")) >= 100.0

    display.Visibility = 0
    assert session.draw("Hidden").std(axis=0).max() < 1.0
    simple.Delete(session.source)


if __name__ == "__main__":
    main(*sys.argv[1:])
