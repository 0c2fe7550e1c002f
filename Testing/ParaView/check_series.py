# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the results of a study in ParaView, and compares what it sees with the tables.

    pvbatch check_series.py FOLDER PICTURE.png
"""

import csv
import math
import pathlib
import sys

from paraview import servermanager, simple

folder = pathlib.Path(sys.argv[1])
with open(folder / "results.csv", newline="") as file:
    rows = list(csv.DictReader(file))

series = simple.PVDReader(FileName=str(folder / "series.pvd"))
times = list(series.TimestepValues)
assert len(times) == len(rows), (len(times), len(rows))
for time, row in zip(times, rows):
    assert math.isclose(time, float(row["t"]), abs_tol=1e-15), (time, row["t"])
    series.UpdatePipeline(time)
    mesh = servermanager.Fetch(series)
    mesh = mesh.GetBlock(0) if mesh.IsA("vtkMultiBlockDataSet") else mesh
    assert mesh.GetNumberOfCells() == int(row["Elements"]), time
    for metric in ("Area", "MinAngle", "KernelAreaRatio"):
        low, high = mesh.GetCellData().GetArray(metric).GetRange()
        assert low == float(row[metric + "_min"]), (time, metric, low, row[metric + "_min"])
        assert high == float(row[metric + "_max"]), (time, metric, high, row[metric + "_max"])
    assert mesh.GetPointData().GetArray("pemesh-vem_Solution").GetNumberOfTuples() == int(
        row["Vertices"])

# Concave elements are drawn right once they are triangulated, as the README says.
surface = simple.ExtractSurface(Input=series)
triangles = simple.Triangulate(Input=surface)
triangles.UpdatePipeline(times[-1])
drawn = servermanager.Fetch(triangles)
area = simple.CellSize(Input=triangles)
area.UpdatePipeline(times[-1])
sizes = servermanager.Fetch(area).GetCellData().GetArray("Area")
total = math.fsum(sizes.GetValue(i) for i in range(sizes.GetNumberOfTuples()))
assert math.isclose(total, float(rows[-1]["TotalArea"]), rel_tol=1e-12), total

view = simple.CreateRenderView(ViewSize=[900, 900])
view.ViewTime = times[-1]
shown = simple.Show(triangles, view)
simple.ColorBy(shown, ("CELLS", "MinAngle"))
shown.RescaleTransferFunctionToDataRange(False)
edges = simple.ExtractEdges(Input=series)
simple.Show(edges, view).DiffuseColor = [0.2, 0.2, 0.2]
view.ResetCamera()
simple.SaveScreenshot(sys.argv[2], view)
print(f"{len(rows)} meshes, {drawn.GetNumberOfCells()} triangles of the last: as in results.csv.")
