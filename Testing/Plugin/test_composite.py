"""Partitioned and multi-block data sets of images: test_composite.py OUTPUT"""

import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection)
from vtkmodules.vtkImagingCore import vtkExtractVOI, vtkRTAnalyticSource

import session


def make_whole(half=20):
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(*([-half, half] * 3))
    source.Update()
    return source.GetOutput()


def make_blocks(half=20, ghosts=0):
    """The wavelet in eight parts, which go so many cells into each other."""
    whole = make_whole(half)
    blocks = []
    for corner in range(8):
        extract = vtkExtractVOI()
        extract.SetInputData(whole)
        parts = [(-half, ghosts) if corner >> axis & 1 else (-ghosts, half) for axis in range(3)]
        extract.SetVOI(*parts[0], *parts[1], *parts[2])
        extract.Update()
        block = vtkImageData()
        block.ShallowCopy(extract.GetOutput())
        blocks.append(block)
    return blocks


def add_ghosts(attributes, values):
    array = numpy_to_vtk(values.astype(np.uint8).ravel(), deep=True)
    array.SetName("vtkGhostType")
    attributes.AddArray(array)


def hide_box(image):
    """HIDDENPOINT of some in the middle of a part."""
    e = image.GetExtent()
    z, y, x = np.mgrid[e[4]:e[5] + 1, e[2]:e[3] + 1, e[0]:e[1] + 1]
    add_ghosts(image.GetPointData(), 2 * (abs(np.stack((x - 11, y - 9, z - 10))).max(0) < 6))


def mark_duplicates(block):
    """DUPLICATECELL of those on other parts' sides of the middle."""
    e = block.GetExtent()
    cells = np.stack(np.mgrid[e[4]:e[5], e[2]:e[3], e[0]:e[1]]) + 0.5
    sides = np.sign([e[4] + e[5], e[2] + e[3], e[0] + e[1]])
    add_ghosts(block.GetCellData(), (cells * sides[:, None, None, None]).min(0) < 0)


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

    # What is there twice is drawn once, and what is hidden stays so.
    image = make_whole()
    hide_box(image)
    hidden, _ = draw(make_composite(vtkMultiBlockDataSet, [image]), output, "Hidden")
    assert session.difference(hidden, whole) > 50.0
    overlapping = make_blocks(ghosts=2)
    for block in overlapping:
        mark_duplicates(block)
    hide_box(overlapping[0])
    picture, _ = draw(make_composite(vtkMultiBlockDataSet, overlapping), output, "Overlapping")
    assert session.difference(picture, hidden) == 0.0

    # With one of them left out the rest is where it was.
    picture, _ = draw(make_composite(vtkMultiBlockDataSet, blocks[1:]), output, "Seven")
    assert 5.0 < abs(picture - whole).mean() < 50.0


if __name__ == "__main__":
    main(sys.argv[1])
    session.end()
