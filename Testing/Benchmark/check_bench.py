"""Runs flatblock-bench over a few tiny points and reads what it wrote; then with bad arguments.

python3 check_bench.py PROGRAM FOLDER outputs|frames|arguments
"""
import base64
import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys

TINY = ["--quick", "--size", "32", "--window", "64"]
NUMBERS = ["milliseconds", "bytes", "samples_per_ray", "fetches_per_ray", "rmse", "psnr_db",
           "ssim", "largest_cieluv"]


def run(program, arguments, status=0):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != status:
        sys.exit(f"{arguments} ended with {done.returncode}, not {status}:\n{done.stderr}")
    return done


def check_json(folder):
    results = json.loads((folder / "results.json").read_text())
    assert results["machine"]["processor"] and results["machine"]["opengl"], results["machine"]
    assert results["options"]["seed"] == 7, results["options"]
    assert not results["left_out"], results["left_out"]
    for record in results["records"]:
        assert record["milliseconds"] > 0 and math.isfinite(record["rmse"]), record
    mappers = {record["mapper"] for record in results["records"]}
    assert mappers == {"vtkFlatBlockVolumeMapper", "vtkGPUVolumeRayCastMapper"}, mappers
    assert len(results["equal_error"]) == 2, results["equal_error"]
    return results["records"]


def check_csv(folder, records):
    with open(folder / "results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(records), (len(rows), len(records))
    for row, record in zip(rows, records):
        assert None not in row and None not in row.values(), row
        assert row["knob"] == record["knob"] and row["value"] == record["value"], row
        assert all(float(row[name]) == record[name] for name in NUMBERS), row


def check_report(folder):
    html = (folder / "report.html").read_text()
    pictures = re.findall(r'src="data:image/png;base64,([A-Za-z0-9+/=]+)"', html)
    assert len(pictures) == 3 and html.count("<img") == 3, len(pictures)
    shown = {base64.b64decode(picture) for picture in pictures}
    assert shown == {file.read_bytes() for file in folder.glob("*.png")}
    assert all(picture.startswith(b"\x89PNG") for picture in shown)
    markdown = (folder / "report.md").read_text()
    for file in re.findall(r"!\[[^]]*\]\(([^)]+)\)", markdown):
        assert (folder / file).stat().st_size > 0, file
    assert "## The same error" in markdown and "## thin shell" in markdown


def check_outputs(program, folder):
    run(program, [*TINY, "--seed", 7, "--output", folder, "--filter", "shell/.*sampledistance"])
    check_csv(folder, check_json(folder))
    check_report(folder)


def check_frames(program, folder):
    folder.mkdir(parents=True)
    file = folder / "frames.csv"
    run(program, [*TINY, "--filter", "shell|vessel", "--frames", file])
    with open(file, newline="") as stream:
        rows = list(csv.DictReader(stream))
    for scene in ("thin shell", "vessel tree"):
        kinds = [row["kind"] for row in rows if row["scene"] == scene]
        assert kinds == 30 * ["interactive"] + ["still"], (scene, kinds)
    assert all(float(row["milliseconds"]) > 0 and int(row["bricks"]) > 0 for row in rows)


def check_arguments(program, folder):
    folder.mkdir(parents=True)
    file = folder / "file"
    file.write_text("no volume")
    for arguments, word in (
            (["--nothing"], "--nothing"),
            (["--seed"], "--seed"),
            (["--size", "many"], "many"),
            (["--size", "8"], "8"),
            (["--window", "5000"], "5000"),
            (["--filter", "("], "regular expression"),
            (["--filter", "no such point"], "no such point"),
            (["--input", folder / "none.nii"], "none.nii"),
            ([*TINY, "--input", file, "--filter", "^input", "--output", folder / "out"], "file"),
            ([*TINY, "--output", file / "out"], "out"),
            ([*TINY, "--frames", file / "frames"], "frames")):
        errors = run(program, arguments, 1).stderr.strip().splitlines()
        # A scene may have begun, which is a line too.
        messages = [line for line in errors if line.startswith("flatblock-bench: ")]
        assert len(messages) == 1 and word in messages[0], (arguments, errors)
    assert "--filter" in run(program, ["--help"]).stdout
    listed = run(program, ["--list", "--filter", "noise/.*BlockSize"]).stdout.split("\n")
    assert len(listed) == 4, listed


def main():
    program, folder, what = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    shutil.rmtree(folder, ignore_errors=True)
    checks = {"outputs": check_outputs, "frames": check_frames, "arguments": check_arguments}
    checks[what](program, folder)


main()
