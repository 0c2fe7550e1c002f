# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Filters that raise what they have to say."""

import contextlib
import re
import warnings

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING


class Error(RuntimeError):
    """What a filter cannot do, in one sentence that names the culprit and the way out.

    status: one word, such as "invalid-layout", where a mesh has failed; "error" where the filter
    was asked for something that there is not.
    """

    def __init__(self, message, status="error"):
        super().__init__(message)
        self.status = status


def _sentence(text):
    """The sentence of vtkErrorMacro without the file, the line and the address around it."""
    lines = text.strip().split("\n")
    return re.sub(r"^vtk\w+ \(0x[0-9a-f]+\): ", "", " ".join(lines[1:]) or lines[0]).strip()


def _with_all_before(algorithm):
    found = []

    def add(one):
        if one is None or one in found:
            return
        found.append(one)
        found.append(one.GetExecutive())
        for port in range(one.GetNumberOfInputPorts()):
            for index in range(one.GetNumberOfInputConnections(port)):
                add(one.GetInputAlgorithm(port, index))

    add(algorithm)
    return found


@contextlib.contextmanager
def raising(*objects):
    """While it lasts, errors of these VTK objects are kept; the first is raised at the end.

    Their warnings become Python's.
    """
    errors = []

    @calldata_type(VTK_STRING)
    def keep(_caller, _event, text):
        errors.append(_sentence(text))

    @calldata_type(VTK_STRING)
    def warn(_caller, _event, text):
        warnings.warn(_sentence(text), RuntimeWarning, stacklevel=2)

    tags = [(one, one.AddObserver(event, function)) for one in objects
            for event, function in (("ErrorEvent", keep), ("WarningEvent", warn))]
    try:
        yield
    finally:
        for one, tag in tags:
            one.RemoveObserver(tag)
    if errors:
        raise Error(errors[0])


def field_text(data, name):
    """A text of the field data, None where there is none."""
    array = data.GetFieldData().GetAbstractArray(name)
    return None if array is None else array.GetValue(0)


def raise_if_failed(data, prefix=""):
    """Raises what the mesh says of itself, if it could not be made, read or solved."""
    status = field_text(data, prefix + "Status")
    if status not in (None, "ok"):
        raise Error(f"{status}: {field_text(data, prefix + 'StatusMessage')}", status)


def write_with(writer, data):
    """Hands data to a writer."""
    writer.SetInputData(data)
    with raising(writer, writer.GetExecutive()):
        writer.Write()


def update(algorithm, time=None):
    """Updates a filter and all before it, and returns its output.

    Parameters
    ----------
    algorithm : vtkAlgorithm
    time : float, optional
        The time step asked for; by default the first, or the one asked for last.

    Raises
    ------
    Error
        with the message of the filter that failed, or of the mesh that could not be made.
    """
    with raising(*_with_all_before(algorithm)):
        if time is None:
            algorithm.Update()
        else:
            algorithm.UpdateTimeStep(time)
    output = algorithm.GetOutputDataObject(0)
    raise_if_failed(output)
    return output
