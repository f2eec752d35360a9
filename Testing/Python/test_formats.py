"""FlatBlockView reads each format: test_formats.py FLATBLOCKVIEW DATA_FOLDER"""

import os
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkImagingCore import vtkImageCast, vtkRTAnalyticSource
from vtkmodules.vtkImagingSources import vtkImageNoiseSource
from vtkmodules.vtkIOImage import (
    vtkMetaImageWriter, vtkNIFTIImageWriter, vtkPNGWriter, vtkTIFFWriter)
from vtkmodules.vtkIOLegacy import vtkStructuredPointsWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.util.numpy_support import vtk_to_numpy

VIEW, DATA = sys.argv[1:3]


def make_volume():
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(0, 19, 0, 23, 0, 27)
    source.Update()
    volume = source.GetOutput()
    volume.SetExtent(0, 19, 0, 23, 0, 27)
    return volume


class FormatsTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.volume = make_volume()

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def draw(self, file, dimensions="20 x 24 x 28", scalars="float", *options):
        picture = self.path("picture.png")
        command = [VIEW, file, "--output", picture, "--size", "64", "64", *options]
        done = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = dict(line.split(None, 1) for line in done.stdout.splitlines() if " " in line)
        self.assertEqual(rows["dimensions"].strip(), dimensions)
        self.assertIn("type" + " " * 13 + scalars, done.stdout)
        self.assertGreater(os.path.getsize(picture), 500)

    def write(self, writer, name):
        writer.SetInputData(self.volume)
        writer.SetFileName(self.path(name))
        writer.Write()
        return self.path(name)

    def test_vti(self):
        for mode in ("Appended", "Binary", "Ascii"):
            writer = vtkXMLImageDataWriter()
            getattr(writer, "SetDataModeTo" + mode)()
            self.draw(self.write(writer, mode + ".vti"))

    def test_vtk(self):
        self.draw(self.write(vtkStructuredPointsWriter(), "volume.vtk"))

    def test_mha_and_mhd(self):
        self.draw(self.write(vtkMetaImageWriter(), "volume.mha"))
        writer = vtkMetaImageWriter()
        writer.SetRAWFileName(self.path("volume.zraw"))
        self.draw(self.write(writer, "volume.mhd"))

    def test_nifti(self):
        self.draw(self.write(vtkNIFTIImageWriter(), "volume.nii"))
        self.draw(self.write(vtkNIFTIImageWriter(), "volume.nii.gz"))

    def test_stacks_of_images(self):
        for writer, ending in ((vtkPNGWriter(), "png"), (vtkTIFFWriter(), "tif")):
            cast = vtkImageCast()
            cast.SetOutputScalarTypeToUnsignedChar()
            cast.SetInputData(self.volume)
            os.mkdir(self.path(ending))
            writer.SetInputConnection(cast.GetOutputPort())
            writer.SetFilePrefix(os.path.join(self.path(ending), "slice"))
            writer.SetFilePattern("%s_%03d." + ending)
            writer.Write()
            self.draw(self.path(ending), "20 x 24 x 28", "unsigned char")

    def test_images_of_other_sizes_are_refused(self):
        os.mkdir(self.path("slices"))
        for i, size in enumerate((8, 9)):
            source = vtkImageNoiseSource()
            source.SetWholeExtent(0, size, 0, 8, 0, 0)
            cast = vtkImageCast()
            cast.SetOutputScalarTypeToUnsignedChar()
            cast.SetInputConnection(source.GetOutputPort())
            writer = vtkPNGWriter()
            writer.SetInputConnection(cast.GetOutputPort())
            writer.SetFileName(os.path.join(self.path("slices"), "%d.png" % i))
            writer.Write()
        done = subprocess.run([VIEW, self.path("slices")], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("1.png' is not as large as", done.stderr)

    def write_raw(self, dtype, name="volume.raw"):
        values = vtk_to_numpy(self.volume.GetPointData().GetScalars())
        values.astype(dtype).tofile(self.path(name))
        return self.path(name)

    def test_raw(self):
        sizes = ("--raw", "20", "24", "28")
        self.draw(self.write_raw("<f4"), "20 x 24 x 28", "float", *sizes, "float")
        self.draw(
            self.write_raw(">i2"), "20 x 24 x 28", "short", *sizes, "int16", "--big-endian",
            "--spacing", "1", "2", "0.5",
        )

    def test_nrrd(self):
        self.write_raw("<f4")
        header = (
            "NRRD0004\ntype: float\ndimension: 3\nsizes: 20 24 28\nendian: little\n"
            "encoding: raw\n"
        )
        with open(self.path("volume.nhdr"), "w") as detached:
            detached.write(header + "data file: volume.raw\n")
        self.draw(self.path("volume.nhdr"))
        with open(self.path("volume.raw"), "rb") as raw, open(
            self.path("volume.nrrd"), "wb"
        ) as attached:
            attached.write(header.encode() + b"\n" + raw.read())
        self.draw(self.path("volume.nrrd"))

    def test_dicom(self):
        folder = os.path.join(DATA, "datalad_t1_dicom")
        if not os.path.isdir(folder):
            self.skipTest(folder + " is not there")
        self.draw(folder, "274 x 384 x 384", "short")


if __name__ == "__main__":
    program = unittest.main(argv=sys.argv[:1], exit=False)
    if not program.result.wasSuccessful():
        raise SystemExit(1)
