"""Volume files in the File > Open and File > Save Data dialogs: test_files.py OUTPUT"""

import os
import sys

from paraview import simple

import session


def main(output):
    session.load_plugin()
    wavelet = session.make_wavelet(10)
    bytes_ = simple.Calculator(Input=wavelet, Function="RTData", ResultArrayType="Unsigned Char",
        ResultArrayName="bytes")
    only = simple.PassArrays(Input=bytes_, PointDataArrays=["bytes"])
    only.UpdatePipeline()
    expected = only.PointData.GetArray("bytes").GetRange()
    for ending, kind in (("pvm", "PVMReader"), ("df3", "DF3Reader")):
        file = os.path.join(output, "written by ParaView." + ending)
        simple.SaveData(file, only)
        reader = simple.OpenDataFile(file)
        reader.UpdatePipeline()
        assert reader.SMProxy.GetXMLName() == kind, reader.SMProxy.GetXMLName()
        information = reader.GetDataInformation()
        assert information.GetExtent() == (0, 20, 0, 20, 0, 20), information.GetExtent()
        assert reader.PointData.GetArray(0).GetRange() == expected
        view = session.make_view(128)
        display = simple.Show(reader, view)
        display.SetRepresentationType(session.REPRESENTATION)
        simple.ResetCamera(view)
        picture = session.draw(view, os.path.join(output, "Files_%s.png" % ending), 128)
        assert picture.std() > 5.0
        simple.Delete(view)


if __name__ == "__main__":
    main(sys.argv[1])
    session.end()
