# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the plugin into ParaView, runs a pipeline, makes a picture, saves the state, loads it again.

    pvbatch check_plugin.py PEMesh.so STUDY.json PICTURE.png
"""

import math
import pathlib
import sys

from paraview import make_name_valid, servermanager, simple

simple.LoadPlugin(sys.argv[1], ns=globals())
study_file, picture = sys.argv[2:4]
states = pathlib.Path(picture).with_suffix(".pvsm")


def make(group, name, **properties):
    """A source or filter of the plugin by the name of its proxy, in the pipeline browser."""
    prototype = servermanager.ProxyManager().GetPrototypeProxy(group, name)
    assert prototype, f"the plugin has no {name}"
    return globals()[make_name_valid(prototype.GetXMLLabel())](**properties)


def mesh_of(proxy, time=None):
    proxy.UpdatePipeline(*([] if time is None else [time]))
    return servermanager.Fetch(proxy)


def total_area(mesh):
    area = mesh.GetCellData().GetArray("Area")
    return math.fsum(area.GetValue(i) for i in range(area.GetNumberOfTuples()))


# Layout, mesher, mirror, agglomeration, metrics: at several times.
layout = make("sources", "PEMeshPolygonLayout")
layout.Polygons = ["comb", "0.3", "0.3", "0.8", "20", "star", "0.7", "0.7", "0.6", "0"]
layout.NumberOfTimes = 5
layout.UpdatePipelineInformation()
times = list(layout.TimestepValues)
assert len(times) == 5 and times[0] == 0.0 and times[-1] == 0.9, times
mesher = make("filters", "PEMeshDomainMesher", Input=layout)
mesher.AreaRule = "Constant"
mesher.MaximumArea = 0.002
mirror = make("filters", "PEMeshMirror", Input=mesher)
merged = make("filters", "PEMeshQualityAgglomeration", Input=mirror)
merged.TargetPercentage = 30
measured = make("filters", "PEMeshMetrics", Input=merged)
measured.Metrics = ["Area", "KernelAreaRatio", "MinAngle"]
sizes = []
for time in times:
    placed = mesh_of(layout, time)
    assert placed.GetNumberOfCells() == 2, placed.GetNumberOfCells()
    plain, coarse = mesh_of(mirror, time), mesh_of(measured, time)
    assert coarse.GetNumberOfCells() < 0.4 * plain.GetNumberOfCells()
    assert abs(total_area(coarse) - 1.0) < 1e-12, total_area(coarse)
    assert coarse.GetCellData().GetNumberOfArrays() == 5, "two of provenance and three metrics"
    sizes.append(coarse.GetNumberOfCells())
assert len(set(sizes)) > 1, "the mesh does not follow the time"

# Everything else that there is.
check = make("filters", "PEMeshCheck", Input=measured)
check.UpdatePipeline(times[0])
assert servermanager.Fetch(check, idx=1).GetNumberOfCells() == 0, "elements with faults"
solved = make("filters", "PEMeshVirtualElementSolver", Input=measured)
solved.Problem = "franke"
error = mesh_of(solved, times[1]).GetFieldData().GetArray("relative-error-l2").GetValue(0)
assert 0.0 < error < 0.1, error
table = make("filters", "PEMeshSeriesTable", Input=make("filters", "PEMeshMetricSummary",
                                                        Input=measured))
table.UpdatePipeline()
rows = servermanager.Fetch(table)
assert [rows.GetColumnByName("Elements").GetValue(i) for i in range(len(times))] == sizes
star = make("sources", "PEMeshStarPolygon")
star.Spikes = 7
assert mesh_of(star, 0.9).GetNumberOfPoints() == 14, mesh_of(star, 0.9).GetNumberOfPoints()
disc = make("sources", "PEMeshDiscDomain")
cells = make("filters", "PEMeshVoronoiMeshOfDomain", Input=disc)
assert mesh_of(cells).GetNumberOfCells() > 10
study = make("sources", "PEMeshStudy", FileName=study_file)
study.UpdatePipelineInformation()
assert len(study.TimestepValues) == 20
assert mesh_of(study, study.TimestepValues[-1]).GetNumberOfCells() > 100
worst = make("filters", "PEMeshSelectElements", Input=measured)
worst.Metric, worst.Mode, worst.Count = "MinAngle", "Worst", 5
assert mesh_of(worst, times[1]).GetNumberOfCells() == 5

# A round trip through a file, by the names that ParaView goes by.
file = str(pathlib.Path(picture).with_suffix(".off"))
merged.UpdatePipeline(times[0])
simple.SaveData(file, proxy=merged)
again = simple.OpenDataFile(file)
assert again.GetXMLName() == "PEMeshReader", again.GetXMLName()
assert mesh_of(again).GetNumberOfCells() == sizes[0]

# Wrong values are refused where the range says so.
mirror_range = mirror.GetProperty("NumberOfTimes").GetDomain("range")
assert (mirror_range.GetMinimum(0), mirror_range.GetMaximum(0)) == (0, 14)

# The picture: concave elements are drawn right once they are triangulated.
view = simple.CreateRenderView(ViewSize=[900, 900])
view.InteractionMode = "2D"
view.ViewTime = times[-1]
triangles = make("filters", "PEMeshTriangulate", Input=measured)
shown = simple.Show(triangles, view)
simple.ColorBy(shown, ("CELLS", "KernelAreaRatio"))
shown.RescaleTransferFunctionToDataRange(False)
edges = simple.ExtractEdges(Input=measured)
simple.Show(edges, view).DiffuseColor = [0.1, 0.1, 0.1]
view.ResetCamera()
simple.SaveScreenshot(picture, view)

# The state comes back: proxies, their values, and the mesh.
simple.SaveState(str(states))
simple.ResetSession()
simple.LoadState(str(states))
found = {proxy.GetXMLName(): proxy for proxy in simple.GetSources().values()}
assert list(found["PEMeshPolygonLayout"].Polygons)[:2] == ["comb", "0.3"]
assert found["PEMeshQualityAgglomeration"].TargetPercentage == 30
assert list(found["PEMeshMetrics"].Metrics) == ["Area", "KernelAreaRatio", "MinAngle"]
for time, size in zip(times, sizes):
    assert mesh_of(found["PEMeshMetrics"], time).GetNumberOfCells() == size
print(f"{len(found)} objects of a saved state, {sizes} elements: as before.")
