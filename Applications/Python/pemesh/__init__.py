# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""PEMesh: how the geometry of polygonal meshes affects polytopal element methods.

All filters are classes of this package and work beside those of `vtkmodules`:

    import pemesh
    layout = pemesh.vtkPEMPolygonLayout()
    layout.AddPolygon("star", 0.5, 0.5)
    mesher = pemesh.vtkPEMDomainMesher()
    mesher.SetInputConnection(layout.GetOutputPort())
    mesher.Update()
    print(mesher.GetOutput().GetNumberOfCells())
"""

import importlib
import pkgutil

# Their Python types must be known before those of PEMesh, which derive from them.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401
import vtkmodules.vtkIOXML  # noqa: F401
import vtkmodules.vtkRenderingContext2D  # noqa: F401


def _take_classes():
    """All classes of all wrapped modules, whichever this build has."""
    for found in pkgutil.iter_modules(__path__, __name__ + "."):
        if found.name.startswith(__name__ + ".pemesh"):
            module = importlib.import_module(found.name)
            globals().update(
                (name, value) for name, value in vars(module).items() if not name.startswith("_"))


_take_classes()
