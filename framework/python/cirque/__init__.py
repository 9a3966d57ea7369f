"""Conformal maps of meshes by circle patterns.

    import cirque
    m = cirque.flatten(V, F)    # V: N x 3 points, F: M x 3 triangles or a list of polygons
    m.uv, m.f_uv                # the map, as libigl's TC and FTC

The options are those of the program circle_patterns; options() lists them.
"""

from . import _cirque
from ._energies import audit, energies, energy, minimize
from ._errors import (CancelledError, CirqueError, InaccurateMapWarning, InfeasibleError,
                      InvalidInputError, NotConvergedError, ResourceError, UnrepresentableError)
from ._flatten import (DOMAIN_FUNCTIONS, ExactMap, Flattener, Map, flatten, options,
                       register_heuristic, register_objective)
from ._judge import Verdict, measures, transfer, verify

__version__ = _cirque.version().split()[0]

# cirque.disk(V, F), cirque.sphere(V, F), ...: one function a domain of the library.
globals().update(DOMAIN_FUNCTIONS)

__all__ = ["CancelledError", "CirqueError", "ExactMap", "Flattener", "InaccurateMapWarning",
           "InfeasibleError", "InvalidInputError", "Map", "NotConvergedError", "ResourceError",
           "UnrepresentableError", "Verdict", "audit", "energies", "energy", "flatten", "measures",
           "minimize", "options", "register_heuristic", "register_objective", "transfer",
           "verify",
           *DOMAIN_FUNCTIONS]
