"""Each property of the plugin's XML reaches the mapper that draws, and has a text and a default that
is the mapper's own: pvpython test_properties.py XML..."""

import sys
import xml.etree.ElementTree as ElementTree

from paraview import simple

import flatblock
import numpy
import session

# By the representation, and not by a property of the mapper of the same name: the getter, and what
# the mapper then has.
BY_REPRESENTATION = {
    "FlatBlockMemoryLimit": (100, "GetMaxMemoryInBytes", 100 << 20),
    "FlatBlockQuality": (2, "GetClassification", 1),
    "FlatBlockProjection": (1, "GetBlendMode", 1),
    "FlatBlockUseCurvatureColor": (1, "GetCurvatureColor", None),
    "FlatBlockUseCurvatureOpacity": (1, "GetCurvatureOpacity", None),
    "FlatBlockProgressive": (1, "GetProgressiveStills", True),
}
NOT_VALUES = {"FlatBlockCurvatureColor", "FlatBlockCurvatureOpacity"}  # but what the two above show


def read_xml(files):
    """Properties of the mapper's and of the representation's proxy, and the exposed names."""
    mapper, representation, exposed = {}, {}, {}
    for file in files:
        root = ElementTree.parse(file).getroot()
        for proxy in root.iter("Proxy"):
            if proxy.get("class") == "vtkFlatBlockVolumeMapper":
                mapper.update({p.get("name"): p for p in proxy if p.tag.endswith("Property")})
        for proxy in root.iter("RepresentationProxy"):
            representation.update({p.get("name"): p for p in proxy if p.tag.endswith("Property")})
        for use in root.iter("Property"):
            if use.get("exposed_name"):
                exposed[use.get("name")] = use.get("exposed_name")
    return mapper, representation, exposed


def as_tuple(value):
    return tuple(value) if isinstance(value, tuple) else (value,)


def other_values(element, values):
    """Some that are allowed, and not these."""
    if element.find("BooleanDomain") is not None:
        return [0 if values[0] else 1]
    choices = element.find("EnumerationDomain")
    if choices is not None:
        return [[int(c.get("value")) for c in choices if int(c.get("value")) != values[0]][-1]]
    domain = next(d for d in element if d.tag.endswith("RangeDomain"))
    most = float(domain.get("max", "1e9"))
    if element.tag.startswith("Double"):
        return [v + 0.5 * (min(v + 2.0, most) - v) if v < most else 0.5 * v for v in values]
    return [int(values[0]) + (1 if values[0] < most else -1)]


def check_mapper(display, view, mapper, exposed):
    drawn = session.get_mapper(display)
    for name, element in mapper.items():
        get = getattr(drawn, "Get" + name)
        values = as_tuple(get())
        default = [float(v) for v in element.get("default_values").split()]
        assert numpy.allclose(default, values), (name, default, values)
        proxy = display.GetProperty(exposed[name])
        others = other_values(element, values)
        proxy.SetData(others)
        display.SMProxy.UpdateVTKObjects()
        simple.Render(view)
        assert numpy.allclose(as_tuple(get()), others), (name, others, get())
        proxy.SetData([float(v) if element.tag.startswith("Double") else int(v) for v in values])
        display.SMProxy.UpdateVTKObjects()
    simple.Render(view)
    assert all(
        numpy.allclose(as_tuple(getattr(drawn, "Get" + name)()),
            [float(v) for v in element.get("default_values").split()])
        for name, element in mapper.items())


def check_representation(display, view, representation):
    drawn = session.get_mapper(display)
    names = {name for name in representation if name not in NOT_VALUES}
    assert names == set(BY_REPRESENTATION), names ^ set(BY_REPRESENTATION)
    for name, (value, getter, expected) in BY_REPRESENTATION.items():
        before = display.GetProperty(name)[0]
        old = getattr(drawn, getter)()
        display.GetProperty(name).SetData([value])
        display.SMProxy.UpdateVTKObjects()
        simple.Render(view)
        new = getattr(drawn, getter)()
        assert new != old and (expected is None or new == expected), (name, old, new)
        display.GetProperty(name).SetData([before])
        display.SMProxy.UpdateVTKObjects()
        simple.Render(view)
        assert getattr(drawn, getter)() == old, (name, old)


def main(files):
    session.load_plugin()
    mapper, representation, exposed = read_xml(files)
    for name, element in {**mapper, **representation}.items():
        text = element.find("Documentation")
        assert text is not None and len(text.text) > 15, name
    assert set(mapper) == set(exposed) - {"Text", "Converged", "Progress"}, set(mapper) ^ set(exposed)
    view = session.make_view()
    display = session.show(session.make_wavelet(15), view)
    simple.Render(view)
    check_mapper(display, view, mapper, exposed)
    check_representation(display, view, representation)
    print("%d properties" % (len(mapper) + len(representation)))


if __name__ == "__main__":
    main(sys.argv[1:])
    session.end()
