"""States and traces restore a picture in another process: test_state.py PVPYTHON OUTPUT [STATE]"""

import os
import subprocess
import sys

from paraview import simple, smstate

import session


def set_all(display):
    """What is not as it would be by itself."""
    display.FlatBlockSize = 17
    display.FlatBlockMemoryLimit = 64
    display.FlatBlockUseCamera = 0
    display.FlatBlockPointOfInterest = [5.0, 6.0, 7.0]
    display.FlatBlockQuality = "Accurate"
    display.FlatBlockCurvatureFunction = "Mean"
    display.FlatBlockFilter = "Cubic B-Spline"
    display.FlatBlockUseCurvatureColor = 1
    display.FlatBlockCurvatureColor.RGBPoints = [0.0, 0.0, 0.5, 0.0, 1.0, 1.0, 1.0, 0.0]
    display.FlatBlockCurvatureRange = [-0.3, 0.3]
    display.FlatBlockSilhouetteWidth = 0.4


def restore(state, output):
    """The only view's picture."""
    if state.endswith(".py"):
        with open(state, encoding="utf-8") as file:
            exec(compile(file.read(), state, "exec"), {"__name__": "__main__"})
    else:
        simple.LoadState(state)
    view = simple.GetRenderViews()[0]
    session.draw(view, output)


def main(pvpython, output):
    session.load_plugin()
    view = session.make_view()
    display = session.show(session.make_wavelet(), view)
    session.look(view)
    plain = session.draw(view, os.path.join(output, "StatePlain.png"))
    set_all(display)
    expected = session.draw(view, os.path.join(output, "State.png"))
    assert session.psnr(expected, plain) < 30.0
    for kind in ("pvsm", "py"):
        state = os.path.join(output, "state." + kind)
        if kind == "pvsm":
            simple.SaveState(state)
        else:
            with open(state, "w", encoding="utf-8") as file:
                file.write(smstate.get_state())
        picture = os.path.join(output, "StateFrom_%s.png" % kind)
        subprocess.run([pvpython, "--force-offscreen-rendering", __file__, pvpython, picture, state],
            check=True)
        assert session.difference(session.read(picture), expected) == 0.0, kind
    with open(os.path.join(output, "state.py"), encoding="utf-8") as file:
        text = file.read()
    assert "FlatBlockCurvatureFunction = 'Mean'" in text
    assert "FlatBlockProgressive" not in text


if __name__ == "__main__":
    if len(sys.argv) > 3:
        session.load_plugin()
        restore(sys.argv[3], sys.argv[2])
    else:
        main(*sys.argv[1:])
    session.end()
