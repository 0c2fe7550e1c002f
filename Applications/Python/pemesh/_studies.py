# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole steps of a study, each one call."""

import collections.abc
import contextlib
import dataclasses
import json
import os
import pathlib

import numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkConstants import VTK_DOUBLE, VTK_STRING
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._classes import (vtkPEMCorrelation, vtkPEMFindings, vtkPEMMetrics, vtkPEMMetricSummary,
                       vtkPEMRunner, vtkPEMVirtualElementSolver)
from ._meshes import cell_data, read
from ._pipeline import Error, raise_if_failed, raising, update
from ._tables import Table


class Results:
    """What a run of a study has left in its folder.

    folder : pathlib.Path
    table : Table, one row a mesh: parameters, sizes, metrics, performances, status
    timings : Table, one row a mesh: what depends on the machine
    correlation : Table, one row a pair of columns
    failures : list of str, one sentence a failure; empty where all went well
    """

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.table = Table.read(self.folder / "results.csv")

    @property
    def failures(self):
        file = self.folder / "failures.csv"
        return Table.read(file)["Message"].tolist() if file.exists() else []

    @property
    def timings(self):
        return Table.read(self.folder / "timings.csv")

    @property
    def correlation(self):
        return Table.read(self.folder / "correlation.csv")

    @property
    def findings(self):
        """For each performance the metrics that go with it, in sentences."""
        return (self.folder / "findings.txt").read_text(encoding="utf-8")

    def mesh(self, which):
        """The mesh of that row, by its number or name, with all its arrays."""
        name = which if isinstance(which, str) else self.table["Mesh"][which]
        return read(self.folder / "meshes" / f"{name}.vtp")

    def meshes(self):
        """All meshes that were made, as pairs of name and mesh, one in memory at a time."""
        for name in self.table["Mesh"]:
            if (self.folder / "meshes" / f"{name}.vtp").exists():
                yield name, self.mesh(name)

    def __repr__(self):
        return (f"<pemesh.Results: {self.table.rows} meshes in {str(self.folder)!r}, "
                f"{len(self.failures)} failures>")


def run(study, output=None, *, jobs=0, resume=False, retries=0, settings=None, progress=None,
        log=None):
    """Runs a study: meshes, metrics, solvers, plots and tables, into a folder.

    Parameters
    ----------
    study : path or dict
        The document, as a file or as the values that its JSON has.
    output : path, optional
        Folder for the results. Default: the name of the study, in the current folder.
    jobs : int
        Meshes worked on at the same time; 0 for one a core.
    resume : bool
        Whether what the folder holds and has not changed is taken as it is.
    retries : int
        How often a solver is tried again on a mesh where it has failed.
    settings : dict, optional
        Changes of the study by path: ``{"mesh.min-angle": 25}``.
    progress : callable, optional
        Called with the fraction done, in [0, 1].
    log : callable, optional
        Called with a sentence for each mesh that is done.

    Returns
    -------
    Results
        Failures of single meshes or solvers are in its `failures`; the rest is done and saved.

    Raises
    ------
    Error
        The study cannot be run at all; nothing was done.
    KeyboardInterrupt
        after Ctrl-C, once what was done is saved.
    """
    runner = vtkPEMRunner()
    if isinstance(study, collections.abc.Mapping):
        runner.SetStudyText(json.dumps(study), os.getcwd())
    else:
        runner.SetStudyFile(os.fspath(study))
    if output is not None:
        runner.SetOutputDirectory(os.fspath(output))
    runner.SetNumberOfWorkers(jobs)
    runner.SetResume(resume)
    runner.SetRetries(retries)
    for path, value in (settings or {}).items():
        runner.AddSetting(f"{path}={json.dumps(value)}")
    with raising(runner), _watched(runner, progress, log):
        runner.Run()
    if runner.GetRefused():
        raise Error("\n".join(runner.GetMessages()), "refused")
    return Results(runner.GetOutputDirectory())


@contextlib.contextmanager
def _watched(runner, progress, log):
    """Observes; what a callback raises, Ctrl-C too, stops the run and is raised at its end."""
    raised = []

    def guarded(function):
        try:
            if not raised:
                function()
        except BaseException as error:  # noqa: B902: it is raised again after the run
            raised.append(error)
            runner.RequestStop()

    @calldata_type(VTK_DOUBLE)
    def on_progress(_caller, _event, fraction):
        guarded(lambda: progress and progress(fraction))

    @calldata_type(VTK_STRING)
    def on_log(_caller, _event, text):
        guarded(lambda: log and log(text))

    tags = [runner.AddObserver("ProgressEvent", on_progress),
            runner.AddObserver(vtkPEMRunner.LogEvent, on_log)]
    try:
        yield
    finally:
        for tag in tags:
            runner.RemoveObserver(tag)
    if raised:
        raise raised[0]


