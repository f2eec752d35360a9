"""Views and links, edits, selection, and what hidden and deleted representations give back:
test_views.py OUTPUT"""

import os
import sys

from paraview import simple

import flatblock
import session


def check_memory(wavelet, display, view):
    mapper = session.get_mapper(display)
    simple.Render(view)
    used = mapper.GetMemoryInBytes()
    assert used > 100000, used
    display.Visibility = 0
    simple.Render(view)
    assert mapper.GetMemoryInBytes() == 0
    display.Visibility = 1
    simple.Render(view)
    assert mapper.GetMemoryInBytes() == used
    display.SetRepresentationType("Volume")
    simple.Render(view)
    assert mapper.GetMemoryInBytes() == 0
    display.SetRepresentationType(session.REPRESENTATION)
    simple.Render(view)
    assert mapper.GetMemoryInBytes() == used
    return mapper


def check_views(wavelet, display, view, picture, output):
    other = session.make_view()
    second = session.show(wavelet, other)
    simple.AddCameraLink(view, other, "link")
    view.GetActiveCamera().Modified()
    simple.Render(view)
    drawn = session.draw(other, os.path.join(output, "ViewsSecond.png"))
    assert session.difference(drawn, picture) == 0.0
    view.GetActiveCamera().Azimuth(20.0)
    simple.Render(view)
    turned = session.draw(view, os.path.join(output, "ViewsTurned.png"))
    assert session.psnr(turned, picture) < 40.0
    linked = session.draw(other, os.path.join(output, "ViewsLinked.png"))
    assert session.difference(linked, turned) == 0.0

    # Properties of one follow those of the other.
    link = simple.servermanager.vtkSMPropertyLink()
    link.AddLinkedProperty(display.SMProxy, "FlatBlockSize", 1)
    link.AddLinkedProperty(second.SMProxy, "FlatBlockSize", 2)
    display.FlatBlockSize = 17
    assert second.FlatBlockSize == "17", second.FlatBlockSize
    simple.Delete(other)


def check_edits(display, view, output):
    before = session.draw(view, os.path.join(output, "ViewsBefore.png"))
    opacity = simple.GetOpacityTransferFunction("RTData")
    points = list(opacity.Points)
    opacity.Points = [37, 0, 0.5, 0, 150, 0, 0.5, 0, 277, 1, 0.5, 0]
    edited = session.draw(view, os.path.join(output, "ViewsEdited.png"))
    assert session.psnr(edited, before) < 35.0
    opacity.Points = points
    after = session.draw(view, os.path.join(output, "ViewsAfter.png"))
    assert session.difference(after, before) == 0.0


def check_selection(wavelet, view):
    simple.SelectSurfacePoints(Rectangle=[120, 120, 124, 124], View=view)
    extract = simple.ExtractSelection(Input=wavelet)
    extract.UpdatePipeline()
    points = extract.GetDataInformation().GetNumberOfPoints()
    assert 0 < points <= 25, points
    array = extract.PointData.GetArray("RTData")
    assert array and 37.0 <= array.GetRange()[0] <= array.GetRange()[1] <= 277.0
    simple.ClearSelection(wavelet)


def main(output):
    session.load_plugin()
    view = session.make_view()
    wavelet = session.make_wavelet()
    display = session.show(wavelet, view)
    session.look(view)
    picture = session.draw(view, os.path.join(output, "Views.png"))
    mapper = check_memory(wavelet, display, view)
    check_views(wavelet, display, view, picture, output)
    check_edits(display, view, output)
    check_selection(wavelet, view)
    assert "Memory: " in session.get_status(display), session.get_status(display)
    assert display.GetProperty("FlatBlockProgress")[0] == 100
    simple.Delete(display)
    assert mapper.GetMemoryInBytes() == 0


if __name__ == "__main__":
    main(sys.argv[1])
    session.end()
