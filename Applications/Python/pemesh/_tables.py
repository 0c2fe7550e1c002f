# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables as mappings from column names to NumPy arrays."""

import collections.abc
import difflib
import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkTable

from ._classes import vtkPEMTableReader, vtkPEMTableWriter
from ._pipeline import Error, update, write_with


def _column(array):
    if isinstance(array, vtkDataArray):
        return vtk_to_numpy(array)
    return numpy.array([array.GetValue(i) for i in range(array.GetNumberOfValues())], dtype=object)


class Table(collections.abc.Mapping):
    """Columns of equal length by name: ``table["MinAngle_min"]`` is a NumPy array.

    Numbers are views of the table behind it where there is one, texts are arrays of str. Undefined
    is NaN. ``pandas.DataFrame(dict(table))`` is the same for pandas.
    """

    def __init__(self, columns):
        """columns: a vtkTable, or a mapping from names to sequences of equal length."""
        if isinstance(columns, vtkTable):
            self._vtk = columns
            self._columns = {columns.GetColumnName(i): _column(columns.GetColumn(i))
                             for i in range(columns.GetNumberOfColumns())}
            return
        self._vtk = None
        self._columns = {name: numpy.asarray(values) for name, values in columns.items()}
        lengths = {name: len(values) for name, values in self._columns.items()}
        if len(set(lengths.values())) > 1:
            raise Error(f"the columns differ in length: {lengths}")

    @classmethod
    def read(cls, path):
        """A table from a CSV file with a heading, such as a results.csv."""
        reader = vtkPEMTableReader()
        reader.SetFileName(os.fspath(path))
        return cls(update(reader))

    def write(self, path):
        """Writes a CSV file, whole or not at all, which read() gives back to the bit."""
        writer = vtkPEMTableWriter()
        writer.SetFileName(os.fspath(path))
        write_with(writer, self.to_vtk())

    @property
    def rows(self):
        """Number of rows."""
        return len(next(iter(self._columns.values()), ()))

    def to_vtk(self):
        """The vtkTable, for the filters."""
        if self._vtk is None:
            self._vtk = vtkTable()
            for name, values in self._columns.items():
                if values.dtype.kind in "biuf":
                    column = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=(
                        numpy.float64 if values.dtype.kind == "f" else numpy.int64)), deep=1)
                else:
                    column = vtkStringArray()
                    for value in values:
                        column.InsertNextValue(str(value))
                column.SetName(name)
                self._vtk.AddColumn(column)
        return self._vtk

    def join(self, other, on="Mesh"):
        """A new table with the columns of `other` too, its rows found by the column `on`.

        Rows that `other` does not have get NaN, or the empty text.
        """
        place = {key: row for row, key in enumerate(other[on].tolist())}
        found = [place.get(key) for key in self[on].tolist()]
        columns = dict(self)
        for name, values in other.items():
            if name != on:
                missing = numpy.nan if values.dtype.kind in "biuf" else ""
                columns[name] = numpy.array(
                    [missing if row is None else values[row] for row in found],
                    dtype=object if missing == "" else numpy.float64)
        return Table(columns)

    def __getitem__(self, name):
        try:
            return self._columns[name]
        except KeyError:
            near = difflib.get_close_matches(str(name), self._columns, 3)
            raise KeyError(f"there is no column {name!r}"
                           + (f"; near it: {', '.join(near)}" if near else "")) from None

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self._columns)

    def __repr__(self):
        return f"<pemesh.Table: {self.rows} rows, {len(self)} columns>"
