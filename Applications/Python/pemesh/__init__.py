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

# Their Python types must be known before those of PEMesh, which derive from them.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401
import vtkmodules.vtkIOXML  # noqa: F401
import vtkmodules.vtkRenderingContext2D  # noqa: F401

from .pemeshIOMesh import *  # noqa: F401,F403
from .pemeshFiltersGeneration import *  # noqa: F401,F403
from .pemeshFiltersMetrics import *  # noqa: F401,F403
from .pemeshFiltersSolvers import *  # noqa: F401,F403
from .pemeshFiltersVirtualElements import *  # noqa: F401,F403
from .pemeshFiltersStatistics import *  # noqa: F401,F403
from .pemeshCharts import *  # noqa: F401,F403
from .pemeshRunner import *  # noqa: F401,F403
