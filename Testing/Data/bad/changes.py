"""What is done to good files to make them bad."""

import gzip
import zlib

N = (4, 5, 6)
SAMPLES = bytes(range(120))
HUGE = 1 << 60
MIB = 1 << 20


def pack(data):
    """As gzip, the same at any time."""
    return gzip.compress(data, mtime=0)


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


def bombs(name, ending, good):
    """Of 300 MiB, and of ones within each other."""
    engine = zlib.compressobj(9, zlib.DEFLATED, 31)
    parts = [engine.compress(good)] + [engine.compress(bytes(MIB)) for _ in range(300)]
    large = b"".join(parts) + engine.flush()
    yield name + "_bomb" + ending, large
    for _ in range(10):
        large = pack(large)
    yield name + "_bomb_10_deep" + ending, large
