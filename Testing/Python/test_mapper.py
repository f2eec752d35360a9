"""The wrapped mapper: import, properties, a picture, an error."""

import unittest

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from flatblock import vtkFlatBlockVolumeMapper
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkVolumeProperty,
    vtkWindowToImageFilter,
)


class Scene:
    def __init__(self):
        color = vtkColorTransferFunction()
        color.AddRGBPoint(60, 0.1, 0.2, 0.8)
        color.AddRGBPoint(270, 1.0, 0.8, 0.1)
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(120, 0.0)
        opacity.AddPoint(270, 0.2)
        prop = vtkVolumeProperty()
        prop.SetColor(color)
        prop.SetScalarOpacity(opacity)
        self.source = vtkRTAnalyticSource()
        self.mapper = vtkFlatBlockVolumeMapper()
        self.mapper.SetInputConnection(self.source.GetOutputPort())
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.volume.SetProperty(prop)
        self.renderer = vtkRenderer()
        self.renderer.AddVolume(self.volume)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetSize(128, 128)
        self.window.AddRenderer(self.renderer)

    def draw(self):
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).copy()


class MapperTest(unittest.TestCase):
    def test_properties(self):
        mapper = vtkFlatBlockVolumeMapper()
        self.assertTrue(mapper.IsA("vtkVolumeMapper"))
        self.assertEqual(mapper.GetBlockSize(), 33)
        self.assertEqual(mapper.GetLevelFilter(), mapper.SUBSAMPLE)
        mapper.SetLevelFilterToTent()
        self.assertEqual(mapper.GetLevelFilter(), mapper.TENT)
        mapper.SetSelectionCriterionToDistance()
        self.assertEqual(mapper.GetSelectionCriterion(), mapper.DISTANCE)
        mapper.SetSelectionCriterionToDistortionAndDistance()
        self.assertEqual(mapper.GetSelectionCriterion(), mapper.DISTORTION_AND_DISTANCE)
        mapper.SetDistortionBackendToOpenMP()
        self.assertEqual(mapper.GetDistortionBackend(), mapper.OPENMP)
        mapper.SetDistortionEstimateToSummary()
        self.assertEqual(mapper.GetDistortionEstimate(), mapper.SUMMARY)
        self.assertFalse(mapper.GetVisibilityWeighting())
        self.assertEqual(mapper.GetTotalDistortion(), 0.0)
        self.assertFalse(mapper.GetConverged())
        mapper.SetBlockSize(17)
        self.assertEqual(mapper.GetBlockSize(), 17)
        self.assertEqual(mapper.GetSampleDistance(), 0.0)
        self.assertTrue(mapper.GetAutoAdjustSampleDistances())
        self.assertEqual(mapper.GetClassification(), mapper.PRE_INTEGRATED)
        mapper.SetClassificationToPreInterpolation()
        self.assertEqual(mapper.GetClassification(), mapper.PRE_INTERPOLATION)
        self.assertIn("thin shells stay whole", mapper.SetClassification.__doc__)
        self.assertIn("Samples along a block's side", vtkFlatBlockVolumeMapper.SetBlockSize.__doc__)

    def test_picture(self):
        scene = Scene()
        picture = scene.draw()
        self.assertGreater(picture.max(), 100)
        self.assertEqual(scene.mapper.GetNumberOfBlocks(), 1)
        scene.mapper.SetBlockSize(17)
        again = scene.draw()
        self.assertEqual(scene.mapper.GetNumberOfBlocks(), 8)
        self.assertLessEqual(abs(picture.astype(int) - again).max(), 2)
        self.assertGreater(scene.mapper.GetUploadedBytes(), 0)
        scene.draw()
        self.assertEqual(scene.mapper.GetUploadedBytes(), 0)

    def test_error(self):
        scene = Scene()
        errors = []
        scene.mapper.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
        scene.mapper.SetScalarModeToUsePointFieldData()
        scene.mapper.SelectScalarArray("nowhere")
        self.assertEqual(scene.draw().max(), 0)
        scene.draw()
        self.assertEqual(len(errors), 1)


if __name__ == "__main__":
    program = unittest.main(exit=False)
    if not program.result.wasSuccessful():
        raise SystemExit(1)
