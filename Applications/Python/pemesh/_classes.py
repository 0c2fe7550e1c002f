# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""All classes of all wrapped modules, whichever this build has."""

import importlib
import pathlib
import pkgutil

# Their Python types must be known before those of PEMesh, which derive from them.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401
import vtkmodules.vtkIOXML  # noqa: F401
import vtkmodules.vtkRenderingContext2D  # noqa: F401

for _found in pkgutil.iter_modules([str(pathlib.Path(__file__).parent)], __package__ + "."):
    if _found.name.startswith(__package__ + ".pemesh"):
        _module = importlib.import_module(_found.name)
        globals().update({_name: _value for _name, _value in vars(_module).items()
                          if not _name.startswith("_")})

__all__ = [_name for _name in globals() if _name.startswith("vtkPEM")]
