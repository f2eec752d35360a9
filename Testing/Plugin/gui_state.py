"""What the test of the program begins with: the wavelet as a stock volume, and a list of what is
still to be refined in each frame. FLATBLOCK_FRAMES names its file."""

import os

from paraview import simple

simple.LoadPlugin(os.environ["FLATBLOCK_PLUGIN"], remote=False, ns=globals())
wavelet = simple.Wavelet(WholeExtent=[-40, 40] * 3)
wavelet.UpdatePipeline()
view = simple.GetActiveViewOrCreate("RenderView")
view.OrientationAxesVisibility = 0
display = simple.Show(wavelet, view)
simple.ColorBy(display, ("POINTS", "RTData"))
display.SetRepresentationType("Volume")
display.FlatBlockFraction = 0.04
simple.ResetCamera(view)


def write_frame(*_):
    display.UpdatePropertyInformation()
    with open(os.environ["FLATBLOCK_FRAMES"], "a", encoding="ascii") as file:
        file.write("%d\n" % display.GetProperty("FlatBlockProgress")[0])


view.GetRenderWindow().AddObserver("EndEvent", write_frame)
simple.Render(view)
