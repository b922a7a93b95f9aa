"""Superstep: heat and electric current through networks, by whichever time integrator is fastest.

    import superstep

    scene = superstep.Scene.from_file("case.toml")             # or from_dict, from_spheres, from_matrix, from_edges
    result = superstep.integrate(scene, "auto", rtol=1e-4)
    print(result.times, result.temperature, result.statistics)

What is handed over wrongly raises InputError, a ValueError, with one message that names place, value, rule and way
out: the one that the program prints. A method that refuses a scene or fails on it raises MethodError.
Everything is in SI units: m, kg, s, K, W, V, A.
"""

from ._core import InputError, MethodError
from ._core import version as __version__
from .benchmark import bench
from .integration import Result, integrate
from .methods import Method, methods
from .scene import Field, Scene

__all__ = [
    "Field",
    "InputError",
    "Method",
    "MethodError",
    "Result",
    "Scene",
    "__version__",
    "bench",
    "integrate",
    "methods",
]
