# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes to and from NumPy arrays and files."""

import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_ID_TYPE
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ._classes import vtkPEMMeshReader, vtkPEMMeshWriter
from ._pipeline import Error, update, write_with


def _as_points(points):
    array = numpy.asarray(points, dtype=numpy.float64)
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise Error(f"points must have the shape (n, 2) or (n, 3), not {array.shape}")
    if array.shape[1] == 2:
        array = numpy.column_stack([array, numpy.zeros(len(array))])
    return numpy.ascontiguousarray(array)


def _as_elements(elements, offsets):
    if offsets is not None:
        return (numpy.ascontiguousarray(elements, dtype=numpy.int64),
                numpy.ascontiguousarray(offsets, dtype=numpy.int64))
    if isinstance(elements, numpy.ndarray) and elements.ndim == 2:
        count, corners = elements.shape
        return (numpy.ascontiguousarray(elements.reshape(-1), dtype=numpy.int64),
                numpy.arange(0, count * corners + 1, corners, dtype=numpy.int64))
    elements = [numpy.asarray(one, dtype=numpy.int64) for one in elements]
    connectivity = numpy.concatenate(elements) if elements else numpy.zeros(0, numpy.int64)
    return connectivity, numpy.cumsum([0] + [len(one) for one in elements], dtype=numpy.int64)


def _check(connectivity, offsets, count):
    if connectivity.ndim != 1 or offsets.ndim != 1 or len(offsets) == 0:
        raise Error("connectivity and offsets must have one dimension, and offsets begins with 0")
    if offsets[0] != 0 or offsets[-1] != len(connectivity) or numpy.any(numpy.diff(offsets) < 0):
        raise Error(f"offsets must grow from 0 to {len(connectivity)}, the length of connectivity")
    short = numpy.flatnonzero(numpy.diff(offsets) < 3)
    if len(short):
        raise Error(f"element {short[0]} has fewer than three vertices")
    wrong = numpy.flatnonzero((connectivity < 0) | (connectivity >= count))
    if len(wrong):
        element = numpy.searchsorted(offsets, wrong[0], side="right") - 1
        raise Error(f"element {element} names the point {connectivity[wrong[0]]}, "
                    f"but there are the points 0 to {count - 1}")


def mesh(points, elements, offsets=None):
    """A mesh of polygons.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
        Coordinates. A C-contiguous float64 array of shape (n, 3) is shared, not copied: what is
        written to it later changes the mesh (call ``mesh.GetPoints().Modified()`` then).
    elements : sequence of sequences of int, or array of shape (m, k), or, with `offsets`, (c,)
        Indices of the vertices of each element, in order around it.
    offsets : array_like of int, shape (m + 1,), optional
        Where each element begins in `elements`, and where the last one ends.

    Returns
    -------
    vtkPolyData
        with m polygons, for every filter of this package and of VTK.

    Raises
    ------
    Error
        An element has fewer than three vertices, or one that there is not.
    """
    coordinates = _as_points(points)
    connectivity, offsets = _as_elements(elements, offsets)
    _check(connectivity, offsets, len(coordinates))
    locations = vtkPoints()
    locations.SetData(numpy_to_vtk(coordinates))
    polygons = vtkCellArray()
    # Copied: the cell array would share the memory, but not keep it alive.
    polygons.SetData(*(numpy_to_vtk(array, deep=1, array_type=VTK_ID_TYPE)
                       for array in (offsets, connectivity)))
    data = vtkPolyData()
    data.SetPoints(locations)
    data.SetPolys(polygons)
    return data


def points(mesh):
    """The coordinates of a mesh, shape (n, 3), float64: a view, not a copy."""
    if mesh.GetNumberOfPoints() == 0:
        return numpy.zeros((0, 3))
    return vtk_to_numpy(mesh.GetPoints().GetData())


def connectivity(mesh):
    """The elements of a mesh as two views: indices of vertices (c,) and offsets (m + 1,), int64."""
    cells = mesh.GetPolys()
    return vtk_to_numpy(cells.GetConnectivityArray()), vtk_to_numpy(cells.GetOffsetsArray())


def elements(mesh):
    """The indices of the vertices of each element: a list of m views, int64."""
    indices, offsets = connectivity(mesh)
    return numpy.split(indices, offsets[1:-1]) if len(offsets) > 1 else []


def _arrays(attributes):
    return {attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i))
            for i in range(attributes.GetNumberOfArrays()) if attributes.GetArray(i) is not None}


def cell_data(mesh):
    """Numbers of the elements by name: a dict of views of shape (m,) or (m, components)."""
    return _arrays(mesh.GetCellData())


def point_data(mesh):
    """Numbers at the vertices by name: a dict of views of shape (n,) or (n, components)."""
    return _arrays(mesh.GetPointData())


def read(path):
    """Reads a mesh from a file: OFF, OBJ, NODE with ELE, STL, VTP and what else the reader knows.

    Raises Error with the file, the line and what is wrong there.
    """
    reader = vtkPEMMeshReader()
    reader.SetFileName(os.fspath(path))
    return update(reader)


def write(mesh, path):
    """Writes a mesh to a file of the kind that the ending of its name says, whole or not at all."""
    writer = vtkPEMMeshWriter()
    writer.SetFileName(os.fspath(path))
    write_with(writer, mesh)
