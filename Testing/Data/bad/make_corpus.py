"""Writes files that no reader should take: make_corpus.py FOLDER

Each is a small good volume of 4 x 5 x 6 samples with one thing wrong. What is wrong is in the name. The
good ones, for comparison, go to FOLDER/good, the others to FOLDER/bad.
"""

import gzip
import os
import struct
import sys
import zlib

N = (4, 5, 6)
SAMPLES = bytes(range(120))
HUGE = 1 << 60
MIB = 1 << 20


def cut(name, ending, good, ends):
    """Ends the file at each of the given offsets."""
    for end in ends:
        yield "%s_cut_at_%d%s" % (name, end, ending), good[:end]


def any_format(name, ending, good):
    """What may happen to any file."""
    yield name + "_empty" + ending, b""
    yield name + "_other_magic" + ending, b"\x89GIF" + good[4:]
    yield name + "_noise" + ending, bytes((i * i * 7 + i // 3) % 256 for i in range(2000))
    yield name + "_one_byte_short" + ending, good[:-1]


def edited(name, ending, lines, data, edits):
    """A header of lines (pairs of a key and a line), each cut at, left out, and edited."""
    join = lambda given: b"".join(given)
    good = join(line for _, line in lines) + data
    offset = 0
    for key, line in lines:
        yield from cut(name, ending, good, {offset + len(line) // 2, offset + len(line)} - {offset})
        offset += len(line)
    for label, key, text in edits:
        assert key in dict(lines), key
        changed = join(text if k == key else line for k, line in lines)
        yield "%s_%s%s" % (name, label, ending), changed + data
    yield from any_format(name, ending, good)
    yield name + "_half_the_data" + ending, good[:-len(data) // 2]


def sizes_in_words(key, line):
    """Edits of a line that gives the sizes as three words, which stand in for %s."""
    for label, words in (("sizes_zero", "4 0 6"), ("sizes_negative", "4 -5 6"),
            ("sizes_overflow_32_bits", "65536 65536 4"), ("sizes_overflow_64_bits",
            "4294967296 4294967296 4"), ("sizes_2_to_60", "1048576 1048576 1048576"),
            ("sizes_not_numbers", "four five six"), ("sizes_beyond_64_bits", "9" * 30 + " 5 6"),
            ("sizes_missing_one", "4 5"), ("sizes_larger", "4 5 7")):
        yield label, key, line % words.encode()


# PVM and DF3, the project's own readers.


def pvm_lines(version=b"PVM3"):
    return [("magic", version + b"\n"), ("sizes", b"4 5 6\n"), ("spacing", b"1 1 1\n"),
        ("bytes", b"1\n")]


def pvm():
    rest = b"what\0where\0how\0more\0"
    edits = list(sizes_in_words("sizes", b"%s\n")) + [
        ("spacing_nan", "spacing", b"nan 1 1\n"), ("spacing_zero", "spacing", b"0 1 1\n"),
        ("spacing_negative", "spacing", b"1 -1 1\n"), ("spacing_inf", "spacing", b"1 1 inf\n"),
        ("bytes_zero", "bytes", b"0\n"), ("bytes_three", "bytes", b"3\n"),
        ("bytes_two_of_half", "bytes", b"2\n"), ("bytes_negative", "bytes", b"-1\n"),
        ("bytes_huge", "bytes", b"4611686018427387904\n"), ("magic_PVM9", "magic", b"PVM9\n"),
        ("magic_endless", "magic", b"PVM3" + b" " * MIB)]
    # Without the texts that may follow the samples any end is one too early.
    yield from edited("pvm", ".pvm", pvm_lines(b"PVM2"), SAMPLES, edits)
    yield "pvm_trailing.pvm", b"".join(line for _, line in pvm_lines(b"PVM2")) + SAMPLES + b"more"
    yield "pvm_trailing_texts.pvm", b"".join(
        line for _, line in pvm_lines()) + SAMPLES + rest + b"more"
    for magic in (b"DDS v3d\n", b"DDS v3e\n"):
        for length in (0, 1, 7, 400):
            for fill in (0, 255, 0x5A):
                yield "dds_%c_%d_of_%02x.pvm" % (magic[6], length, fill), magic + bytes(
                    [fill]) * length


def df3():
    good = struct.pack(">3H", *N) + SAMPLES
    yield from cut("df3", ".df3", good, range(1, 7))
    yield "df3_empty.df3", b""
    yield "df3_one_byte_short.df3", good[:-1]
    yield "df3_trailing.df3", good + b"m"
    for axis in range(3):
        sizes = list(N)
        sizes[axis] = 0
        yield "df3_size_zero_%d.df3" % axis, struct.pack(">3H", *sizes) + SAMPLES
    yield "df3_sizes_largest.df3", b"\xff" * 6 + SAMPLES
    yield "df3_three_bytes.df3", good + 2 * SAMPLES


# NIfTI: the headers of 348 and of 540 bytes.


def nifti1(dim=(3, *N, 1, 1, 1, 1), kind=2, bits=8, pixdim=(1.0,) * 8, offset=352.0,
        magic=b"n+1\0", size=348, slope=1.0, affine=(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)):
    head = struct.pack("<i", size) + bytes(35) + b"\0" + struct.pack("<8h", *dim)
    head += struct.pack("<3fh", 0, 0, 0, 0) + struct.pack("<3h", kind, bits, 0)
    head += struct.pack("<8f", *pixdim) + struct.pack("<3f", offset, slope, 0.0)
    head += struct.pack("<h2B", 0, 0, 0) + struct.pack("<4f2i", 0, 0, 0, 0, 0, 0)
    head += bytes(80 + 24) + struct.pack("<2h", 1, 1) + struct.pack("<6f", *[0] * 6)
    head += struct.pack("<12f", *affine) + bytes(16) + magic
    assert len(head) == 348
    return head + bytes(4)


def nifti2(dim):
    head = struct.pack("<i", 540) + b"n+2\0\r\n\x1a\n" + struct.pack("<2h", 2, 8)
    head += struct.pack("<8q", *dim) + struct.pack("<3d", 0, 0, 0) + struct.pack("<8d", *[1] * 8)
    head += struct.pack("<q", 544) + struct.pack("<2d", 1, 0)
    return head + bytes(544 - len(head))


def nifti_headers():
    nan, inf = float("nan"), float("inf")
    for label, sizes in (("zero", (4, 0, 6)), ("negative", (4, -5, 6)), ("larger", (4, 5, 7)),
            ("largest", (32767,) * 3)):
        yield "sizes_" + label, nifti1(dim=(3, *sizes, 1, 1, 1, 1))
    for label, axes in (("none", 0), ("negative", -3), ("eight", 8), ("large", 32767)):
        yield "axes_" + label, nifti1(dim=(axes, *N, 1, 1, 1, 1))
    yield "times_largest", nifti1(dim=(7, *N, *(32767,) * 4))
    yield "times_negative", nifti1(dim=(4, *N, -2, 1, 1, 1))
    for label, kind in (("none", 0), ("bit", 1), ("unknown", 999), ("negative", -2)):
        yield "type_" + label, nifti1(kind=kind)
    yield "type_wider_than_data", nifti1(kind=64, bits=64)
    for label, value in (("nan", nan), ("inf", inf), ("huge", 3e38)):
        yield "offset_" + label, nifti1(offset=value)
        yield "spacing_" + label, nifti1(pixdim=(1, value, 1, 1, 1, 1, 1, 1))
        yield "affine_" + label, nifti1(affine=(value, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0))
    yield "offset_negative", nifti1(offset=-400.0)
    yield "offset_past_the_end", nifti1(offset=4000.0)
    yield "magic_detached", nifti1(magic=b"ni1\0")
    yield "magic_none", nifti1(magic=b"abc\0")
    yield "header_size_0", nifti1(size=0)
    yield "header_size_huge", nifti1(size=0x7FFFFFFF)
    yield "2_sizes_2_to_60", nifti2((3, 1 << 20, 1 << 20, 1 << 20, 1, 1, 1, 1))
    yield "2_sizes_overflow", nifti2((3, 1 << 62, 4, 1, 1, 1, 1, 1))
    yield "2_sizes_negative", nifti2((3, -4, 5, 6, 1, 1, 1, 1))


NIFTI_FIELDS = (0, 1, 4, 14, 32, 36, 38, 39, 40, 42, 44, 46, 56, 60, 68, 70, 72, 74, 76, 80, 84,
    108, 112, 116, 120, 123, 124, 140, 148, 228, 252, 254, 256, 280, 296, 312, 328, 344, 347, 348,
    352, 353)


def nifti():
    good = nifti1() + SAMPLES
    for label, head in nifti_headers():
        yield "nifti_%s.nii" % label, head + SAMPLES
        yield "nifti_%s.nii.gz" % label, gzip.compress(head + SAMPLES)
    yield from cut("nifti", ".nii", good, NIFTI_FIELDS)
    for end in NIFTI_FIELDS:
        yield "nifti_cut_at_%d.nii.gz" % end, gzip.compress(good[:end])
    yield from any_format("nifti", ".nii", good)
    yield "nifti_trailing.nii", good + b"more"
    packed = gzip.compress(good)
    for end in (1, 2, 3, 10, 20, len(packed) // 2, len(packed) - 9, len(packed) - 1):
        yield "nifti_gzip_cut_at_%d.nii.gz" % end, packed[:end]
    yield "nifti_gzip_damaged.nii.gz", packed[:40] + bytes(8) + packed[48:]
    yield "nifti_gzip_other_sum.nii.gz", packed[:-8] + bytes(4) + packed[-4:]
    yield "nifti_trailing.nii.gz", gzip.compress(good + b"more")
    yield "nifti_gzip_twice.nii.gz", gzip.compress(packed)
    yield from bombs("nifti", ".nii.gz", good)


def bombs(name, ending, good):
    """Of 300 MiB, and of ones within each other."""
    engine = zlib.compressobj(9, zlib.DEFLATED, 31)
    parts = [engine.compress(good)] + [engine.compress(bytes(MIB)) for _ in range(300)]
    large = b"".join(parts) + engine.flush()
    yield name + "_bomb" + ending, large
    for _ in range(10):
        large = gzip.compress(large)
    yield name + "_bomb_10_deep" + ending, large


# Headers of text.


def nrrd():
    lines = [("magic", b"NRRD0004\n"), ("type", b"type: uint8\n"), ("axes", b"dimension: 3\n"),
        ("sizes", b"sizes: 10 4 3\n"), # along the first axis VTK takes fewer than 10 for components
        ("spacing", b"spacings: 1 1 1\n"), ("encoding", b"encoding: raw\n"),
        ("end", b"\n")]
    edits = list(sizes_in_words("sizes", b"sizes: %s\n")) + [
        ("spacing_nan", "spacing", b"spacings: 1 nan 1\n"),
        ("spacing_inf", "spacing", b"spacings: 1 inf 1\n"),
        ("type_unknown", "type", b"type: nothing\n"), ("type_block", "type", b"type: block\n"),
        ("type_none", "type", b""), ("sizes_none", "sizes", b""), ("encoding_none", "encoding", b""),
        ("encoding_unknown", "encoding", b"encoding: nothing\n"),
        ("axes_2", "axes", b"dimension: 2\n"), ("axes_16", "axes", b"dimension: 16\n"),
        ("axes_negative", "axes", b"dimension: -3\n"), ("type_wider_than_data", "type",
        b"type: double\nendian: little\n"), ("magic_9999", "magic", b"NRRD9999\n"),
        ("skip_past_the_end", "encoding", b"encoding: raw\nbyte skip: 4000000\n"),
        ("skip_negative", "encoding", b"encoding: raw\nbyte skip: -400\n"),
        ("lines_endless", "encoding", b"encoding: raw\n" + b"#\n" * MIB)]
    yield from edited("nrrd", ".nrrd", lines, SAMPLES, edits)
    plain = b"".join(line for _, line in lines)
    packed = plain.replace(b"raw", b"gzip")
    yield "nrrd_trailing.nrrd", plain + SAMPLES + b"more"
    yield "nrrd_gzip_of_noise.nrrd", packed + SAMPLES
    yield "nrrd_gzip_short.nrrd", packed + gzip.compress(SAMPLES[:-1])
    yield "nrrd_gzip_cut.nrrd", packed + gzip.compress(SAMPLES)[:-12]
    yield "nrrd_gzip_trailing.nrrd", packed + gzip.compress(SAMPLES + b"more")
    for name, data in bombs("nrrd", ".nrrd", SAMPLES):
        yield name, packed + data
    yield "nrrd_ascii_short.nrrd", plain.replace(b"raw", b"ascii") + b"1 2 3 4"
    yield "nrrd_ascii_no_numbers.nrrd", plain.replace(b"raw", b"ascii") + b"one " * 120
    for label, file in (("missing", b"nowhere.raw"), ("itself", b"nrrd_data_file_itself.nhdr"),
            ("of_the_system", b"/etc/passwd"), ("endless", b"/dev/zero"), ("folder", b".")):
        yield "nrrd_data_file_%s.nhdr" % label, plain[:-1] + b"data file: " + file + b"\n"


def meta_image():
    lines = [("type", b"ObjectType = Image\n"), ("axes", b"NDims = 3\n"),
        ("binary", b"BinaryData = True\n"), ("order", b"BinaryDataByteOrderMSB = False\n"),
        ("packed", b"CompressedData = False\n"), ("spacing", b"ElementSpacing = 1 1 1\n"),
        ("sizes", b"DimSize = 4 5 6\n"), ("kind", b"ElementType = MET_UCHAR\n"),
        ("file", b"ElementDataFile = LOCAL\n")]
    edits = list(sizes_in_words("sizes", b"DimSize = %s\n")) + [
        ("spacing_nan", "spacing", b"ElementSpacing = nan 1 1\n"),
        ("spacing_zero", "spacing", b"ElementSpacing = 0 1 1\n"),
        ("axes_0", "axes", b"NDims = 0\n"), ("axes_2", "axes", b"NDims = 2\n"),
        ("axes_100", "axes", b"NDims = 100\n"), ("axes_negative", "axes", b"NDims = -3\n"),
        ("axes_none", "axes", b""), ("sizes_none", "sizes", b""), ("kind_none", "kind", b""),
        ("kind_unknown", "kind", b"ElementType = MET_NOTHING\n"),
        ("kind_wider_than_data", "kind", b"ElementType = MET_DOUBLE\n"),
        ("channels_huge", "kind", b"ElementNumberOfChannels = 99999999\nElementType = MET_UCHAR\n"),
        ("channels_negative", "kind", b"ElementNumberOfChannels = -2\nElementType = MET_UCHAR\n"),
        ("packed_noise", "packed", b"CompressedData = True\n"),
        ("packed_size_huge", "packed", b"CompressedData = True\nCompressedDataSize = %d\n" % HUGE),
        ("packed_size_negative", "packed", b"CompressedData = True\nCompressedDataSize = -5\n"),
        ("header_size_huge", "file", b"HeaderSize = 2000000000\nElementDataFile = LOCAL\n"),
        ("header_size_negative", "file", b"HeaderSize = -7\nElementDataFile = LOCAL\n"),
        ("data_file_missing", "file", b"ElementDataFile = nowhere.raw\n"),
        ("data_file_endless", "file", b"ElementDataFile = /dev/zero\n"),
        ("data_file_folder", "file", b"ElementDataFile = .\n"),
        ("data_file_list_empty", "file", b"ElementDataFile = LIST\n"),
        ("data_file_pattern_missing", "file", b"ElementDataFile = no%03d.raw 1 6 1\n"),
        ("data_file_pattern_of_texts", "file", b"ElementDataFile = no%s%n.raw 1 6 1\n"),
        ("text_of_noise", "binary", b"BinaryData = False\n"),
        ("line_endless", "binary", b"Comment = " + b"c" * MIB + b"\n")]
    yield from edited("meta", ".mha", lines, SAMPLES, edits)
    plain = b"".join(line for _, line in lines)
    packed = plain.replace(b"CompressedData = False", b"CompressedData = True")
    yield "meta_trailing.mha", plain + SAMPLES + b"more"
    yield "meta_packed_short.mha", packed + zlib.compress(SAMPLES[:-1])
    yield "meta_packed_cut.mha", packed + zlib.compress(SAMPLES)[:-12]
    for name, data in bombs("meta", ".mha", SAMPLES):
        yield name, packed + data


def vti():
    start = b'<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian" header_type="UInt32">'
    lines = [("root", start + b"\n"),
        ("whole", b'<ImageData WholeExtent="0 3 0 4 0 5" Origin="0 0 0" Spacing="1 1 1">\n'),
        ("piece", b'<Piece Extent="0 3 0 4 0 5">\n'), ("data", b'<PointData Scalars="s">\n'),
        ("array", b'<DataArray type="UInt8" Name="s" format="appended" offset="0"/>\n'),
        ("end", b"</PointData></Piece></ImageData>\n"),
        ("appended", b'<AppendedData encoding="raw">_')]
    data = struct.pack("<I", 120) + SAMPLES + b"</AppendedData></VTKFile>"
    whole = b'<ImageData WholeExtent="%s" Origin="0 0 0" Spacing="%s">\n'
    edits = [("extent_" + label, "whole", whole % (words, b"1 1 1")) for label, words in (
            ("inverted", b"3 0 4 0 5 0"), ("larger", b"0 3 0 4 0 6"), ("huge",
            b"0 1048575 0 1048575 0 1048575"), ("overflowing", b"0 2147483647 0 2147483647 0 5"),
            ("negative_huge", b"-2147483648 2147483647 0 4 0 5"), ("none", b"")
            )] + [("spacing_" + word.decode(), "whole", whole % (b"0 3 0 4 0 5", word + b" 1 1"))
            for word in (b"nan", b"inf", b"0")] + [
        ("piece_larger", "piece", b'<Piece Extent="0 9 0 9 0 9">\n'),
        ("piece_smaller", "piece", b'<Piece Extent="0 3 0 4 0 2">\n'),
        ("array_none", "array", b""),
        ("array_unknown", "array", lines[4][1].replace(b"UInt8", b"Nothing")),
        ("array_of_text", "array", lines[4][1].replace(b"UInt8", b"String")),
        ("array_of_doubles", "array", lines[4][1].replace(b"UInt8", b"Float64")),
        ("array_of_many", "array", lines[4][1].replace(
            b'Name="s"', b'Name="s" NumberOfComponents="100000000"')),
        ("offset_huge", "array", lines[4][1].replace(b'"0"', b'"%d"' % HUGE)),
        ("offset_negative", "array", lines[4][1].replace(b'"0"', b'"-9"')),
        ("root_other", "root", start.replace(b'"ImageData"', b'"PolyData"')),
        ("version_9", "root", start.replace(b"0.1", b"9.9"))]
    yield from edited("vti", ".vti", lines, data, edits)
    head = b"".join(line for _, line in lines)
    yield "vti_block_huge.vti", head + b"\xff" * 4 + data[4:]
    yield "vti_deep.vti", start + b"<a>" * 100000
    entities = b"".join(
        b'<!ENTITY %c "%s">' % (98 + i, b"&%c;" % (97 + i) * 10) for i in range(9))
    yield "vti_entities.vti", (b'<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa">' + entities + b"]>" + start +
        b"&j;</VTKFile>")


def legacy_vtk():
    lines = [("magic", b"# vtk DataFile Version 3.0\n"), ("title", b"a title\n"),
        ("mode", b"BINARY\n"), ("set", b"DATASET STRUCTURED_POINTS\n"),
        ("sizes", b"DIMENSIONS 4 5 6\n"), ("spacing", b"SPACING 1 1 1\n"),
        ("origin", b"ORIGIN 0 0 0\n"), ("points", b"POINT_DATA 120\n"),
        ("scalars", b"SCALARS s unsigned_char 1\n"), ("table", b"LOOKUP_TABLE default\n")]
    edits = list(sizes_in_words("sizes", b"DIMENSIONS %s\n")) + [
        ("spacing_nan", "spacing", b"SPACING nan 1 1\n"),
        ("spacing_zero", "spacing", b"SPACING 0 1 1\n"),
        ("points_huge", "points", b"POINT_DATA %d\n" % HUGE),
        ("points_negative", "points", b"POINT_DATA -120\n"),
        ("points_fewer", "points", b"POINT_DATA 12\n"),
        ("scalars_unknown", "scalars", b"SCALARS s nothing 1\n"),
        ("scalars_of_doubles", "scalars", b"SCALARS s double 1\n"),
        ("scalars_of_many", "scalars", b"SCALARS s unsigned_char 100000000\n"),
        ("scalars_of_minus_one", "scalars", b"SCALARS s unsigned_char -1\n"),
        ("set_unknown", "set", b"DATASET NOTHING\n"), ("set_other", "set", b"DATASET POLYDATA\n"),
        ("mode_unknown", "mode", b"NOTHING\n"), ("mode_text", "mode", b"ASCII\n")]
    yield from edited("legacy", ".vtk", lines, SAMPLES, edits)


# Images.


def png(width=4, height=5, rows=None, depth=8, colour=0):
    chunk = lambda name, data: struct.pack(">I", len(data)) + name + data + struct.pack(
        ">I", zlib.crc32(name + data))
    rows = b"".join(b"\0" + bytes(4) for _ in range(5)) if rows is None else rows
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(
        ">2I5B", width, height, depth, colour, 0, 0, 0)) + chunk(
        b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def tiff(width=4, height=5, bits=8, at=None):
    tags = [(256, 4, width), (257, 4, height), (258, 3, bits), (259, 3, 1), (262, 3, 1),
        (273, 4, 8 if at is None else at), (277, 3, 1), (278, 4, height), (279, 4, 20)]
    data = bytes(range(20))
    head = b"II*\0" + struct.pack("<I", 8 + len(data)) + data + struct.pack("<H", len(tags))
    return head + b"".join(struct.pack("<2HII", tag, kind, 1, value)
        for tag, kind, value in tags) + bytes(4)


def images():
    """Folders, each with twice the same image."""
    good = png()
    for end in (0, 4, 8, 12, 16, 20, 24, 29, 33, 37, 41, 45, len(good) - 13):
        yield "png_cut_at_%d" % end, "png", good[:end]
    yield "png_huge", "png", png(0x7FFFFFFF, 0x7FFFFFFF)
    yield "png_large", "png", png(900000, 900000)
    yield "png_zero", "png", png(0, 5)
    yield "png_few_rows", "png", png(rows=bytes(5))
    yield "png_no_depth", "png", png(depth=77)
    yield "png_bomb", "png", png(100000, 100000, bytes(100 * MIB))
    good = tiff()
    for end in (0, 4, 8, 28, 30, 50, len(good) - 5):
        yield "tiff_cut_at_%d" % end, "tif", good[:end]
    yield "tiff_huge", "tif", tiff(0x7FFFFFFF, 0x7FFFFFFF)
    yield "tiff_large", "tif", tiff(100000, 100000)
    yield "tiff_zero", "tif", tiff(0, 5)
    yield "tiff_no_bits", "tif", tiff(bits=0)
    yield "tiff_past_the_end", "tif", tiff(at=4000000)


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
    yield "good.nii.gz", gzip.compress(nifti1() + SAMPLES)
    yield "good_2.nii", nifti2((3, *N, 1, 1, 1, 1)) + SAMPLES
    for name, make, ending in (("nrrd", nrrd, ".nrrd"), ("meta", meta_image, ".mha"),
            ("vti", vti, ".vti"), ("legacy", legacy_vtk, ".vtk")):
        short = dict(make())[name + "_one_byte_short" + ending]
        yield "good" + ending, short + {"vti": b">"}.get(name, SAMPLES[-1:])
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
