# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A solver of your own as a function: which metric drives its condition number?

The solver lumps the mass: each vertex gets an equal share of the areas of its elements. The ratio of
the largest to the smallest entry of that diagonal matrix is its condition number.

    own_solver.py FOLDER
"""

import sys

import numpy

import pemesh


def lumped_mass(mesh):
    """A solver gets a mesh; it answers arrays at the vertices or elements, and single numbers."""
    area = pemesh.metrics(mesh, ["Area"])["Area"]
    indices, offsets = pemesh.connectivity(mesh)
    share = numpy.repeat(area / numpy.diff(offsets), numpy.diff(offsets))
    mass = numpy.bincount(indices, weights=share, minlength=mesh.GetNumberOfPoints())
    return {"mass": mass, "condition": mass.max() / mass.min()}


study = {
    "pemesh": 1,
    "name": "own-solver",
    "polygons": [{"family": "star", "center": [0.5, 0.5]}],
    "sweep": [{"parameter": "t", "from": 0, "to": 0.8, "count": 8}],
}
results = pemesh.run(study, sys.argv[1])
table = results.table.join(pemesh.solve_all(results.meshes(), lumped_mass))
table.write(results.folder / "with-own-solver.csv")
print(pemesh.findings(table, y=["lumped_mass_condition"]))
