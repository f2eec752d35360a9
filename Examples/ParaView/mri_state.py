"""A state that ParaView opens (File > Load State, or paraview --state=mri_state.py): the MRI template
of Debian's mricron-data as a Flat-block Volume.

The plugin is on PV_PLUGIN_PATH, or loaded before. FLATBLOCK_MRI names another file of the NIfTI kind.
"""

import os
import tempfile

from paraview import simple
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

# ParaView itself does not open NIfTI.
reader = vtkNIFTIImageReader()
reader.SetFileName(os.environ.get("FLATBLOCK_MRI", "/usr/share/mricron/templates/ch2better.nii.gz"))
writer = vtkXMLImageDataWriter()
writer.SetInputConnection(reader.GetOutputPort())
writer.SetDataModeToBinary()
writer.SetFileName(os.path.join(tempfile.gettempdir(), "flatblock_mri.vti"))
writer.Write()

mri = simple.OpenDataFile(writer.GetFileName())
mri.UpdatePipeline()
view = simple.GetActiveViewOrCreate("RenderView")
display = simple.Show(mri, view)
array = mri.PointData.GetArray(0).Name
simple.ColorBy(display, ("POINTS", array))
simple.GetColorTransferFunction(array).RGBPoints = [
    30, 0.3, 0.1, 0.1, 80, 0.8, 0.6, 0.5, 130, 1.0, 1.0, 0.9]
simple.GetOpacityTransferFunction(array).Points = [
    60, 0.0, 0.5, 0.0, 90, 0.4, 0.5, 0.0, 130, 0.9, 0.5, 0.0]

display.SetRepresentationType("Flat-block Volume")
display.FlatBlockMemoryLimit = 128
display.FlatBlockCriterion = "Distortion and Distance"
display.FlatBlockQuality = "Accurate"
display.ScalarOpacityUnitDistance = 1.0
display.Shade = 1

simple.ResetCamera(view)
camera = view.GetActiveCamera()
camera.Azimuth(150)
camera.Elevation(-60)
camera.OrthogonalizeViewUp()
camera.Zoom(1.5)
simple.Render(view)
