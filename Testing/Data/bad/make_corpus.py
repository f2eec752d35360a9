"""Writes files that no reader should take: make_corpus.py FOLDER

Each is a small good volume of 4 x 5 x 6 samples with one thing wrong. What is wrong is in the name. The
good ones, for comparison, go to FOLDER/good, the others to FOLDER/bad.
"""

import os
import struct
import sys

from binary_formats import (
    df3, images, nifti, nifti1, nifti2, png, pvm, pvm_lines, tiff)
from changes import N, SAMPLES, pack
from text_formats import legacy_vtk, meta_image, nrrd, vti


def raw():
    yield "raw_4x5x6_uint16.raw", SAMPLES
    yield "raw_4x5x7_uint8.raw", SAMPLES
    yield "raw_0x5x6_uint8.raw", SAMPLES
    yield "raw_999999x999999x999999_uint8.raw", SAMPLES
    yield "raw_unsaid.raw", SAMPLES
    yield "raw_empty_4x5x6_uint8.raw", b""


def others():
    yield "of_no_ending", SAMPLES
    yield "of_other_ending.txt", b"a text"


def good_files():
    yield "good.pvm", b"".join(line for _, line in pvm_lines()) + SAMPLES + b"a\0b\0c\0d\0"
    yield "good.df3", struct.pack(">3H", *N) + SAMPLES
    yield "good.nii", nifti1() + SAMPLES
    yield "good.nii.gz", pack(nifti1() + SAMPLES)
    yield "good_padded.nii.gz", pack(nifti1() + SAMPLES) + bytes(70000)
    yield "good_of_members.nii.gz", pack(nifti1()) + pack(SAMPLES)
    yield "good_unused_affine.nii", nifti1(affine=(float("nan"),) * 12, codes=(0, 0)) + SAMPLES
    yield "good_2.nii", nifti2((3, *N, 1, 1, 1, 1)) + SAMPLES
    for name, make, ending in (("nrrd", nrrd, ".nrrd"), ("meta", meta_image, ".mha"),
            ("vti", vti, ".vti"), ("legacy", legacy_vtk, ".vtk")):
        short = dict(make())[name + "_one_byte_short" + ending]
        yield "good" + ending, short + {"vti": b">"}.get(name, SAMPLES[-1:])
    short_vti = dict(vti())["vti_one_byte_short.vti"]
    texts = (b'<Array type="String" Name="t" format="ascii" NumberOfTuples="120">' + b"97 0 " * 2000 +
        b"</Array>")
    end = short_vti.index(b"</ImageData>")
    begin = short_vti.index(b"<Piece")
    for place in (begin, end):
        yield "good_empty_piece_at_%d.vti" % place, (short_vti[:place] +
            b'<Piece Extent="0 -1 0 -1 0 -1"><PointData/></Piece>' + short_vti[place:] + b">")
    array = short_vti.index(b"<DataArray")
    yield "good_texts_beside.vti", short_vti[:array] + texts + short_vti[array:] + b">"
    yield "good_4x5x6_uint8.raw", SAMPLES


def write(folder, name, data):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name), "wb") as file:
        file.write(data)


def main(folder):
    for name, data in good_files():
        write(os.path.join(folder, "good"), name, data)
    for name, image in (("good_png", png()), ("good_tiff", tiff())):
        for i in "12":
            write(os.path.join(folder, "good", name), i + "." + name[5:], image)
    bad = os.path.join(folder, "bad")
    for make in (pvm, df3, nifti, nrrd, meta_image, vti, legacy_vtk, raw, others):
        for name, data in make():
            assert not os.path.exists(os.path.join(bad, name)), name
            write(bad, name, data)
    for name, ending, data in images():
        for i in "12":
            write(os.path.join(bad, name), i + "." + ending, data)
    os.makedirs(os.path.join(bad, "empty_folder"))
    for ending in (".pvm", ".df3", ".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti", ".vtk",
            ".raw"):
        os.makedirs(os.path.join(bad, "folder" + ending))
        write(bad, "unreadable" + ending, SAMPLES)
        os.chmod(os.path.join(bad, "unreadable" + ending), 0)
        os.symlink("dangling" + ending + ".not", os.path.join(bad, "dangling" + ending))
    for i in range(3):
        write(os.path.join(bad, "dicom_noise"), "%d.dcm" % i, bytes(128) + b"DICM" + SAMPLES * i)


if __name__ == "__main__":
    main(sys.argv[1])
