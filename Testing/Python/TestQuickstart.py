#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the pipeline of the quickstart filter by filter, and compares with `pemesh run`.

Arguments: source folder, build folder, folder for the output.
"""

import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys

import pemesh

SOURCE, BUILD, OUTPUT = (pathlib.Path(argument) for argument in sys.argv[1:4])


def make_layout(study):
    layout = pemesh.vtkPEMPolygonLayout()
    for polygon in study["polygons"]:
        index = layout.AddPolygon(polygon["family"], *polygon["center"])
        layout.SetPolygonScale(index, polygon["scale"])
        layout.SetPolygonRotation(index, polygon["rotation"])
        for count in ("teeth", "sides", "spikes"):
            if count in polygon:
                layout.SetPolygonParameter(index, count, polygon[count])
    sweep = study["sweep"][0]
    layout.SetFirstTime(sweep["from"])
    layout.SetLastTime(sweep["to"])
    layout.SetNumberOfTimes(sweep["count"])
    return layout


def make_mesher(study, layout):
    mesh = study["mesh"]
    mesher = pemesh.vtkPEMDomainMesher()
    mesher.SetInputConnection(layout.GetOutputPort())
    mesher.SetAreaRuleByName(mesh["max-area"]["rule"])
    mesher.SetMaximumArea(mesh["max-area"]["value"])
    mesher.SetMinimumAngle(mesh["min-angle"])
    mesher.SetPreservePolygons(mesh["preserve-polygons"])
    return mesher


def make_solver(run, source):
    description = json.loads((SOURCE / "Applications/Solvers/pemesh-vem.json").read_text())
    solver = pemesh.vtkPEMExternalSolver()
    solver.SetInputConnection(source.GetOutputPort())
    solver.SetRunName(run["name"])
    program, *arguments = description["command"]
    solver.SetCommand([str(BUILD / "bin" / program), *arguments])
    for option in description["options"]:
        solver.AddOption(option["name"], option["type"], str(option["default"]))
    for name in ("order", "problem"):
        solver.SetOption(name, str(run[name]))
    for performance in description["performances"]:
        solver.AddPerformance(
            performance["name"], performance.get("measured", False),
            performance.get("may-be-undefined", False))
    solver.SetWorkDirectory(str(OUTPUT / "python-solver"))
    return solver


def make_table(study):
    layout = make_layout(study)
    mesher = make_mesher(study, layout)
    metrics = pemesh.vtkPEMMetrics()
    metrics.SetInputConnection(mesher.GetOutputPort())
    solver = make_solver(study["solvers"][0], metrics)
    summary = pemesh.vtkPEMMetricSummary()
    summary.SetInputConnection(solver.GetOutputPort())
    series = pemesh.vtkPEMSeriesTable()
    series.SetInputConnection(summary.GetOutputPort())
    series.Update()
    return series.GetOutput()


def main():
    shutil.rmtree(OUTPUT, ignore_errors=True)
    OUTPUT.mkdir(parents=True)
    subprocess.run(
        [BUILD / "bin/pemesh", "run", SOURCE / "Data/Studies/quickstart.json",
         "-o", OUTPUT / "run", "--set", "plots=[]"], check=True)
    study = json.loads((OUTPUT / "run/study.json").read_text())
    with open(OUTPUT / "run/results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    table = make_table(study)
    assert table.GetNumberOfRows() == len(rows) == 20

    compared = 0
    for name in rows[0]:
        column = table.GetColumnByName(name)
        if name == "Mesh":  # the runner names meshes, the bare pipeline does not
            continue
        assert column is not None, name
        for index, row in enumerate(rows):
            value = column.GetValue(index)
            if isinstance(value, str):
                assert value == row[name], (name, index, value, row[name])
                continue
            expected = float(row[name])
            both_missing = math.isnan(expected) and math.isnan(value)
            assert both_missing or value == expected, (name, index, value, expected)
            compared += 1
    assert compared > 20 * 50, compared
    print(f"{compared} numbers are the same.")


main()
