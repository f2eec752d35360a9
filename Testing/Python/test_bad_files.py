"""Files that no reader should take: test_bad_files.py FLATBLOCKVIEW MAKE_CORPUS DATA"""

import os
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest

from flatblock import vtkDF3Reader, vtkPVMReader
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

VIEW, MAKE_CORPUS, DATA = sys.argv[1:4]
MOST_SECONDS = 2
MOST_MIB = 200


class Run:
    """FlatBlockView, with its status, texts and the most memory it had."""

    def __init__(self, file, *options, cwd=None):
        process = subprocess.Popen([VIEW, file, *options], stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=cwd)
        timer = threading.Timer(MOST_SECONDS, process.kill)
        timer.start()
        self.stdout, self.stderr = (stream.read().decode(errors="replace")
            for stream in (process.stdout, process.stderr))
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = self.status = os.waitstatus_to_exitcode(status)
        process.stdout.close()
        process.stderr.close()
        self.mib = usage.ru_maxrss / 1024


class BadFilesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="with space ü ж ")
        subprocess.run([sys.executable, MAKE_CORPUS, cls.folder.name], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def files(self, kind):
        folder = os.path.join(self.folder.name, kind)
        for name in sorted(os.listdir(folder)):
            with self.subTest(name):
                yield os.path.join(folder, name)

    def check_refusal(self, run, file):
        self.assertEqual(run.status, 1, run.stdout + run.stderr)
        self.assertRegex(run.stderr, r"\AFlatBlockView: [^\x00-\x1f\x7f-\x9f\ufffd]*\n\Z")
        self.assertIn("'" + file + "'", run.stderr)
        self.assertNotRegex(run.stderr, r"0x[0-9a-f]{6}")
        self.assertLess(run.mib, MOST_MIB)

    def test_good_ones_are_drawn(self):
        picture = os.path.join(self.folder.name, "good.png")
        for file in self.files("good"):
            run = Run(file, "--output", picture, "--size", "32", "32")
            self.assertEqual((run.status, run.stderr), (0, ""))
            os.remove(picture)

    def test_a_current_directory_that_cannot_be_written_to(self):
        """/proc is none, even for root. A picture may go elsewhere."""
        file = os.path.join(self.folder.name, "good", "good.nii")
        run = Run(file, "--size", "32", "32", cwd="/proc")
        self.assertEqual(run.status, 1)
        self.assertEqual(run.stderr, "FlatBlockView: 'flatblock.png' could not be written.\n")
        picture = os.path.join(self.folder.name, "elsewhere.png")
        run = Run(file, "--size", "32", "32", "--output", picture, cwd="/proc")
        self.assertEqual((run.status, run.stderr), (0, ""))
        self.assertTrue(os.path.exists(picture))

    def test_bad_ones_get_one_message(self):
        picture = os.path.join(self.folder.name, "former.png")
        for file in self.files("bad"):
            with open(picture, "w") as former:
                former.write("former")
            run = Run(file, "--output", picture, "--size", "32", "32")
            self.check_refusal(run, file)
            with open(picture) as former:
                self.assertEqual(former.read(), "former")

    def test_readers_of_the_project_leave_nothing_of_bad_ones(self):
        for file in self.files("bad"):
            kind = {".pvm": vtkPVMReader, ".df3": vtkDF3Reader}.get(os.path.splitext(file)[1])
            if kind is None:
                continue
            window = vtkStringOutputWindow()
            vtkOutputWindow.SetInstance(window)
            reader = kind()
            reader.SetFileName(file)
            reader.Update()
            self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 0)
            self.assertEqual(window.GetOutput().count("ERR"), 1)
            self.assertIn(file, window.GetOutput())

    def test_broken_files_of_others(self):
        """A picture or one message, whatever VTK's readers do with them."""
        folders = [os.path.join(DATA, "bad_files", name) for name in
            ("dicom", "metaimage_nrrd", "nifti_etc")] + [os.path.join(DATA, "pynrrd")]
        if not all(os.path.isdir(folder) for folder in folders):
            self.skipTest("the broken files are not here")
        files = [os.path.join(folder, name) for folder in folders for name in os.listdir(folder)]
        for i, file in enumerate(os.listdir(folders[0])):
            files.append(os.path.join(self.folder.name, "slices_%d" % i))
            os.mkdir(files[-1])
            for name in "12":
                shutil.copy(os.path.join(folders[0], file), os.path.join(files[-1], name))
        drawn = set()
        for file in sorted(files):
            with self.subTest(file):
                run = Run(file, "--output", os.path.join(self.folder.name, "other.png"),
                    "--size", "32", "32")
                if run.status == 0:
                    drawn.add(os.path.basename(file))
                else:
                    self.check_refusal(run, file)
        self.assertGreater(len(drawn), 20)
        for name in ("invalid_utf8.mhd", "referring_to_system_file.mhd", "not-nifti.nii",
                "BallBinary30x30x30_nifti.nhdr", "image10x11x12_unsupported_version.nrrd"):
            self.assertNotIn(name, drawn)


if __name__ == "__main__":
    program = unittest.main(argv=sys.argv[:1], exit=False)
    if not program.result.wasSuccessful():
        raise SystemExit(1)
