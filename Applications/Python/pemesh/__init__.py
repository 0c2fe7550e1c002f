# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""PEMesh: how the geometry of polygonal meshes affects polytopal element methods.

A study in three lines:

    import pemesh
    results = pemesh.run("quickstart.json")
    print(results.findings)

Each of its steps alone: mesh() and read() make a mesh, metrics() and summary() measure it, solve()
and solve_all() solve on it, correlate() and findings() say what drives what. Tables are mappings
from names to NumPy arrays. Whatever goes wrong raises Error with a sentence.

All filters are classes of this package too, and work beside those of `vtkmodules`:

    layout = pemesh.vtkPEMPolygonLayout()
    layout.AddPolygon("star", 0.5, 0.5)
    mesher = pemesh.vtkPEMDomainMesher()
    mesher.SetInputConnection(layout.GetOutputPort())
    print(pemesh.update(mesher, time=0.5).GetNumberOfCells())
"""

from . import _classes
from ._classes import *  # noqa: F401,F403
from ._meshes import (cell_data, connectivity, elements, mesh, point_data, points, read,
                      write)
from ._pipeline import Error, update
from ._studies import (Results, Solution, correlate, findings, metrics, run, solve, solve_all,
                       summary)
from ._tables import Table

__all__ = [
    "Error", "Results", "Solution", "Table", "cell_data", "connectivity", "correlate", "elements",
    "findings", "mesh", "metrics", "point_data", "points", "read", "run", "solve", "solve_all",
    "summary", "update", "write",
    *_classes.__all__,
]
