#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A solver to copy from: -Laplace u = 1 with u = (1 - x^2 - y^2) / 4 on the boundary.

The lowest-order virtual element method of Beirao da Veiga et al., "The Hitchhiker's Guide to the
Virtual Element Method" (2014), on the polygons of an OFF file; NumPy is all it needs.

    python-vem.py LIST

LIST names a mesh file a line; the results of D/M.off go to D/M-solution.txt and so on.
"""
import sys

import numpy as np


def read_off(path):
    words = open(path).read().split()
    vertices, elements = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * vertices], float).reshape(-1, 3)[:, :2]
    at, polygons = 4 + 3 * vertices, []
    for _ in range(elements):
        sides = int(words[at])
        polygons.append(np.array(words[at + 1:at + 1 + sides], int))
        at += 1 + sides
    return points, polygons


def exact(points):
    return (1.0 - points[:, 0] ** 2 - points[:, 1] ** 2) / 4.0


def element(corners):
    """Stiffness matrix and area of a polygon: projection on linear functions, dofi-dofi."""
    x, y = corners.T
    following = np.roll(corners, -1, axis=0)
    cross = x * following[:, 1] - following[:, 0] * y
    area = cross.sum() / 2.0
    centroid = ((corners + following) * cross[:, None]).sum(axis=0) / (6.0 * area)
    h = max(np.linalg.norm(a - b) for a in corners for b in corners)
    n = len(corners)
    d = np.column_stack([np.ones(n), (corners - centroid) / h])
    before = np.roll(corners, 1, axis=0)
    normals = np.column_stack([following[:, 1] - before[:, 1], before[:, 0] - following[:, 0]]) / 2
    b = np.vstack([np.full(n, 1.0 / n), normals.T / h])
    projection = np.linalg.solve(b @ d, b)
    gradients = b @ d
    gradients[0] = 0.0
    rest = np.eye(n) - d @ projection
    return projection.T @ gradients @ projection + rest.T @ rest, area


def boundary(points, polygons):
    count = {}
    for polygon in polygons:
        for edge in zip(polygon, np.roll(polygon, -1)):
            count[frozenset(edge)] = count.get(frozenset(edge), 0) + 1
    fixed = np.zeros(len(points), bool)
    for edge, elements in count.items():
        if elements == 1:
            fixed[list(edge)] = True
    return fixed


def solve(points, polygons):
    n = len(points)
    stiffness, load = np.zeros((n, n)), np.zeros(n)
    for polygon in polygons:
        local, area = element(points[polygon])
        stiffness[np.ix_(polygon, polygon)] += local
        load[polygon] += area / len(polygon)
    fixed = boundary(points, polygons)
    u = np.where(fixed, exact(points), 0.0)
    free = ~fixed
    matrix = stiffness[np.ix_(free, free)]
    if free.any():
        u[free] = np.linalg.solve(matrix, (load - stiffness @ u)[free])
    return u, np.linalg.cond(matrix, 1) if free.any() else 1.0


def write(name, numbers):
    with open(name, "w") as file:
        file.writelines(f"{float(number)!r}\n" for number in np.atleast_1d(numbers))


def main(mesh):
    points, polygons = read_off(mesh)
    if len(points) > 5000:
        sys.exit(f"python-vem.py: {len(points)} vertices are too many for its dense matrix.")
    u, condition = solve(points, polygons)
    truth = exact(points)
    stem = mesh.removesuffix(".off")
    write(f"{stem}-solution.txt", u)
    write(f"{stem}-ground-truth.txt", truth)
    write(f"{stem}-error-inf.txt", np.abs(u - truth).max())
    write(f"{stem}-condition-number.txt", condition)


if __name__ == "__main__":
    # A list of meshes, one a line: Python and NumPy start once for all of them.
    with open(sys.argv[1]) as meshes:
        for mesh in meshes:
            main(mesh.removesuffix("\n"))
