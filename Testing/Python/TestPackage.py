# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every class of every wrapped module is in the package, and says what is wrong with its settings.

    TestPackage.py SOURCE_FOLDER
"""

import pathlib
import sys

import pemesh

ROOMS = ("Filters", "IO", "Charts", "Applications")


def wrapped_classes(source):
    for description in sorted(
            path for room in ROOMS for path in (source / room).rglob("vtk.module")):
        if "EXCLUDE_WRAP" not in description.read_text():
            yield from sorted(header.stem for header in description.parent.glob("vtkPEM*.h"))


def main():
    names = list(wrapped_classes(pathlib.Path(sys.argv[1])))
    assert len(names) > 20, names
    missing = [name for name in names if not hasattr(pemesh, name)]
    assert not missing, f"not in the package: {missing}"
    layout = pemesh.vtkPEMPolygonLayout()
    layout.AddPolygon("star", 0.5, 0.5)
    mesher = pemesh.vtkPEMDomainMesher()
    mesher.SetInputConnection(layout.GetOutputPort())
    merge = pemesh.vtkPEMAgglomerate()
    merge.SetInputConnection(mesher.GetOutputPort())
    merge.SetRuleByName("diameter")
    assert merge.GetRuleName() == "diameter"
    solve = pemesh.vtkPEMVirtualElementSolver()
    solve.SetInputConnection(merge.GetOutputPort())
    solve.Update()
    mesh = solve.GetOutput()
    assert mesh.GetNumberOfCells() < mesher.GetOutput().GetNumberOfCells()
    assert mesh.GetPointData().GetArray("Solution").GetNumberOfTuples() == mesh.GetNumberOfPoints()


main()
