"""The wavelet, by as many ranks as there are: pvbatch draw_parallel.py PICTURE SHADE"""

import sys

from paraview import simple

import session

session.load_plugin()
parallel_view = session.make_view()
session.show(session.make_wavelet(), parallel_view, shade=int(sys.argv[2]))
session.look(parallel_view)
simple.SaveScreenshot(sys.argv[1], parallel_view, ImageResolution=[256, 256])
