"""Reads the particle files that imbibe writes (`.vtp`, and the `.pvd` lists) with numpy alone.

Files written by other programs (compressed, or with their numbers as text) are handed to VTK (python3-vtk9).
"""

import os
import xml.etree.ElementTree as ElementTree

from missing_packages import end_without
from tool_errors import end_with

try:
    import numpy as np
except ImportError as missing:
    end_without(missing)

NUMBERS = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8"}


class Snapshot:
    """points (n, 3); arrays {name: (n,) or (n, k)}; units {name: unit}; constants {name: number}, with "TimeValue"."""

    def __init__(self, points, arrays, units, constants):
        self.points, self.arrays, self.units, self.constants = points, arrays, units, constants


def read_series(path):
    """[(time in s, path of the snapshot)] of a `.pvd` file, by time."""
    folder, content = os.path.dirname(path), read_bytes(path)
    try:
        return sorted((float(entry.get("timestep")), os.path.join(folder, entry.get("file")))
                      for entry in ElementTree.fromstring(content).iter("DataSet"))
    except (ElementTree.ParseError, TypeError, ValueError):
        end_with(f"{path} is damaged, or no list of snapshots")


def read_snapshot(path):
    """The particles of one `.vtp` file."""
    content = read_bytes(path)
    if not content.rstrip().endswith(b"</VTKFile>"):
        end_with(f"{path} is cut short, or no file of particles")
    start = content.find(b'<AppendedData encoding="raw">')
    if start < 0 or b"compressor=" in content[:start] or b'header_type="UInt64"' not in content[:start]:
        return read_with_vtk(path)
    try:
        return read_raw(content, start)
    except (ElementTree.ParseError, AttributeError, KeyError, TypeError, ValueError):
        end_with(f"{path} is damaged")


def read_bytes(path):
    """All of a file."""
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError as error:
        end_with(f"cannot read {path}: {error.strerror}")


def read_raw(content, start):
    """The particles of a file as imbibe writes it, whose numbers begin at `start`."""
    data = content.index(b"_", start) + 1
    tree = ElementTree.fromstring(content[:start] + b"</VTKFile>")
    order = "<" if tree.get("byte_order") == "LittleEndian" else ">"

    def values(element):
        at = data + int(element.get("offset"))
        size = int(np.frombuffer(content, order + "u8", 1, at)[0])
        number = np.dtype(order + NUMBERS[element.get("type")])
        flat = np.frombuffer(content, number, size // number.itemsize, at + 8)
        components = int(element.get("NumberOfComponents", 1))
        return flat if components == 1 else flat.reshape(-1, components)

    arrays, units = {}, {}
    for element in tree.iterfind(".//PointData/DataArray"):
        arrays[element.get("Name")] = values(element)
        unit = element.find("InformationKey[@name='UNITS_LABEL']")
        units[element.get("Name")] = "" if unit is None else unit.text
    constants = {element.get("Name"): float(element.text) for element in tree.iterfind(".//FieldData/DataArray")}
    return Snapshot(values(tree.find(".//Points/DataArray")), arrays, units, constants)


def read_with_vtk(path):
    """The same through VTK's own reader."""
    try:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkDataArray, vtkObject
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    except ImportError as missing:
        end_with(f"{path} was not written by imbibe, and {missing.name} is missing; to read it install python3-vtk9")
    vtkObject.GlobalWarningDisplayOff()  # the line below says enough
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    found = reader.GetOutput()
    if reader.GetErrorCode() or found.GetPoints() is None:
        end_with(f"VTK cannot read {path}")
    arrays, units = {}, {}
    for k in range(found.GetPointData().GetNumberOfArrays()):
        array = found.GetPointData().GetArray(k)
        arrays[array.GetName()] = vtk_to_numpy(array)
        information = array.GetInformation()
        key = vtkDataArray.UNITS_LABEL()
        units[array.GetName()] = information.Get(key) if information.Has(key) else ""
    constants = {}
    for k in range(found.GetFieldData().GetNumberOfArrays()):
        array = found.GetFieldData().GetArray(k)
        if array is not None and array.GetNumberOfTuples() == 1:
            constants[array.GetName()] = array.GetTuple1(0)
    return Snapshot(vtk_to_numpy(found.GetPoints().GetData()), arrays, units, constants)


def spacing_of(snapshot):
    """The distance of neighbouring particles, m: as the file says, from mass and density, or as it looks."""
    if "spacing" in snapshot.constants:
        return snapshot.constants["spacing"]
    if "mass" in snapshot.arrays and "density" in snapshot.arrays:
        flat = np.ptp(snapshot.points[:, 2]) == 0
        return float(np.median(snapshot.arrays["mass"] / snapshot.arrays["density"])) ** (1 / (2 if flat else 3))
    points = snapshot.points
    some = points[:: max(1, len(points) // 200)]
    nearest = [np.partition(((points - one) ** 2).sum(axis=1), 1)[1] for one in some] if len(points) > 1 else [1e-6]
    return float(np.sqrt(np.median(nearest)))
