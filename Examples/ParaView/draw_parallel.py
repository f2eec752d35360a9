"""Draws the wavelet by two ranks, each of which keeps its part of it, and its own limit of memory:
mpiexec -n 2 pvbatch draw_parallel.py [FILE.png]

The plugin is on PV_PLUGIN_PATH. Pictures are converged, as all that pvbatch saves.
"""

import sys

from paraview import simple

view = simple.CreateRenderView()
view.ViewSize = [512, 512]
wavelet = simple.Wavelet(WholeExtent=[-100, 100] * 3)
wavelet.UpdatePipeline()
display = simple.Show(wavelet, view)
simple.ColorBy(display, ("POINTS", "RTData"))
simple.GetColorTransferFunction("RTData").RescaleTransferFunction(-40.0, 280.0)
opacity = simple.GetOpacityTransferFunction("RTData")
opacity.Points = [120.0, 0.0, 0.5, 0.0, 280.0, 0.6, 0.5, 0.0]
display.SetRepresentationType("Flat-block Volume")
display.FlatBlockMemoryLimit = 64
display.ScalarOpacityUnitDistance = 5.0
display.Shade = 1
simple.ResetCamera(view)
view.GetActiveCamera().Azimuth(30.0)
view.GetActiveCamera().Elevation(30.0)
simple.SaveScreenshot(sys.argv[1] if len(sys.argv) > 1 else "parallel.png", view)
