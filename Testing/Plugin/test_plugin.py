"""The plugin in ParaView: representation, property, picture.

pvpython test_plugin.py BASELINE OUTPUT
"""

import os
import sys

from paraview import simple
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

import flatblock  # lets Python see the mapper behind the representation
import session
from session import psnr, read

MRI = os.environ.get("FLATBLOCK_MRI", "/usr/share/mricron/templates/ch2better.nii.gz")
SKIP = 125


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


class Scene:
    """A view of the MRI and pictures of it."""

    def __init__(self, output):
        self.output = output
        self.view = session.make_view()
        self.source = simple.OpenDataFile(convert_mri(output))
        self.source.UpdatePipeline()
        self.array = self.source.PointData.GetArray(0).Name

    def color(self):
        colors = simple.GetColorTransferFunction(self.array)
        colors.RGBPoints = [30, 0.3, 0.1, 0.1, 80, 0.8, 0.6, 0.5, 130, 1.0, 1.0, 0.9]
        opacity = simple.GetOpacityTransferFunction(self.array)
        opacity.Points = [30, 0.0, 0.5, 0.0, 90, 0.3, 0.5, 0.0, 130, 0.8, 0.5, 0.0]

    def look(self):
        session.look(self.view, 150.0, 35.0, 1.4)

    def draw(self, name):
        return session.draw(self.view, os.path.join(self.output, "Plugin" + name + ".png"))


def main(baseline, output):
    if not os.path.exists(MRI):
        print("mricron-data is not installed", flush=True)
        session.end(SKIP)
    session.load_plugin()
    scene = Scene(output)
    display = simple.Show(scene.source, scene.view)
    types = display.GetProperty("Representation").Available
    assert "Flat-block Volume" in types, types

    # No array is chosen: the representation picks one, and shows it in gray.
    simple.ColorBy(display, None)
    display.SetRepresentationType("Flat-block Volume")
    assert display.FlatBlockSize == "33", display.FlatBlockSize
    scene.look()
    nothing_chosen = scene.draw("NothingChosen")
    assert nothing_chosen.std(axis=(0, 1)).min() > 10.0, "the picture is empty"
    assert abs(nothing_chosen.max(axis=(0, 1)) - nothing_chosen.max()).max() < 10.0, "not gray"

    simple.ColorBy(display, ("POINTS", scene.array))
    scene.color()
    display.ScalarOpacityUnitDistance = 1.0
    flat = scene.draw("Flat")
    difference = psnr(flat, read(baseline)) if os.path.exists(baseline) else 0.0
    print("to the baseline: %.1f dB" % difference)
    assert difference >= 45.0

    mapper = session.get_mapper(display)
    blocks = mapper.GetNumberOfBlocks()
    display.FlatBlockSize = 17
    small = scene.draw("Small")
    assert mapper.GetBlockSize() == 17
    assert mapper.GetNumberOfBlocks() > 4 * blocks, (blocks, mapper.GetNumberOfBlocks())
    assert psnr(flat, small) >= 55.0, psnr(flat, small)

    display.SetRepresentationType("Volume")
    stock = scene.draw("Stock")
    print("to the stock representation: %.1f dB" % psnr(flat, stock))
    assert psnr(flat, stock) >= 30.0

    display.SetRepresentationType("Flat-block Volume")
    assert psnr(small, scene.draw("Again")) >= 100.0

    display.Visibility = 0
    assert scene.draw("Hidden").std(axis=(0, 1)).max() < 1.0
    simple.Delete(scene.source)


if __name__ == "__main__":
    main(*sys.argv[1:])
    session.end()