def metrics(mesh, names=None):
    """Measures every element of a mesh.

    Parameters
    ----------
    mesh : vtkPolyData or path
    names : sequence of str, optional
        Metrics by name, or words that stand for several: "all" (the default), "neighbourhood",
        "jumps", "solver".

    Returns
    -------
    Table
        One row an element and one column a metric, float64, NaN where undefined; the columns are
        views of the arrays. `pemesh list metrics` tells the formula, range and unit of each: lengths
        are in the unit of the mesh, angles in radians.
    """
    data = mesh if isinstance(mesh, vtkPolyData) else read(mesh)
    measure = vtkPEMMetrics()
    with raising(measure):
        measure.SetMetrics(["all"] if names is None else list(names))
    measure.SetInputData(data)
    values = cell_data(update(measure))
    return Table({name: values[name] for name in measure.GetMetrics()})


def summary(mesh, names=None, statistics=None):
    """Measures a mesh as a whole: sizes, and statistics of each metric over its elements.

    Parameters
    ----------
    mesh : vtkPolyData or path
    names : sequence of str, optional
        As for metrics().
    statistics : sequence of str, optional
        Such as "min", "max", "mean", "deviation"; by default those of a results table.

    Returns
    -------
    dict
        from the names of a results table ("MinAngle_min") to numbers and texts.
    """
    data = mesh if isinstance(mesh, vtkPolyData) else read(mesh)
    measure = vtkPEMMetrics()
    whole = vtkPEMMetricSummary()
    with raising(measure, whole):
        for filter_ in (measure, whole) if names is not None else ():
            filter_.SetMetrics(list(names))
        if statistics is not None:
            whole.SetStatistics(list(statistics))
    measure.SetInputData(data)
    whole.SetInputConnection(measure.GetOutputPort())
    return {name: values.tolist()[0] for name, values in Table(update(whole)).items()}


@dataclasses.dataclass
class Solution:
    """The answer of a solver on a mesh.

    mesh : vtkPolyData, with the solution and what else the solver tells of points and elements
    performances : dict from names to numbers, NaN where undefined
    """

    mesh: vtkPolyData
    performances: dict


def solve(mesh, solver=None, **options):
    """Solves a PDE on a mesh.

    Parameters
    ----------
    mesh : vtkPolyData or path
    solver : callable, optional
        By default the bundled virtual element method. Else a function of yours: it is called with
        the mesh and the options, and returns a mapping of results: arrays of one number a vertex
        (they become point data) or an element (cell data; under any other length an Error), and
        single numbers, the performances.
    **options
        For the bundled method `order` (1 to 6), `problem`, `basis`, `stabilisation` and so on, with
        _ in place of -: those of `pemesh-vem --help`.

    Returns
    -------
    Solution

    Raises
    ------
    Error
        The mesh cannot be solved on, or an option is unknown.
    """
    data = mesh if isinstance(mesh, vtkPolyData) else read(mesh)
    return _solve_here(data, options) if solver is None else _solve_with(solver, data, options)


def _solve_here(data, options):
    solver = vtkPEMVirtualElementSolver()
    solver.SetRunName("")
    with raising(solver):
        for name, value in options.items():
            if name == "order":
                solver.SetOrder(int(value))
            else:
                solver.SetOption(name.replace("_", "-"), str(value))
    solver.SetInputData(data)
    solved = update(solver)
    raise_if_failed(solved, "Solver")
    before, after = data.GetFieldData(), solved.GetFieldData()
    performances = {}
    for i in range(after.GetNumberOfArrays()):
        array = after.GetArray(i)
        if isinstance(array, vtkDoubleArray) and before.GetArray(array.GetName()) is not array:
            performances[array.GetName()] = array.GetValue(0)
    return Solution(solved, performances)


