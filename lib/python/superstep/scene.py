"""A scene: a network of heat or current, ready to integrate."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core, arrays, document, memory

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix

Case = Union["Scene", Mapping[str, Any], str, "os.PathLike[str]"]


class Field(NamedTuple):
    """A field of a scene."""

    name: str  #: "temperature" or "potential"
    unit: str  #: "K" or "V"
    steady: bool  #: solved for, not stepped: no unknowns of it


class Scene:
    """n nodes and the edges between them, with m unknowns: the nodes that are neither fixed, nor idle, nor of
    capacity 0, of every field that is stepped.

    Unknowns stand in the order of ``unknown_field`` and ``unknown_node``: field after field, nodes ascending.
    A scene is used by one at a time: by a run, or by a call of ``rhs`` or ``jacobian``; who comes while it is
    in use gets a RuntimeError.
    """

    def __init__(self, core: _core.Scene) -> None:
        """For the functions below; they are the ways to a scene."""
        self._core = core

    # Ways to a scene.

    @classmethod
    def from_file(cls, path: Union[str, os.PathLike[str]]) -> Scene:
        """Reads a case file (TOML) and everything that it names.

        Raises InputError, with file and line.
        """
        return cls(_core.load_file(os.fspath(path)))

    @classmethod
    def from_dict(
        cls, case: Mapping[str, Any], *, name: str = "case", folder: Union[str, os.PathLike[str]] = ""
    ) -> Scene:
        """A case with the keys of a case file (``superstep list --keys``, cases/README.md).

        Arrays may stand where a file would be named:

        - ``packing``: ``centres`` (n, 3) and ``radii`` (n,) in ``length_unit``, m unless it is given; ``ids`` (n,),
          ``materials`` (n,) names, ``attributes`` {name: (n,)}
        - ``thermal``, ``electric``: ``initial`` (n,) in K or V
        - ``network``: ``matrix``, symmetric, Laplacian or conductances in W/K or S, of SciPy, as
          (data, indices, indptr) of compressed rows, or dense; or ``edges`` (m, 2) of nodes counted from 0 with
          ``conductance`` (m,); ``capacity`` (J/K or F), ``source`` (W or A), ``initial`` and ``fixed`` (K or V,
          NaN where a node is free), (n,) each; ``source`` and ``fixed`` may be lists of nodes as in a case file,
          their ``ids`` counted from 0

        name: of the case, with which errors begin. folder: where files that it names are.
        Raises InputError, with the key, or the array and the position in it.
        """
        if not isinstance(case, Mapping):
            raise TypeError(f"a case must be a dict; it is of type {type(case).__name__}: from_file takes paths")
        rest, spheres, network = memory.split(case, name)
        try:
            text = document.text_of(rest, name)
        except RecursionError:
            raise _core.InputError(f"{name}: a table or list of it holds itself") from None
        return cls(_core.build(text, os.path.join(folder, name), spheres, network))

    @classmethod
    def from_spheres(
        cls,
        centres: ArrayLike,
        radii: ArrayLike,
        *,
        conductivity: float,
        density: float,
        specific_heat: float,
        t_end: float,
        fixed: Sequence[Mapping[str, Any]] = (),
        initial: Union[float, ArrayLike] = 0.0,
        neck: str = "volume-preserving",
        output_times: Optional[ArrayLike] = None,
        case: Optional[Mapping[str, Any]] = None,
        name: str = "spheres",
    ) -> Scene:
        """Heat through a packing of spheres that touch where they overlap.

        centres (n, 3) and radii (n,): m
        conductivity: W/(m K). density: kg/m3. specific_heat: J/(kg K)
        t_end, output_times: s
        fixed: what ``[thermal] fixed`` holds, e.g. ``[{"where": "top", "value": 310.0}]``
        initial: K, a number or (n,)
        neck: law of the contacts' radii: geometric, hertz, plastic, coble, volume-preserving
        case: further tables and keys of a case, which go before those that stand here
        Raises InputError.
        """
        made: dict[str, Any] = {
            "t_end": t_end,
            "packing": {"centres": centres, "radii": radii},
            "material": {"density": density},
            "contact": {"neck": neck},
            "thermal": {"conductivity": conductivity, "specific_heat": specific_heat, "initial": initial},
        }
        if fixed is not None and len(fixed) > 0:
            made["thermal"]["fixed"] = list(fixed)
        return cls.from_dict(_merged(made, output_times, case), name=name)

    @classmethod
    def from_matrix(
        cls,
        matrix: Any,
        *,
        t_end: float,
        capacity: Union[float, ArrayLike] = 1.0,
        source: Union[float, ArrayLike, Sequence[Mapping[str, Any]]] = 0.0,
        initial: Union[float, ArrayLike] = 0.0,
        fixed: Union[None, ArrayLike, Sequence[Mapping[str, Any]]] = None,
        kind: str = "auto",
        ambient: float = 0.0,
        field: str = "temperature",
        output_times: Optional[ArrayLike] = None,
        case: Optional[Mapping[str, Any]] = None,
        name: str = "matrix",
    ) -> Scene:
        """``C dX/dt + K X = Y`` with a symmetric sparse K.

        matrix: (n, n), of SciPy, (data, indices, indptr) of compressed rows in any order, or dense; W/K or S
        kind: "laplacian" (off the diagonal -K_ij; what a row sums to leads to surroundings at ``ambient``),
            "conductance" (off the diagonal K_ij, no diagonal), or "auto": by the signs
        capacity: J/K or F, a number or (n,), >= 0; 0 = the value follows from the neighbours at every instant
        source: W or A, a number or (n,), or a list of nodes, counted from 0, with theirs, which may follow time:
            ``[{"ids": [5], "value": {"times": [0, 1, 1], "values": [2, 2, 0]}}]``
        initial: K or V, a number or (n,)
        fixed: K or V, (n,), NaN where a node is free; or such a list; None = all are free
        t_end, output_times: s
        case: further tables and keys of a case, which go before those that stand here
        Raises InputError.
        """
        network = {"matrix": matrix, "matrix_kind": kind, "ambient": ambient}
        return cls._of_network(network, capacity, source, initial, fixed, field, t_end, output_times, case, name)

    @classmethod
    def from_edges(
        cls,
        edges: ArrayLike,
        conductance: Union[float, ArrayLike],
        *,
        t_end: float,
        capacity: Union[float, ArrayLike] = 1.0,
        source: Union[float, ArrayLike, Sequence[Mapping[str, Any]]] = 0.0,
        initial: Union[float, ArrayLike] = 0.0,
        fixed: Union[None, ArrayLike, Sequence[Mapping[str, Any]]] = None,
        nodes: Optional[int] = None,
        field: str = "temperature",
        output_times: Optional[ArrayLike] = None,
        case: Optional[Mapping[str, Any]] = None,
        name: str = "network",
    ) -> Scene:
        """A network by its edges, as ``throat.conns`` of OpenPNM has them.

        edges: (m, 2) nodes, counted from 0. conductance: W/K or S, a number or (m,), >= 0; parallel edges are summed
        nodes: their number; None = as many as there are values of capacity, source, initial or fixed, else up to
            the last one that an edge ends at
        The rest is as in ``from_matrix``. Raises InputError.
        """
        network: dict[str, Any] = {"edges": edges, "conductance": conductance}
        if nodes is not None:
            network["nodes"] = nodes
        return cls._of_network(network, capacity, source, initial, fixed, field, t_end, output_times, case, name)

    @classmethod
    def _of_network(
        cls,
        network: dict[str, Any],
        capacity: Any,
        source: Any,
        initial: Any,
        fixed: Any,
        field: str,
        t_end: float,
        output_times: Optional[ArrayLike],
        case: Optional[Mapping[str, Any]],
        name: str,
    ) -> Scene:
        network.update(capacity=capacity, source=source, initial=initial, field=field)
        if fixed is not None:
            network["fixed"] = fixed if memory.is_list_of_tables(fixed) else arrays.numbers(fixed, f"{name}: fixed")
        return cls.from_dict(_merged({"t_end": t_end, "network": network}, output_times, case), name=name)

    # What it is.

    @property
    def name(self) -> str:
        """Of the case: its file without folder and ending, or what it was called."""
        return self._core.name

    @property
    def title(self) -> str:
        return self._core.title

    @property
    def t_end(self) -> float:
        """s"""
        return self._core.t_end

    @property
    def output_times(self) -> NDArray[np.float64]:
        """s, ascending; the last is t_end."""
        return np.asarray(self._core.output_times)

    @property
    def fields(self) -> list[Field]:
        return [Field(*field) for field in self._core.fields]

    @property
    def warnings(self) -> list[str]:
        """What its user should look at."""
        return self._core.warnings

    @property
    def ids(self) -> NDArray[np.int64]:
        """(n,) ids of the nodes, in the user's order."""
        return self._core.ids

    @property
    def unknown_field(self) -> NDArray[np.int32]:
        """(m,) position in ``fields`` of each unknown's field."""
        return self._core.unknown_field

    @property
    def unknown_node(self) -> NDArray[np.int32]:
        """(m,) position of each unknown's node, 0 to n-1."""
        return self._core.unknown_node

    @property
    def y0(self) -> NDArray[np.float64]:
        """(m,) unknowns at t = 0, K or V."""
        return self._core.initial

    @property
    def centres(self) -> Optional[NDArray[np.float64]]:
        """(n, 3) m, of the packing's particles; None for a network given directly."""
        return self._core.centres

    @property
    def radii(self) -> Optional[NDArray[np.float64]]:
        """(n,) m, of the packing's particles; None for a network given directly."""
        return self._core.radii

    def edges(self, field: str = "") -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.float64]]:
        """The two nodes of each edge and its conductance in W/K or S, (edges,) each. field: "" = the first."""
        return self._core.edges(self._index(field))

    def capacities(self, field: str = "") -> NDArray[np.float64]:
        """(n,) J/K or F. field: "" = the first."""
        return self._core.capacities(self._index(field))

    def effective_conductivity(self, field: str = "") -> float:
        """Of a packing between two layers with fixed values, from a steady solve: q L / (A dT), W/(m K) or S/m.

        Raises InputError where there is none, and says why. field: "" = the first.
        """
        found = self._core.effective_conductivity(self._index(field))
        if found["value"] is None:
            raise _core.InputError(f"{self.name}: there is no effective conductivity: {found['note']}")
        return float(found["value"])

    def __repr__(self) -> str:
        fields = " and ".join(field.name for field in self.fields)
        return f"<superstep.Scene {self.name!r}: {fields}, {self._core.nodes} nodes, {len(self.unknown_node)} unknowns>"

    # Its right-hand side, for other solvers.

    def rhs(self, t: float, y: ArrayLike) -> NDArray[np.float64]:
        """dy/dt = f(t, y), (m,) in K/s or V/s: what every method integrates, and ``scipy.integrate.solve_ivp`` takes.

        t: s; beyond t_end inputs that change in time hold the values that they have there. y: (m,) K or V.
        Raises InputError for another shape.
        """
        return self._core.rhs(t, arrays.real(y, "y"))

    def jacobian_data(self, t: float, y: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.int32], NDArray[np.int32]]:
        """df/dy in compressed columns: data in 1/s, indices, indptr; rows ascend, the diagonal is always there.

        Beyond t_end as in ``rhs``.
        """
        return self._core.jacobian(t, arrays.real(y, "y"))

    def jacobian(self, t: float, y: ArrayLike) -> csc_matrix:
        """df/dy as SciPy's sparse matrix (m, m), 1/s, as ``solve_ivp(..., jac=scene.jacobian)`` takes it."""
        from scipy.sparse import csc_matrix

        size = len(self.unknown_node)
        return csc_matrix(self.jacobian_data(t, y), shape=(size, size))

    def values(self, field: str, t: float, y: ArrayLike) -> NDArray[np.float64]:
        """(n,) values of a field on all nodes at unknowns y, K or V: computed, fixed, idle and eliminated ones.

        A field that is steady is solved for. field: "" = the first. Beyond t_end as in ``rhs``.
        """
        return self._core.values_on_nodes(self._index(field), t, arrays.real(y, "y"))

    def _index(self, field: str) -> int:
        names = [one.name for one in self.fields]
        if not field:
            return 0
        if field not in names:
            raise _core.InputError(f"{self.name}: there is no field {field!r}; there is {' and '.join(names)}")
        return names.index(field)


def as_scene(case: Case) -> Scene:
    """The scene itself, or that of a dict or of a case file. Raises InputError."""
    if isinstance(case, Scene):
        return case
    if isinstance(case, Mapping):
        return Scene.from_dict(case)
    return Scene.from_file(case)


def _merged(
    made: dict[str, Any], output_times: Optional[ArrayLike], case: Optional[Mapping[str, Any]]
) -> dict[str, Any]:
    """What the arguments say, overlaid by what the case says."""
    if case is not None and not isinstance(case, Mapping):
        raise TypeError(f"case must be a dict; it is of type {type(case).__name__}")
    if output_times is not None:
        arrays.refuse_masks(output_times, "output_times")
        made["output_times"] = arrays.numbers(output_times, "output_times")
    for key, value in (case or {}).items():
        own = made.get(key)
        made[key] = {**own, **value} if isinstance(own, dict) and isinstance(value, Mapping) else value
    return made
