# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep over meshes made with NumPy: the unit square in quadrilaterals, ever more sheared.

    sweep.py TABLE.csv
"""

import sys

import numpy

import pemesh


def sheared(shear, count=8):
    """(count x count) cells; the inner lines lean by `shear` of a cell, alternately."""
    x, y = numpy.meshgrid(numpy.arange(count + 1.0), numpy.arange(count + 1.0))
    inside = (x > 0) & (x < count) & (y > 0) & (y < count)
    x = x + numpy.where(inside, shear * (-1.0) ** y, 0.0)
    corner = (numpy.arange(count)[:, None] * (count + 1) + numpy.arange(count)).reshape(-1)
    cells = numpy.stack([corner, corner + 1, corner + count + 2, corner + count + 1], axis=1)
    return pemesh.mesh(numpy.stack([x.reshape(-1), y.reshape(-1)], axis=1) / count, cells)


rows = []
for shear in numpy.linspace(0.0, 0.45, 10):
    mesh = sheared(shear)
    rows.append({
        "shear": shear,
        "MinAngle_min": pemesh.metrics(mesh, ["MinAngle"])["MinAngle"].min(),
        **{f"vem_{name}": value for name, value in
           pemesh.solve(mesh, problem="franke").performances.items()},
    })
table = pemesh.Table({name: [row[name] for row in rows] for name in rows[0]})
table.write(sys.argv[1])
print(pemesh.findings(table, x=["MinAngle_min"], y=["vem_condition-number"]))
