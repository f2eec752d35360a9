"""Draws VTK's wavelet with vtkFlatBlockVolumeMapper: draw_wavelet.py [FILE.png]"""

import sys

from flatblock import vtkFlatBlockVolumeMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkVolumeProperty,
    vtkWindowToImageFilter,
)

source = vtkRTAnalyticSource()
source.SetWholeExtent(-50, 50, -50, 50, -50, 50)

mapper = vtkFlatBlockVolumeMapper()
mapper.SetInputConnection(source.GetOutputPort())
mapper.SetBlockSize(17)

color = vtkColorTransferFunction()
color.AddRGBPoint(40, 0.1, 0.2, 0.8)
color.AddRGBPoint(160, 0.9, 0.9, 0.8)
color.AddRGBPoint(270, 0.9, 0.2, 0.1)
opacity = vtkPiecewiseFunction()
opacity.AddPoint(150, 0.0)
opacity.AddPoint(270, 0.5)
prop = vtkVolumeProperty()
prop.SetColor(color)
prop.SetScalarOpacity(opacity)
prop.SetInterpolationTypeToLinear()

volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(prop)

renderer = vtkRenderer()
renderer.AddVolume(volume)
renderer.SetBackground(0.1, 0.12, 0.15)
renderer.GetActiveCamera().Azimuth(30)
renderer.GetActiveCamera().Elevation(20)
renderer.ResetCamera()

window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(512, 512)
window.AddRenderer(renderer)
window.Render()
print(mapper.GetNumberOfVisibleBlocks(), "of", mapper.GetNumberOfBlocks(), "blocks are visible")

grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "wavelet.png")
writer.Write()
