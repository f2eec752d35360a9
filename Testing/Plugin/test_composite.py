"""Partitioned and multi-block data sets of images: test_composite.py OUTPUT"""

import os
import sys

from paraview import simple
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection)
from vtkmodules.vtkImagingCore import vtkExtractVOI, vtkRTAnalyticSource

import session


def make_blocks(half=20):
    """The wavelet in eight parts."""
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(*([-half, half] * 3))
    source.Update()
    blocks = []
    for corner in range(8):
        extract = vtkExtractVOI()
        extract.SetInputData(source.GetOutput())
        parts = [(-half, 0) if corner >> axis & 1 else (0, half) for axis in range(3)]
        extract.SetVOI(*parts[0], *parts[1], *parts[2])
        extract.Update()
        block = vtkImageData()
        block.ShallowCopy(extract.GetOutput())
        blocks.append(block)
    return blocks


def make_composite(kind, blocks):
    data = kind()
    for i, block in enumerate(blocks):
        if kind is vtkMultiBlockDataSet:
            data.SetBlock(i, block)
        elif kind is vtkPartitionedDataSet:
            data.SetPartition(i, block)
        else:
            data.SetPartition(i, 0, block)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def draw(source, output, name):
    view = session.make_view()
    display = session.show(source, view)
    session.look(view)
    picture = session.draw(view, os.path.join(output, "Composite" + name + ".png"))
    return picture, session.get_status(display)


def main(output):
    session.load_plugin()
    whole, _ = draw(session.make_wavelet(20), output, "Whole")
    assert whole.std() > 20.0
    blocks = make_blocks()
    for kind in (vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection):
        picture, _ = draw(make_composite(kind, blocks), output, kind.__name__)
        assert session.difference(picture, whole) == 0.0, kind  # one grid, so one image

    # A hundredth of a spacing aside: no grid, so a mapper each, from the farthest to the nearest.
    blocks[7].SetOrigin(0.01, 0.0, 0.0)
    picture, status = draw(make_composite(vtkMultiBlockDataSet, blocks), output, "Apart")
    print("pieces: %.0f, %.1f dB" % (session.difference(picture, whole), session.psnr(picture, whole)))
    assert session.psnr(picture, whole) > 45.0
    assert session.difference(picture, whole) <= 24.0  # slopes at borders are one-sided
    assert "of 256.0 MiB" in status, status  # in all
    blocks[7].SetOrigin(0.0, 0.0, 0.0)

    # With one of them left out the rest is where it was.
    picture, _ = draw(make_composite(vtkMultiBlockDataSet, blocks[1:]), output, "Seven")
    assert 5.0 < abs(picture - whole).mean() < 50.0


if __name__ == "__main__":
    main(sys.argv[1])
    session.end()
