# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The layer above the filters: arrays, tables, exceptions.

    TestLayer.py SOURCE_FOLDER BUILD_FOLDER SCRATCH_FOLDER
"""

import ast
import gc
import math
import os
import pathlib
import shutil
import sys
import unittest

import numpy

import pemesh

SCRATCH = pathlib.Path(sys.argv.pop())
BUILD = pathlib.Path(sys.argv.pop())
SOURCE = pathlib.Path(sys.argv.pop())

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]


def grid(count):
    x, y = numpy.meshgrid(numpy.linspace(0, 1, count + 1), numpy.linspace(0, 1, count + 1))
    corner = (numpy.arange(count)[:, None] * (count + 1) + numpy.arange(count)).reshape(-1)
    cells = numpy.stack([corner, corner + 1, corner + count + 2, corner + count + 1], axis=1)
    return pemesh.mesh(numpy.stack([x.reshape(-1), y.reshape(-1)], axis=1), cells)


class Meshes(unittest.TestCase):
    def test_every_form_of_the_elements_is_the_same_mesh(self):
        for elements in ([[0, 1, 2], [0, 2, 3]], numpy.array([[0, 1, 2], [0, 2, 3]]),
                         ((0, 1, 2), numpy.array([0, 2, 3], dtype=numpy.int32))):
            mesh = pemesh.mesh(SQUARE, elements)
            self.assertEqual([list(one) for one in pemesh.elements(mesh)], [[0, 1, 2], [0, 2, 3]])
            self.assertEqual(pemesh.points(mesh).tolist(), [[x, y, 0] for x, y in SQUARE])

    def test_points_are_shared_and_arrays_outlive_their_names(self):
        points = numpy.array([[x, y, 0.0] for x, y in SQUARE])
        mesh = pemesh.mesh(points, numpy.array([0, 1, 2, 3]), numpy.array([0, 4]))
        self.assertTrue(numpy.shares_memory(pemesh.points(mesh), points))
        self.assertTrue(numpy.shares_memory(
            pemesh.connectivity(mesh)[0], pemesh.elements(mesh)[0]))
        copy = mesh.NewInstance()
        copy.ShallowCopy(mesh)
        del points, mesh
        gc.collect()
        junk = [numpy.full(size, 7) for size in (2, 4, 12) for _ in range(1000)]
        self.assertEqual(pemesh.metrics(copy, ["Area"])["Area"].tolist(), [1.0])
        self.assertEqual(len(junk), 3000)

    def test_an_empty_mesh_has_empty_arrays(self):
        mesh = pemesh.mesh(numpy.zeros((0, 2)), [])
        self.assertEqual(pemesh.points(mesh).shape, (0, 3))
        self.assertEqual(pemesh.elements(mesh), [])

    def test_wrong_arrays_are_named(self):
        for arguments, words in (
                ((SQUARE, [[0, 1]]), "element 0 has fewer than three"),
                ((SQUARE, [[0, 1, 2], [0, 2, 9]]), "element 1 names the point 9"),
                ((SQUARE, [[0, 1, -1]]), "element 0 names the point -1"),
                (([1, 2, 3], []), "(3,)"),
                ((SQUARE, [0, 1, 2], [0, 2]), "offsets must grow"),
                ((SQUARE, [0, 1, 2], []), "offsets begins with 0")):
            with self.assertRaises(pemesh.Error) as caught:
                pemesh.mesh(*arguments)
            self.assertIn(words, str(caught.exception))

    def test_files_keep_points_to_the_bit(self):
        points = numpy.array([[0.1, 1 / 3], [math.pi, 1e-9], [2 / 7, 1e9]])
        for ending in ("off", "vtp", "obj"):
            path = SCRATCH / f"triangle.{ending}"
            pemesh.write(pemesh.mesh(points, [[0, 1, 2]]), path)
            self.assertEqual(pemesh.points(pemesh.read(path))[:, :2].tolist(), points.tolist())

    def test_wrong_files_are_named(self):
        with self.assertRaises(pemesh.Error) as caught:
            pemesh.read(SCRATCH / "there-is-none.off")
        self.assertIn("there-is-none.off", str(caught.exception))
        self.assertEqual(caught.exception.status, "unreadable-mesh")
        (SCRATCH / "file").write_text("")
        with self.assertRaises(pemesh.Error) as caught:
            pemesh.write(pemesh.mesh(SQUARE, [[0, 1, 2]]), SCRATCH / "file" / "mesh.off")
        self.assertIn("file", str(caught.exception))


class Steps(unittest.TestCase):
    def test_metrics_of_a_square(self):
        table = pemesh.metrics(pemesh.mesh(SQUARE, [[0, 1, 2, 3]]))
        self.assertEqual(table.rows, 1)
        self.assertEqual(list(table), list(pemesh.vtkPEMMetrics.GetAvailableMetrics()))
        self.assertEqual(table["Area"][0], 1.0)
        self.assertAlmostEqual(table["MinAngle"][0], math.pi / 2, 15)
        with self.assertRaises(KeyError) as caught:
            table["Aera"]
        self.assertIn("Area", str(caught.exception))
        with self.assertRaises(pemesh.Error) as caught:
            pemesh.metrics(pemesh.mesh(SQUARE, [[0, 1, 2, 3]]), ["Aera"])
        self.assertIn('"Area"', str(caught.exception))

    def test_the_summary_is_that_of_the_elements(self):
        mesh = pemesh.mesh(SQUARE, [[0, 1, 2], [0, 2, 3]])
        row = pemesh.summary(mesh, ["Area", "MinAngle"], ["min", "mean"])
        self.assertEqual((row["Elements"], row["TotalArea"], row["Area_mean"]), (2, 1.0, 0.5))
        self.assertAlmostEqual(row["MinAngle_min"], math.pi / 4, 15)

    def test_a_linear_solution_is_exact(self):
        mesh = grid(4)
        solution = pemesh.solve(mesh, order=2, problem="linear")
        self.assertLess(solution.performances["relative-error-l2"], 1e-12)
        fields = pemesh.point_data(solution.mesh)
        self.assertLess(numpy.abs(fields["Solution"] - fields["GroundTruth"]).max(), 1e-12)
        self.assertEqual(pemesh.point_data(mesh), {})  # the mesh itself is left alone
        again = pemesh.solve(solution.mesh, order=1, problem="linear")
        self.assertEqual(again.performances["dofs"], 9)

    def test_what_cannot_be_solved_is_told(self):
        for options, words in (({"problem": "frank"}, "frank"), ({"nonsense": 1}, "nonsense")):
            with self.assertRaises(pemesh.Error) as caught:
                pemesh.solve(grid(2), **options)
            self.assertIn(words, str(caught.exception))

    def test_a_function_is_a_solver(self):
        def answer(mesh, factor=1):
            return {"u": factor * pemesh.points(mesh)[:, 0], "e": numpy.arange(4), "cost": factor}

        solution = pemesh.solve(grid(2), answer, factor=3)
        self.assertEqual(solution.performances, {"cost": 3.0})
        self.assertEqual(pemesh.point_data(solution.mesh)["u"].max(), 3.0)
        self.assertEqual(pemesh.cell_data(solution.mesh)["e"].tolist(), [0, 1, 2, 3])
        with self.assertRaises(pemesh.Error) as caught:
            pemesh.solve(grid(2), lambda mesh: {"u": [1, 2]})
        self.assertIn("2 values named 'u'", str(caught.exception))

    def test_one_mesh_that_cannot_be_solved_does_not_take_the_others(self):
        def moody(mesh):
            if mesh.GetNumberOfCells() == 4:
                raise pemesh.Error("not this one")
            return {"cells": mesh.GetNumberOfCells()}

        table = pemesh.solve_all([("a", grid(1)), ("b", grid(2)), ("c", grid(3))], moody)
        self.assertEqual(table["moody_Status"].tolist(), ["ok", "not this one", "ok"])
        numpy.testing.assert_array_equal(table["moody_cells"], [1, numpy.nan, 9])

    def test_correlations_of_a_known_order(self):
        x = numpy.arange(1.0, 9.0)
        table = pemesh.Table({"A_min": x, "run_b": x ** -2, "run_c": [3, 3, 3, 3, 3, 3, 3, 3.]})
        pairs = pemesh.correlate(table, ["A_min"], ["run_b", "run_c"])
        self.assertEqual(pairs["Spearman"][0], -1.0)
        self.assertTrue(math.isnan(pairs["Spearman"][1]))
        self.assertEqual((pairs["Form"][0], round(pairs["FormParameter"][0], 12)), ("power-law", -2.0))
        self.assertIn("A_min", pemesh.findings(table, ["A_min"], ["run_b"]))
        for arguments in ((["B"],), (None, None)):
            with self.assertRaises(pemesh.Error):
                pemesh.correlate(table, *arguments, coefficient="spearmen")

    def test_an_error_upstream_is_raised(self):
        layout = pemesh.vtkPEMPolygonLayout()
        layout.AddPolygon("star", 0.5, 0.5)
        layout.SetPolygonScale(0, 9.0)
        mesher = pemesh.vtkPEMDomainMesher()
        mesher.SetInputConnection(layout.GetOutputPort())
        metrics = pemesh.vtkPEMMetrics()
        metrics.SetInputConnection(mesher.GetOutputPort())
        with self.assertRaises(pemesh.Error) as caught:
            pemesh.update(metrics)
        self.assertEqual(caught.exception.status, "invalid-layout")


class Tables(unittest.TestCase):
    def test_a_file_gives_back_the_bits(self):
        table = pemesh.Table({"Mesh": ["a, b", "001_0.5"], "x": [0.1, math.nan], "n": [1, 2],
                              "t": ["", 'a "b"']})
        table.write(SCRATCH / "table.csv")
        again = pemesh.Table.read(SCRATCH / "table.csv")
        self.assertEqual(list(again), list(table))
        for name in table:
            numpy.testing.assert_array_equal(again[name], table[name])
        self.assertEqual(again["n"].dtype, numpy.int64)

    def test_rows_of_different_length_are_named(self):
        (SCRATCH / "short.csv").write_text("a,b\n1,2\n3\n")
        with self.assertRaises(pemesh.Error) as caught:
            pemesh.Table.read(SCRATCH / "short.csv")
        self.assertIn("line 3", str(caught.exception))
        with self.assertRaises(pemesh.Error):
            pemesh.Table({"a": [1], "b": [1, 2]})

    def test_what_is_no_number_stays_a_text(self):
        (SCRATCH / "codes.csv").write_text("code,empty,name\n007,,1_0\n008,,2_0\n")
        table = pemesh.Table.read(SCRATCH / "codes.csv")
        self.assertEqual({name: values.tolist() for name, values in table.items()},
                         {"code": ["007", "008"], "empty": ["", ""], "name": ["1_0", "2_0"]})

    def test_joining_finds_rows_by_name(self):
        left = pemesh.Table({"Mesh": ["a", "b", "c"], "x": [1, 2, 3]})
        right = pemesh.Table({"Mesh": ["c", "a"], "y": [30.0, 10.0], "s": ["C", "A"]})
        both = left.join(right)
        numpy.testing.assert_array_equal(both["y"], [10, numpy.nan, 30])
        self.assertEqual(both["s"].tolist(), ["A", "", "C"])

    def test_a_table_goes_to_the_filters_and_back(self):
        table = pemesh.Table({"Mesh": ["a", "b"], "x": [0.1, 0.2], "n": [1, 2]})
        again = pemesh.Table(table.to_vtk())
        for name in table:
            self.assertEqual(again[name].tolist(), table[name].tolist())


class Studies(unittest.TestCase):
    STUDY = {"pemesh": 1, "name": "small",
             "polygons": [{"family": "star", "center": [0.5, 0.5]}],
             "sweep": [{"parameter": "t", "from": 0, "to": 0.5, "count": 3}]}

    def test_a_run_tells_how_far_it_is_and_its_results_can_be_read(self):
        fractions, sentences = [], []
        results = pemesh.run(self.STUDY, SCRATCH / "run", jobs=1, progress=fractions.append,
                             log=sentences.append, settings={"sweep.0.count": 4})
        self.assertEqual(results.table.rows, 4)
        self.assertEqual(results.failures, [])
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1.0)
        self.assertEqual(len(sentences), 4)
        self.assertEqual([name for name, _ in results.meshes()], list(results.table["Mesh"]))
        areas = pemesh.metrics(results.mesh(2), ["Area"])["Area"]
        self.assertEqual(areas.min(), results.table["Area_min"][2])
        self.assertEqual(results.correlation["X"][0][-4:], "_min")
        again = pemesh.Results(SCRATCH / "run")
        self.assertEqual(again.findings, results.findings)

    def test_failures_are_told_by_the_folder_too(self):
        study = {**self.STUDY, "polygons": [{"family": "star", "center": [0.5, 0.5], "scale": 9}]}
        results = pemesh.run(study, SCRATCH / "failing")
        self.assertEqual(len(results.failures), 3)
        self.assertEqual(pemesh.Results(SCRATCH / "failing").failures, results.failures)

    def test_a_study_that_is_wrong_is_refused(self):
        with self.assertRaises(pemesh.Error) as caught:
            pemesh.run({"pemesh": 1, "nam": "x"})
        self.assertIn("name", str(caught.exception))
        self.assertEqual(caught.exception.status, "refused")

    def test_what_a_callback_raises_ends_the_run_and_keeps_what_is_done(self):
        for kind in (ValueError, KeyboardInterrupt):
            def stop(fraction, kind=kind):
                if fraction > 0.2:
                    raise kind("enough")

            with self.assertRaises(kind):
                pemesh.run(self.STUDY, SCRATCH / "stopped", jobs=1, progress=stop,
                           settings={"sweep.0.count": 50})
            self.assertLess(pemesh.Results(SCRATCH / "stopped").table.rows, 51)
        done = pemesh.run(self.STUDY, SCRATCH / "stopped", resume=True,
                          settings={"sweep.0.count": 50})
        self.assertEqual(done.table.rows, 50)


class Types(unittest.TestCase):
    def test_the_types_name_every_method(self):
        stubs = pathlib.Path(pemesh.__file__).with_name("_classes.pyi")
        tree = ast.parse(stubs.read_text())
        classes = {node.name: {part.name for part in node.body
                               if isinstance(part, ast.FunctionDef)}
                   for node in tree.body if isinstance(node, ast.ClassDef)}
        for name in (name for name in pemesh.__all__ if name.startswith("vtkPEM")):
            methods = {key for key, value in vars(getattr(pemesh, name)).items()
                       if callable(value) and not key.startswith("_")
                       and not isinstance(value, type)}
            self.assertEqual(methods - classes[name], set(), name)

    def test_everything_public_says_what_it_is(self):
        for name in pemesh.__all__:
            self.assertTrue(getattr(pemesh, name).__doc__.strip(), name)


if __name__ == "__main__":
    shutil.rmtree(SCRATCH, ignore_errors=True)
    os.makedirs(SCRATCH)
    os.chdir(SCRATCH)
    unittest.main(verbosity=0)
