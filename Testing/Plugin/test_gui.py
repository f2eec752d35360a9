"""The program itself, by its own client test: panel, undo, refinement, picture.

test_gui.py PARAVIEW BASELINE OUTPUT
"""

import os
import subprocess
import sys

FOLDER = os.path.dirname(os.path.abspath(__file__))


def main(paraview, baseline, output):
    frames = os.path.join(output, "gui_frames.txt")
    if os.path.exists(frames):
        os.remove(frames)
    subprocess.run([paraview, "--dr", "--state=" + os.path.join(FOLDER, "gui_state.py"),
        "--test-script=" + os.path.join(FOLDER, "gui_test.xml"), "--test-baseline=" + baseline,
        "--test-threshold=10", "--test-directory=" + output, "--exit"], check=True, timeout=200,
        env=dict(os.environ, FLATBLOCK_FRAMES=frames, XDG_RUNTIME_DIR=output))
    with open(frames, encoding="ascii") as file:
        shares = [int(line) for line in file]
    print("share of the blocks that are as fine as wanted, frame by frame:", shares)
    # After an edit frames go on that nobody asked for; a screenshot is converged.
    assert sum(1 for before, after in zip(shares, shares[1:]) if before < after < 100) >= 3
    assert shares[-1] == 100


if __name__ == "__main__":
    main(*sys.argv[1:])
