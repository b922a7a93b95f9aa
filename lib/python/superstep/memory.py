"""What a dict holds in arrays, where a case file would name other files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from ._core import InputError
from .arrays import as_array, is_number, refuse_masks

Arrays = dict[str, Any]


def split(case: Mapping[str, Any], name: str) -> tuple[dict[str, Any], Optional[Arrays], Optional[Arrays]]:
    """The case without its arrays, its spheres, and its network; None where it has none of them.

    Raises InputError.
    """
    rest = {key: dict(value) if isinstance(value, Mapping) else value for key, value in case.items()}
    return rest, _spheres(rest, name), _network(rest, name)


def _is_array(value: Any) -> bool:
    """Numbers one after the other, in whatever they come; tables are none."""
    if isinstance(value, np.ndarray):
        return value.ndim > 0
    return (
        isinstance(value, Sequence)
        and not isinstance(value, (str, bytes))
        and not any(isinstance(v, Mapping) for v in value)
    )


def is_list_of_tables(value: Any) -> bool:
    return isinstance(value, Sequence) and len(value) > 0 and all(isinstance(v, Mapping) for v in value)


def _spheres(case: dict[str, Any], name: str) -> Optional[Arrays]:
    packing = case.get("packing")
    if not isinstance(packing, dict) or not {"centres", "radii"} & packing.keys():
        return None
    for key in ("centres", "radii"):
        if key not in packing:
            raise InputError(f"{name}: [packing] has no {key}; give centres (n, 3) and radii (n,)")
    spheres = {key: packing.pop(key) for key in ("centres", "radii", "ids") if key in packing}
    if "materials" in packing:
        names = as_array(packing.pop("materials"), f"{name}: materials")
        if names.ndim != 1:
            raise InputError(f"{name}: materials has the shape {names.shape}; it must be (n,), a name each")
        spheres["materials"] = [str(one) for one in names]
    attributes = packing.pop("attributes", {})
    if not isinstance(attributes, Mapping):
        raise InputError(f"{name}: [packing] attributes is of type {type(attributes).__name__}; it must be a dict")
    attributes = dict(attributes)
    for key in attributes:
        if not isinstance(key, str):
            raise InputError(f"{name}: a key of attributes is {key!r}; keys must be strings")
    for field in ("thermal", "electric"):  # values at the start are a column that nobody else has
        table = case.get(field)
        if isinstance(table, dict) and _is_array(table.get("initial")):
            column = f"{field}.initial"
            attributes[column] = table["initial"]
            table["initial"] = {"column": column}
    for key, value in {**spheres, **attributes}.items():
        refuse_masks(value, f"{name}: {key}")
    if attributes:
        spheres["attributes"] = attributes
    return spheres


def _network(case: dict[str, Any], name: str) -> Optional[Arrays]:
    network = case.get("network")
    if not isinstance(network, dict):
        return None
    for key, value in network.items():
        refuse_masks(value, f"{name}: {key}", "fill them (in fixed with NaN: free), or leave them out")
    out: Arrays = {}
    if "matrix" in network and not isinstance(network["matrix"], str):
        out.update(_rows(network.pop("matrix"), name))
    elif "edges" in network and not isinstance(network["edges"], str):
        out["edges"] = as_array(network.pop("edges"), f"{name}: edges")
        if network.get("conductance") is None:
            raise InputError(f"{name}: [network] has edges and no conductance; give one for each edge [W/K or S]")
        conductance = network.pop("conductance")
        if is_number(conductance):
            conductance = np.full(out["edges"].shape[:1], float(conductance))
        out["conductance"] = conductance
    arrays = {
        key: network.pop(key) for key in ("capacity", "source", "initial", "fixed") if _is_array(network.get(key))
    }
    if not out:
        if arrays:
            raise InputError(
                f"{name}: [network] {next(iter(arrays))} is an array, and the network is in files; "
                "hand over matrix or edges as well"
            )
        return None
    if "edges" in out:
        out["nodes"] = _count(network, out["edges"], arrays, name)
    return {**out, **arrays}


def _count(network: dict[str, Any], ends: NDArray[Any], arrays: Arrays, name: str) -> int:
    """Nodes beside edges: as stated, as many as there are values, or up to the last that an edge ends at."""
    if "nodes" in network:
        nodes = network.pop("nodes")
        if not isinstance(nodes, (int, np.integer)) or nodes < 0:
            raise InputError(f"{name}: [network] nodes is {nodes!r}; beside edges in memory it is their number")
        return int(nodes)
    if arrays:
        return len(next(iter(arrays.values())))
    if not ends.size or not np.issubdtype(ends.dtype, np.integer):
        return 0
    last = int(ends.max())
    if last > 1000 * ends.size + 1_000_000:
        raise InputError(
            f"{name}: an edge ends at node {last}, and there are {len(ends)} edges; nodes are counted from 0: "
            "number them so, or say how many nodes there are"
        )
    return last + 1


def _rows(matrix: Any, name: str) -> Arrays:
    """Compressed rows of a SciPy matrix, of (data, indices, indptr), or of a dense array."""
    if isinstance(matrix, tuple):
        if len(matrix) != 3:
            raise InputError(f"{name}: matrix has {len(matrix)} parts; it must be (data, indices, indptr)")
        data, indices, indptr = matrix
        if np.size(indptr) < 1:
            raise InputError(f"{name}: the matrix's indptr is empty; it has a number for each row and one more")
        return {"data": data, "indices": indices, "indptr": indptr}
    if not hasattr(matrix, "shape"):
        matrix = as_array(matrix, f"{name}: the matrix")
    shape = tuple(matrix.shape)
    if len(shape) != 2 or shape[0] != shape[1]:
        raise InputError(f"{name}: the matrix has the shape {shape}; a network's is square")
    if hasattr(matrix, "tocsr"):
        rows = matrix.tocsr()
        return {"data": rows.data, "indices": rows.indices, "indptr": rows.indptr}
    dense = np.asarray(matrix)
    row, column = np.nonzero(dense)
    indptr = np.zeros(shape[0] + 1, dtype=np.int64)
    np.cumsum(np.bincount(row, minlength=shape[0]), out=indptr[1:])
    return {"data": dense[row, column], "indices": column, "indptr": indptr}
