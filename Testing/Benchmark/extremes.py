"""Writes the table of extremes: extremes.py RENDER_TESTS OUTPUT.md

RENDER_TESTS is the program FlatBlockRenderTests. Its tests of extremes put down what they tried,
what came out, and the largest difference of a channel to the double-precision reference.
"""

import sys

import records

FILTER = "Extreme*:RandomScenes*"


def merge(rows):
    """The largest error of each thing that was tried, in the order of the tests."""
    groups = {}
    for group, what, came, error in rows:
        entries = groups.setdefault(group, {})
        before = entries.get((what, came), 0.0)
        entries[(what, came)] = max(before, float(error))
    return groups


def write(groups, output):
    with open(output, "w", encoding="utf-8") as page:
        records.write_head(
            page, "Extremes: what was tried, and what came out", "extremes.py", "docs/extremes.md"
        )
        page.write(
            "The error is the largest difference of a channel, colour or opacity, of a float\n"
            "picture to the double-precision reference. Where nothing else is said, steps are half\n"
            "a voxel long and a ray ends at an opacity of 1 - 1/255, so that up to 0.004 is\n"
            "expected. No picture had a value that is not finite, or beyond [0, 1].\n"
        )
        for group, entries in groups.items():
            page.write("\n## %s\n\n| tried | came out | largest error |\n|---|---|---|\n" % (
                group[0].upper() + group[1:]))
            for (what, came), error in entries.items():
                page.write("| %s | %s | %.1e |\n" % (what, came, error))


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.splitlines()[0])
    write(merge(records.run(sys.argv[1], FILTER, "FLATBLOCK_EXTREMES")), sys.argv[2])


main()
