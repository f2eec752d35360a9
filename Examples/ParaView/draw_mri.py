"""Draws the MRI template of Debian's mricron-data: pvpython draw_mri.py [FILE.png]

The plugin is on PV_PLUGIN_PATH.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from mri_state import display, view
from paraview import simple

view.ViewSize = [512, 512]
simple.SaveScreenshot(sys.argv[1] if len(sys.argv) > 1 else "mri.png", view)
display.UpdatePropertyInformation()
print(display.GetProperty("FlatBlockStatus")[0])
