"""Bad files with headers of text: NRRD, MetaImage and those of VTK."""

import struct
import zlib

from changes import HUGE, MIB, SAMPLES, bombs, edited, pack, sizes_in_words


def nrrd():
    lines = [("magic", b"NRRD0004\n"), ("type", b"type: uint8\n"), ("axes", b"dimension: 3\n"),
        ("sizes", b"sizes: 10 4 3\n"), # along the first axis VTK takes fewer than 10 for components
        ("spacing", b"spacings: 1 1 1\n"), ("encoding", b"encoding: raw\n"),
        ("end", b"\n")]
    edits = list(sizes_in_words("sizes", b"sizes: %s\n")) + [
        ("spacing_nan", "spacing", b"spacings: 1 nan 1\n"),
        ("spacing_inf", "spacing", b"spacings: 1 inf 1\n"),
        ("type_unknown", "type", b"type: nothing\n"), ("type_block", "type", b"type: block\n"),
        ("type_of_controls", "type", b"type: \x1b[2J\x07\x9b2J\xc2\x9b2J\xff\n"),
        ("type_long", "type", b"type: " + 9000 * b"\xc3\xa9" + b"\n"),
        ("type_none", "type", b""), ("sizes_none", "sizes", b""), ("encoding_none", "encoding", b""),
        ("encoding_unknown", "encoding", b"encoding: nothing\n"),
        ("axes_2", "axes", b"dimension: 2\n"), ("axes_16", "axes", b"dimension: 16\n"),
        ("axes_negative", "axes", b"dimension: -3\n"), ("type_wider_than_data", "type",
        b"type: double\nendian: little\n"), ("magic_9999", "magic", b"NRRD9999\n"),
        ("skip_past_the_end", "encoding", b"encoding: raw\nbyte skip: 4000000\n"),
        ("skip_negative", "encoding", b"encoding: raw\nbyte skip: -400\n"),
        ("lines_endless", "encoding", b"encoding: raw\n" + b"#\n" * (4 * MIB))]
    yield from edited("nrrd", ".nrrd", lines, SAMPLES, edits)
    plain = b"".join(line for _, line in lines)
    packed = plain.replace(b"raw", b"gzip")
    yield "nrrd_trailing.nrrd", plain + SAMPLES + b"more"
    yield "nrrd_gzip_of_noise.nrrd", packed + SAMPLES
    yield "nrrd_gzip_short.nrrd", packed + pack(SAMPLES[:-1])
    yield "nrrd_gzip_cut.nrrd", packed + pack(SAMPLES)[:-12]
    yield "nrrd_gzip_trailing.nrrd", packed + pack(SAMPLES + b"more")
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
        ("line_endless", "binary", b"Comment = " + b"c" * (4 * MIB) + b"\n")]
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
        ("array_of_doubles_in_a_second_set", "end", b'</PointData><PointData Scalars="s">' +
            lines[4][1].replace(b"UInt8", b"Float64") + lines[5][1]),
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
