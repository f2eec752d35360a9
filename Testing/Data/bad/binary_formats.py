"""Bad files of numbers: PVM, DF3, NIfTI and images."""

import struct
import zlib

from changes import MIB, N, SAMPLES, any_format, bombs, cut, edited, pack, sizes_in_words


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
        # Samples of two bytes, in runs of 127 that need no bits.
        runs = "01" + 16 * "0" + 800000 * "1111111000" + 14 * "0"
        yield "dds_%c_of_100_MB.pvm" % magic[6], magic + int(runs, 2).to_bytes(len(runs) // 8, "big")


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
        magic=b"n+1\0", size=348, slope=1.0, affine=(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0), codes=(1, 1)):
    head = struct.pack("<i", size) + bytes(35) + b"\0" + struct.pack("<8h", *dim)
    head += struct.pack("<3fh", 0, 0, 0, 0) + struct.pack("<3h", kind, bits, 0)
    head += struct.pack("<8f", *pixdim) + struct.pack("<3f", offset, slope, 0.0)
    head += struct.pack("<h2B", 0, 0, 0) + struct.pack("<4f2i", 0, 0, 0, 0, 0, 0)
    head += bytes(80 + 24) + struct.pack("<2h", *codes) + struct.pack("<6f", *[0] * 6)
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
        yield "nifti_%s.nii.gz" % label, pack(head + SAMPLES)
    yield from cut("nifti", ".nii", good, NIFTI_FIELDS)
    for end in NIFTI_FIELDS:
        yield "nifti_cut_at_%d.nii.gz" % end, pack(good[:end])
    yield from any_format("nifti", ".nii", good)
    yield "nifti_trailing.nii", good + b"more"
    packed = pack(good)
    for end in (1, 2, 3, 10, 20, len(packed) // 2, len(packed) - 9, len(packed) - 1):
        yield "nifti_gzip_cut_at_%d.nii.gz" % end, packed[:end]
    yield "nifti_gzip_damaged.nii.gz", packed[:40] + bytes(8) + packed[48:]
    yield "nifti_gzip_other_sum.nii.gz", packed[:-8] + bytes(4) + packed[-4:]
    yield "nifti_trailing.nii.gz", pack(good + b"more")
    yield "nifti_gzip_twice.nii.gz", pack(packed)
    yield "nifti_gzip_padded_with_more.nii.gz", packed + bytes(99) + b"more"
    yield from bombs("nifti", ".nii.gz", good)


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
