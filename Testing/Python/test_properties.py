"""Every property of the mapper: documented, clamped, printed, and modified only by a change:
test_properties.py HEADER..."""

import re
import sys
import unittest

from flatblock import vtkFlatBlockVolumeMapper
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction
from vtkmodules.vtkRenderingVolume import vtkVolumeMapper

HUGE = {"int": 2**31 - 1, "float": 1e300, "bool": True}
TINY = {"int": -(2**31), "float": -1e300, "bool": False}
# What takes some values only, and refuses all others with an error: those values.
CHOICES = {"BlockSize": (17, 65), "AtlasPrecision": (0, 8)}
# Not a number: an object, or a text.
OBJECTS = {"MaskInput": vtkImageData,
    "CurvatureColor": vtkColorTransferFunction,
    "CurvatureOpacity": vtkPiecewiseFunction,
    "Transfer2DYAxisArray": lambda: "name"}
HEADERS = sys.argv[1:]


def own_properties():
    """Names of what the project's classes set, and get, beyond vtkVolumeMapper."""
    theirs = set(dir(vtkVolumeMapper))
    mine = [name for name in dir(vtkFlatBlockVolumeMapper) if name not in theirs]
    names = [name[3:] for name in mine if name.startswith("Set")]
    return [name for name in names if "Get" + name in mine or "Get" + name in theirs]


def argument_types(name):
    """Types of the first signature of a setter."""
    text = getattr(vtkFlatBlockVolumeMapper, "Set" + name).__doc__
    arguments = re.search(r"Set" + name + r"\(self, (.*?)\)", text, re.S).group(1)
    return [argument.split(":")[1].strip() for argument in arguments.split(",")]


def documentation(name):
    """The comment of the group that declares the setter."""
    setter = re.compile(r"(Set\w*Macro\(" + name + r"[,)]|void Set" + name + r"\()")
    for header in HEADERS:
        with open(header, encoding="utf-8") as file:
            groups = re.findall(r"///@\{(.*?)///@\}", file.read(), re.S)
        for group in groups:
            if setter.search(group):
                return re.sub(r"[\s*/]+", " ", group[: group.index("*/")]).strip()
    return ""


class PropertiesTest(unittest.TestCase):
    def set(self, mapper, name, value, count):
        getattr(mapper, "Set" + name)(*([value] * count))
        got = getattr(mapper, "Get" + name)()
        return got

    def check_clamped(self, mapper, name, got):
        for bound, holds in (("MinValue", lambda a, b: a >= b), ("MaxValue", lambda a, b: a <= b)):
            get = getattr(mapper, "Get" + name + bound, None)
            if get:
                self.assertTrue(holds(got, get()), f"{name}: {got}")

    def check_number(self, name, kinds):
        mapper = vtkFlatBlockVolumeMapper()
        low, high = CHOICES.get(name, (TINY[kinds[0]], HUGE[kinds[0]]))
        found = []
        for value in (low, high):
            got = self.set(mapper, name, value, len(kinds))
            self.check_clamped(mapper, name, got)
            found.append(got)
            before = mapper.GetMTime()
            self.set(mapper, name, value, len(kinds))
            self.assertEqual(mapper.GetMTime(), before, f"{name} set to the same")
        self.assertNotEqual(found[0], found[1], name)
        before = mapper.GetMTime()
        self.set(mapper, name, low, len(kinds))
        self.assertGreater(mapper.GetMTime(), before, f"{name} set to something else")

    def test_numbers(self):
        names = [name for name in own_properties() if name not in OBJECTS]
        self.assertGreater(len(names), 40)
        for name in names:
            with self.subTest(name):
                kinds = argument_types(name)
                self.assertIn(kinds[0], HUGE)
                self.check_number(name, kinds)

    def test_objects(self):
        for name, kind in OBJECTS.items():
            mapper = vtkFlatBlockVolumeMapper()
            before = mapper.GetMTime()
            thing = kind()
            getattr(mapper, "Set" + name)(thing)
            self.assertEqual(getattr(mapper, "Get" + name)(), thing)
            self.assertGreater(mapper.GetMTime(), before)
            getattr(mapper, "Set" + name)(None)
            self.assertIsNone(getattr(mapper, "Get" + name)())

    def test_all_are_copied(self):
        for name in own_properties():
            with self.subTest(name):
                mapper, other = vtkFlatBlockVolumeMapper(), vtkFlatBlockVolumeMapper()
                if name in OBJECTS:
                    getattr(mapper, "Set" + name)(OBJECTS[name]())
                else:
                    kinds = argument_types(name)
                    for value in CHOICES.get(name, (TINY[kinds[0]], HUGE[kinds[0]])):
                        self.set(mapper, name, value, len(kinds))
                        if getattr(mapper, "Get" + name)() != getattr(other, "Get" + name)():
                            break
                other.ShallowCopy(mapper)
                self.assertEqual(
                    getattr(other, "Get" + name)(), getattr(mapper, "Get" + name)())
                copied = other.GetMTime()
                other.ShallowCopy(mapper)
                self.assertEqual(other.GetMTime(), copied)

    def test_all_are_printed_and_documented(self):
        text = str(vtkFlatBlockVolumeMapper())
        for name in own_properties():
            with self.subTest(name):
                self.assertRegex(text, r"(?m)^\s*" + name + r": ")
                self.assertGreater(len(documentation(name)), 40, documentation(name))

    def test_switches(self):
        mapper = vtkFlatBlockVolumeMapper()
        for name in own_properties():
            if hasattr(mapper, name + "On"):
                getattr(mapper, name + "On")()
                self.assertTrue(getattr(mapper, "Get" + name)(), name)
                getattr(mapper, name + "Off")()
                self.assertFalse(getattr(mapper, "Get" + name)(), name)

    def test_named_values(self):
        mapper = vtkFlatBlockVolumeMapper()
        names = own_properties()
        setters = [name for name in dir(mapper) if re.match(r"Set\w+To\w+$", name)]
        setters = [name for name in setters if name[3:] not in names]
        setters = [name for name in setters if name not in dir(vtkVolumeMapper)]
        self.assertGreater(len(setters), 15)
        for name in setters:
            getattr(mapper, name)()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