def _solve_with(function, data, options):
    solved = vtkPolyData()
    solved.ShallowCopy(data)
    performances = {}
    for name, value in function(data, **options).items():
        values = numpy.asarray(value, dtype=numpy.float64)
        if values.ndim == 0:
            performances[name] = float(values)
            continue
        array = numpy_to_vtk(numpy.ascontiguousarray(values))
        array.SetName(name)
        if len(values) == data.GetNumberOfPoints():
            solved.GetPointData().AddArray(array)
        elif len(values) == data.GetNumberOfCells():
            solved.GetCellData().AddArray(array)
        else:
            raise Error(f"the solver answered {len(values)} values named {name!r}, but the mesh has "
                        f"{data.GetNumberOfPoints()} vertices and {data.GetNumberOfCells()} elements")
    return Solution(solved, performances)


def solve_all(meshes, solver=None, name=None, **options):
    """Solves on many meshes, one in memory at a time.

    Parameters
    ----------
    meshes : iterable of pairs (name, mesh), or of paths
        Such as ``results.meshes()``.
    solver, **options
        As for solve().
    name : str, optional
        What the columns begin with. Default: the name of the function, or "vem".

    Returns
    -------
    Table
        One row a mesh: `Mesh`, ``<name>_<performance>`` and ``<name>_Status``, which is "ok" or says
        why the mesh could not be solved on; its numbers are NaN then. To be joined:
        ``results.table.join(pemesh.solve_all(results.meshes(), function))``.
    """
    prefix = name or (getattr(solver, "__name__", "solver") if solver else "vem")
    rows = []
    for item in meshes:
        mesh_name, mesh = (pathlib.Path(item).stem, item) if isinstance(
            item, (str, os.PathLike)) else item
        try:
            found, status = solve(mesh, solver, **options).performances, "ok"
        except Error as error:
            found, status = {}, str(error)
        rows.append((mesh_name, status, found))
    columns = {"Mesh": numpy.array([row[0] for row in rows], dtype=object)}
    for performance in dict.fromkeys(key for row in rows for key in row[2]):
        columns[f"{prefix}_{performance}"] = numpy.array(
            [row[2].get(performance, numpy.nan) for row in rows])
    columns[f"{prefix}_Status"] = numpy.array([row[1] for row in rows], dtype=object)
    return Table(columns)


def _as_table(table):
    if isinstance(table, Results):
        return table.table
    if isinstance(table, (str, os.PathLike)):
        return Table.read(table)
    return table if isinstance(table, Table) else Table(table)


def _correlation(data, x=None, y=None, *, given=(), coefficient="spearman", family=None,
                 independent_rows=False, bootstrap=None):
    correlation = vtkPEMCorrelation()
    correlation.SetXColumns(list(x or ()))
    correlation.SetYColumns(list(y or ()))
    correlation.SetGivenColumns(list(given))
    correlation.SetCoefficient(coefficient)
    correlation.SetFamilyColumn(family or "")
    correlation.SetIndependentRows(independent_rows)
    if bootstrap is not None:
        correlation.SetBootstrap(bootstrap)
    correlation.SetInputData(data)
    return correlation


def correlate(table, x=None, y=None, **options):
    """Correlates the columns of a table of meshes.

    Parameters
    ----------
    table : Results, Table, vtkTable, mapping, or path of a CSV file
        One row a mesh.
    x, y : sequences of str, optional
        Columns. Default: x the metrics, y the metrics and the performances.
    given : sequence of str, optional
        Columns held fixed: the tested coefficient is partial.
    coefficient : "spearman" (the default), "pearson", "kendall" or "distance"
        What p-values, intervals and words go by.
    family : str, optional
        Column whose values tell families of meshes apart; whole families are permuted.
    independent_rows : bool, optional
        Whether the meshes are a sample, each a family of its own.
    bootstrap : int, optional
        Number of samples for the intervals.

    Returns
    -------
    Table
        One row a pair: X, Y, N, Pearson, Spearman, Kendall, DistanceCorrelation, ..., Words.
    """
    return Table(update(_correlation(_as_table(table).to_vtk(), x, y, **options)))


def findings(table, x=None, y=None, **options):
    """For each performance the metrics that go with it, best first, in sentences.

    Takes what correlate() takes, and returns a str.
    """
    data = _as_table(table).to_vtk()
    correlation = _correlation(data, x, y, **options)  # an output port does not keep its filter
    ranking = vtkPEMFindings()
    ranking.SetInputConnection(0, correlation.GetOutputPort())
    ranking.SetInputData(1, data)
    update(ranking)
    return ranking.GetText()
