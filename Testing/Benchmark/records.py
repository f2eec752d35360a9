"""What render tests put down for a page of docs."""

import datetime
import os
import platform
import subprocess
import sys
import tempfile


def machine():
    model = platform.machine()
    with open("/proc/cpuinfo", encoding="utf-8") as info:
        for line in info:
            if line.startswith("model name"):
                model = line.split(":")[1].strip()
                break
    return "%d cores of %s" % (os.cpu_count(), model)


def run(tests, pattern, variable):
    """Rows that the tests of this pattern write to the file that the variable names."""
    with tempfile.TemporaryDirectory() as folder:
        record = os.path.join(folder, "rows.tsv")
        result = subprocess.run(
            [tests, "--gtest_filter=" + pattern],
            env=dict(os.environ, **{variable: record}),
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            check=False,
        )
        if result.returncode != 0:
            sys.exit("Tests failed; nothing is written.")
        with open(record, encoding="utf-8") as rows:
            return [line.rstrip("\n").split("\t") for line in rows]


def write_head(page, title, script, output):
    page.write("# %s\n\n" % title)
    page.write("%s, %s, Mesa's llvmpipe.\n\n" % (datetime.date.today().isoformat(), machine()))
    page.write("```\nTesting/Support/with-display.sh python3 Testing/Benchmark/%s \\\n" % script)
    page.write("  build/release/Testing/FlatBlockRenderTests %s\n```\n\n" % output)
