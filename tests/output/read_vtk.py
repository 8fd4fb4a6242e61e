#!/usr/bin/env python3
"""Reads with VTK what the C++ tests of output/ wrote and compares it with the tables written beside; then reads the
same with tools/particle_files.py. Usage: read_vtk.py FOLDER"""

import os
import sys

try:
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkDataArray
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError as missing:
    sys.exit(f"{missing.name} is missing; install python3-vtk9")

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools"))
import particle_files  # noqa: E402

FOLDER = sys.argv[1]
PRESSURE = 'pressure <&> "p"'
COLUMNS = {"velocity": slice(3, 6), "stress": slice(6, 12), "velocity gradient": slice(12, 21), PRESSURE: 21, "id": 22,
           "kind": 23}
UNITS = {"velocity": "m/s", "stress": "Pa", "velocity gradient": "1/s", PRESSURE: "N/m^2", "id": "", "kind": ""}
COMPONENTS = {"stress": "xx yy zz xy yz xz", "velocity gradient": "xx xy xz yx yy yz zx zy zz"}
checks = 0


def check(condition, *words):
    global checks
    checks += 1
    if not condition:
        sys.exit(" ".join(str(word) for word in ("FAILED:", *words)))


def vtk_read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    check(reader.GetErrorCode() == 0, path, "error", reader.GetErrorCode())
    return reader.GetOutput()


def compare(name, real, count):
    table = np.loadtxt(os.path.join(FOLDER, "vtk", name + ".csv"), delimiter=",", skiprows=1, ndmin=2).reshape(-1, 24)
    check(len(table) == count, name, "table has", len(table), "rows")
    path = os.path.join(FOLDER, "vtk", name + ".vtp")
    found = vtk_read(path)
    check(found.GetNumberOfPoints() == count, name, "has", found.GetNumberOfPoints(), "points")
    check(found.GetNumberOfVerts() == count, name, "has", found.GetNumberOfVerts(), "vertices")
    if count:
        vertices = found.GetVerts()
        check((vtk_to_numpy(vertices.GetConnectivityArray()) == np.arange(count)).all(), name, "connectivity")
        check((vtk_to_numpy(vertices.GetOffsetsArray()) == np.arange(count + 1)).all(), name, "offsets")
        points = vtk_to_numpy(found.GetPoints().GetData())
        check(points.dtype == real and (points == table[:, :3].astype(real)).all(), name, "points")

    data = found.GetPointData()
    check(data.GetNumberOfArrays() == len(COLUMNS), name, "has", data.GetNumberOfArrays(), "arrays")
    for k, (array_name, columns) in enumerate(COLUMNS.items()):
        array = data.GetArray(k)
        check(array.GetName() == array_name, name, "array", k, "is", array.GetName())
        kind = {"id": np.int64, "kind": np.int32}.get(array_name, real)
        values = vtk_to_numpy(array)
        check(values.dtype == kind, name, array_name, values.dtype)
        check(values.shape == table[:, columns].shape, name, array_name, values.shape)
        check((values == table[:, columns].astype(kind)).all(), name, array_name, "values")
        unit = array.GetInformation().Get(vtkDataArray.UNITS_LABEL()) if UNITS[array_name] else ""
        check(unit == UNITS[array_name], name, array_name, "unit", unit)
        if array_name in COMPONENTS:
            names = [array.GetComponentName(c) for c in range(array.GetNumberOfComponents())]
            check(names == COMPONENTS[array_name].split(), name, array_name, names)
    constants = found.GetFieldData()
    check(constants.GetArray("TimeValue").GetTuple1(0) == 1 / 3, name, "time")
    check(constants.GetArray("spacing").GetTuple1(0) == 8e-4, name, "spacing")

    for snapshot in [particle_files.read_snapshot(path)] + [particle_files.read_with_vtk(path)] * (count > 0):
        check((snapshot.points == table[:, :3].astype(real)).all(), name, "points by numpy")
        check(list(snapshot.arrays) == list(COLUMNS), name, "names by numpy", list(snapshot.arrays))
        for array_name, columns in COLUMNS.items():
            kind = {"id": np.int64, "kind": np.int32}.get(array_name, real)
            check((snapshot.arrays[array_name] == table[:, columns].astype(kind)).all(), name, array_name, "by numpy")
        check({key: unit or "" for key, unit in snapshot.units.items()} == UNITS, name, "units", snapshot.units)
        check(snapshot.constants == {"TimeValue": 1 / 3, "spacing": 8e-4}, name, "constants", snapshot.constants)


def compare_series():
    entries = particle_files.read_series(os.path.join(FOLDER, "series", "water.pvd"))
    expected = [k * 0.005 for k in range(11)] + [1 / 3]
    check([time for time, _ in entries] == expected, "times", entries)
    for k, (time, path) in enumerate(entries):
        check(os.path.basename(path) == f"water_{k:06d}.vtp", path)
        found = vtk_read(path)
        check(found.GetNumberOfPoints() == 100, path)
        check(found.GetFieldData().GetArray("TimeValue").GetTuple1(0) == time, path, "time")


compare("solid_double", np.float64, 10_000)
compare("solid_single", np.float32, 4096)
compare("solid_float", np.float32, 4097)
compare("flat_double", np.float64, 1000)
compare("flat_float", np.float32, 1)
compare("empty", np.float64, 0)
compare_series()
print(f"{checks} checks passed")
