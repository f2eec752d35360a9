"""PVM and DF3: round trips, pictures of known files, and what is wrong with broken ones."""

import os
import struct
import tempfile
import unittest

import numpy
from flatblock import vtkDF3Reader, vtkDF3Writer, vtkPVMReader, vtkPVMWriter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

RANDOM = numpy.random.default_rng(5)


def make_image(samples, spacing=(1.0, 1.0, 1.0)):
    """Of an array with z, y and x."""
    image = vtkImageData()
    image.SetDimensions(*samples.shape[::-1])
    image.SetSpacing(*spacing)
    array = numpy_to_vtk(samples.ravel(), deep=True)
    array.SetName("samples")
    image.GetPointData().SetScalars(array)
    return image


def as_array(image):
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])


def waves(shape, kind):
    z, y, x = numpy.indices(shape)
    most = numpy.iinfo(kind).max
    return (most * (0.5 + 0.5 * numpy.sin(0.2 * x + 0.1 * y) * numpy.cos(0.15 * z))).astype(kind)


class FilesTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="with space ü ")
        self.file = os.path.join(self.folder.name, "file")
        self.window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.window)

    def tearDown(self):
        self.assertEqual(self.window.GetOutput(), "")
        self.folder.cleanup()

    def read(self, reader, file=None):
        reader.SetFileName(file or self.file)
        reader.Update()
        return reader.GetOutput()

    def write(self, bytes):
        with open(self.file, "wb") as file:
            file.write(bytes)

    def check_round_trip(self, writer, reader, samples, spacing=(1.0, 1.0, 1.0)):
        writer.SetFileName(self.file)
        writer.SetInputData(make_image(samples, spacing))
        self.assertEqual(writer.Write(), 1)
        self.assertEqual(reader.CanReadFile(self.file), 3)
        image = self.read(reader)
        self.assertEqual(as_array(image).dtype, samples.dtype)
        self.assertTrue((as_array(image) == samples).all())
        numpy.testing.assert_allclose(image.GetSpacing(), spacing, rtol=1e-8)
        self.assertEqual(os.listdir(self.folder.name), ["file"])
        return os.path.getsize(self.file)

    def kinds(self, *types):
        for kind in types:
            for shape in ((1, 1, 1), (2, 3, 5), (17, 40, 33)):
                yield waves(shape, kind)
                most = numpy.iinfo(kind).max
                yield RANDOM.integers(0, most, shape, dtype=kind, endpoint=True)
                yield numpy.full(shape, most, dtype=kind)

    def test_df3_round_trips(self):
        for samples in self.kinds("uint8", "uint16", "uint32"):
            self.check_round_trip(vtkDF3Writer(), vtkDF3Reader(), samples)

    def test_pvm_round_trips(self):
        for samples in self.kinds("uint8", "uint16"):
            for is_compressed in (0, 1):
                writer = vtkPVMWriter()
                writer.SetCompressed(is_compressed)
                self.check_round_trip(writer, vtkPVMReader(), samples, (0.5, 1.25, 3.0))

    def test_compression_pays(self):
        for kind in ("uint8", "uint16"):
            samples = waves((64, 64, 64), "uint8").astype(kind) // 8
            size = self.check_round_trip(vtkPVMWriter(), vtkPVMReader(), samples)
            self.assertLess(size, 0.6 * samples.nbytes)

    def test_streams_of_more_than_a_part_are_sorted_in_parts(self):
        samples = waves((130, 260, 260), "uint16")
        self.check_round_trip(vtkPVMWriter(), vtkPVMReader(), samples)
        with open(self.file, "rb") as file:
            self.assertEqual(file.read(8), b"DDS v3e\n")

    def test_headers(self):
        samples = bytes(range(6))
        for text, spacing in ((b"PVM\n1 2 3\n1\n", (1, 1, 1)),
                (b"PVM\n# a comment\n1 2 3\n1\n", (1, 1, 1)),
                (b"PVM2\n1 2 3\n0.5 1 2\n1\n", (0.5, 1, 2)),
                (b"PVM3\n1 2 3\n0.5 1 2\n1\n", (0.5, 1, 2))):
            rest = b"what\0who\0how\0more\0" if text.startswith(b"PVM3") else b""
            self.write(text + samples + rest)
            image = self.read(vtkPVMReader())
            self.assertEqual(image.GetDimensions(), (1, 2, 3))
            self.assertEqual(image.GetSpacing(), spacing)
            self.assertEqual(as_array(image).ravel().tolist(), list(samples))
        self.write(b"PVM\n1 1 2\n2\n" + bytes([1, 2, 255, 254]))
        self.assertEqual(as_array(self.read(vtkPVMReader())).ravel().tolist(), [258, 65534])

    def test_a_stream_by_hand(self):
        # PVM\n1 1 1\n1\n and a sample of 7: a run of 13 bytes that each have 8 bits.
        plain = b"PVM\n1 1 1\n1\n\x07"
        bits = "00" + "0" * 16 + format(len(plain), "07b") + "111"
        before = 0
        for byte in plain:
            bits += format((byte - before + 128) % 256, "08b")
            before = byte
        bits += "0" * 7
        bits += "0" * (-len(bits) % 8)
        self.write(b"DDS v3d\n" + int(bits, 2).to_bytes(len(bits) // 8, "big"))
        self.assertEqual(as_array(self.read(vtkPVMReader())).ravel().tolist(), [7])

    def test_extents_are_streamed(self):
        samples = waves((20, 30, 40), "uint16")
        for writer, reader in ((vtkDF3Writer(), vtkDF3Reader()), (vtkPVMWriter(), vtkPVMReader())):
            writer.SetFileName(self.file)
            writer.SetInputData(make_image(samples))
            writer.Write()
            reader.SetFileName(self.file)
            reader.UpdateExtent((3, 12, 5, 9, 7, 8))
            image = reader.GetOutput()
            self.assertEqual(image.GetExtent(), (3, 12, 5, 9, 7, 8))
            self.assertTrue((as_array(image) == samples[7:9, 5:10, 3:13]).all())

    def fails(self, reader, words):
        self.assertEqual(reader.CanReadFile(self.file), 0)
        self.has_failed(reader, self.read(reader), words)

    def has_failed(self, reader, image, words):
        text = self.window.GetOutput()
        self.window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.window)
        self.assertEqual(text.count("ERR"), 1, text)
        self.assertIn(self.file, text)
        self.assertIn(words, text)
        self.assertEqual(image.GetNumberOfPoints(), 0)
        self.assertNotEqual(reader.GetErrorCode(), 0)

    def test_broken_df3(self):
        header = struct.pack(">HHH", 2, 3, 4)
        for content, words in ((b"", "at byte 0"), (header[:5], "at byte 5"),
                (header, "0 bytes from here on, but 24 samples"),
                (header + bytes(23), "23 bytes"), (header + bytes(97), "97 bytes"),
                (struct.pack(">HHH", 2, 0, 4) + bytes(8), "at byte 2: a number of samples is 0"),
                (struct.pack(">HHH", 65535, 65535, 65535) + bytes(9), "9 bytes")):
            self.write(content)
            self.fails(vtkDF3Reader(), words)

    def test_broken_pvm(self):
        for content, words in ((b"", "ends before a first line"),
                (b"PVM", "ends before a first line"), (b"PVM4\n1 1 1\n1\n1", "neither PVM"),
                (b"PVM\n", "at byte 4: the header ends before three numbers"),
                (b"PVM\n1 1\n1\n1", "'1 1' is not three numbers of samples"),
                (b"PVM\n1 1 1 1\n1\n1", "is not three numbers"),
                (b"PVM\n0 1 1\n1\n1", "a number of samples is 0"),
                (b"PVM\n1 -1 1\n1\n1", "a number of samples is -1"),
                (b"PVM\n99999999999 1 1\n1\n1", "is not three numbers"),
                (b"PVM\n16777216 16777216 16777216\n1\n1", "asks for"),
                (b"PVM\n1 1 1\n3\n123", "a sample has 3 bytes"),
                (b"PVM\n1 1 1\none\n1", "'one' is not the bytes of a sample"),
                (b"PVM2\n1 1 1\n0 1 1\n1\n1", "a spacing is not above 0"),
                (b"PVM2\n1 1 1\nnan 1 1\n1\n1", "is not three spacings"),
                (b"PVM2\n1 1 1\n1 1 1e999\n1\n1", "spacing"),
                (b"PVM\n2 2 2\n1\n1234567", "the file ends, but"),
                (b"PVM\n2 2 2\n1\n123456789", "1 bytes follow the samples"),
                (b"PVM3\n1 1 1\n1 1 1\n1\n1a\0b\0", "4 bytes follow the samples"),
                (b"DDS v3d\n", "the compressed stream ends early"),
                (b"DDS v3d\n" + bytes(10), "ends before a first line")):
            self.write(content)
            with self.subTest(content):
                self.fails(vtkPVMReader(), words)

    def test_files_exchanged_while_they_are_read(self):
        for samples, words in ((numpy.zeros((9, 8, 7), "uint8"), "fewer samples than before"),
                (numpy.zeros((9, 9, 9), "uint16"), "of another size than before")):
            self.check_round_trip(vtkPVMWriter(), vtkPVMReader(), numpy.zeros((9, 9, 9), "uint8"))
            reader = vtkPVMReader()
            reader.SetFileName(self.file)
            reader.UpdateInformation()
            self.check_round_trip(vtkPVMWriter(), vtkPVMReader(), samples)
            reader.Update()
            self.has_failed(reader, reader.GetOutput(), words)

    def test_no_file(self):
        for kind in (vtkPVMReader, vtkDF3Reader):
            self.fails(kind(), "it does not exist")
            os.mkdir(self.file)
            self.fails(kind(), "it is no file")
            os.rmdir(self.file)

    def test_all_cuts_of_a_file_are_refused(self):
        for is_compressed in (0, 1):
            writer = vtkPVMWriter()
            writer.SetCompressed(is_compressed)
            writer.SetFileName(self.file)
            writer.SetInputData(make_image(waves((3, 4, 5), "uint16")))
            writer.Write()
            with open(self.file, "rb") as file:
                whole = file.read()
            for count in range(len(whole) - 4):  # texts may be missing
                self.write(whole[:count])
                self.read(vtkPVMReader())
                text = self.window.GetOutput()
                self.window = vtkStringOutputWindow()
                vtkOutputWindow.SetInstance(self.window)
                self.assertEqual(text.count("ERR"), 1, (count, text))

    def test_writers_refuse_and_leave_what_was_there(self):
        self.write(b"precious")
        for writer, words in ((vtkDF3Writer(), "1, 2 or 4 bytes"), (vtkPVMWriter(), "1 or 2 bytes")):
            writer.SetFileName(self.file)
            writer.SetInputData(make_image(numpy.zeros((2, 2, 2), dtype="float32")))
            writer.Write()
            text = self.window.GetOutput()
            self.window = vtkStringOutputWindow()
            vtkOutputWindow.SetInstance(self.window)
            self.assertIn(words, text)
        with open(self.file, "rb") as file:
            self.assertEqual(file.read(), b"precious")


if __name__ == "__main__":
    unittest.main()
