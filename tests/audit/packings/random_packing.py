"""Random packings of touching spheres with everything that a case may say of them, by a seed."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, field
from typing import Optional

import numpy as np

# Laws and tables of time: ("constant", value), ("linear", value, coefficient, reference), ("table", temperatures,
# values), ("sigmoid", value, amplitude, steepness, reference); ("times", instants, values).
Law = tuple
Layer = Optional[tuple[float, float]]  # thickness [m], reduction
UNITS = {"m": 1.0, "mm": 1e-3, "um": 1e-6}


@dataclass
class Material:
    density: float  # kg/m3
    specific_heat: float  # J/(kg K)
    specific_capacity: float  # F/kg
    typical: dict[str, float]  # conductivity by field: W/(m K) and S/m
    conductivity: dict[str, Law]


@dataclass
class Packing:
    """One scene, in SI units. `kind`: thermal, one-way, two-way, steady or electric."""

    kind: str
    unit: str
    side: float  # of the periodic box [m]
    periodic: list[bool]
    centres: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    radii: np.ndarray = field(default_factory=lambda: np.zeros(0))
    neck: str = "hertz"
    hardening: float = 1.45
    conductance: str = "series"
    gap: float = 0.0
    bond_radius: float = 0.0
    materials: list[Material] = field(default_factory=list)
    material_of: list[int] = field(default_factory=list)
    grain_boundary: dict[str, Layer] = field(default_factory=dict)
    interface: dict[str, Layer] = field(default_factory=dict)  # between the first two materials
    start: float = 300.0  # K; what laws and inputs lie around
    initial: list[float] = field(default_factory=list)
    t_end: float = 1.0
    fixed: dict[str, dict[int, Law]] = field(default_factory=dict)
    sources: dict[int, Law] = field(default_factory=dict)
    convection: Optional[tuple[list[int], float, Law]] = None
    radiation: Optional[tuple[list[int], float, Law]] = None

    @property
    def fields(self) -> list[str]:
        return {"thermal": ["thermal"], "electric": ["electric"]}.get(self.kind, ["thermal", "electric"])

    def distance(self, i: int, j: int) -> float:
        """Between centres, to the nearest image where sides are joined."""
        d = self.centres[j] - self.centres[i]
        d -= np.where(self.periodic, self.side * np.round(d / self.side), 0.0)
        return float(np.linalg.norm(d))


def random_packing(seed: int) -> Packing:
    """The same scene for the same seed."""
    draw = random.Random(seed)
    size = 10 ** draw.uniform(-5, -3)
    ratio = draw.choice([1, 1.5, 4])
    count = draw.randint(6, 30)
    joined = draw.choice(["", "", "xyz", "x", "yz"])
    side = size * max(count ** (1 / 3) * draw.uniform(1.6, 2.0) * (1 if ratio < 2 else 0.75), 5.2 if joined else 0)
    kind = draw.choice(["thermal", "thermal", "one-way", "two-way", "steady", "electric"])
    one = Packing(kind, draw.choice(list(UNITS)), side, [axis in joined for axis in "xyz"])
    _place(one, draw, size, ratio, count)
    one.neck = draw.choice(["geometric", "hertz", "plastic", "coble", "volume-preserving"])
    one.hardening = draw.choice([0.5, 1.0, 1.45])
    one.conductance = draw.choice(["series", "pipe"])
    one.gap = draw.choice([0.0, 0.0, 0.05 * size])
    one.bond_radius = 0.04 * size if one.gap > 0 else draw.choice([0.0, 0.0, 0.05 * size])
    one.start = draw.choice([0.0, 300.0, 1000.0]) if kind != "electric" else 300.0
    follows = {"thermal": draw.random() < 0.5 and kind != "electric", "electric": kind == "two-way"}
    follows["electric"] = follows["electric"] or (kind == "steady" and draw.random() < 0.5)
    for _ in range(draw.choice([1, 1, 2, 3])):
        typical = {"thermal": 10 ** draw.uniform(-1, 2.5), "electric": 10 ** draw.uniform(2, 6)}
        laws = {name: _law(draw, value, one.start, follows[name]) for name, value in typical.items()}
        per_mass = draw.uniform(200, 1500), 10 ** draw.uniform(3, 6)
        one.materials.append(Material(draw.uniform(500, 9000), *per_mass, typical, laws))
    one.material_of = [k % len(one.materials) for k in range(len(one.radii))]
    draw.shuffle(one.material_of)
    if one.conductance == "series":  # a pipe has no layer between halves
        for name in one.fields:
            one.grain_boundary[name] = _layer(draw, size)
            if len(one.materials) > 1:
                one.interface[name] = _layer(draw, size)
    spread = draw.random() < 0.5 and kind != "electric"
    one.initial = [one.start + (draw.uniform(0, 50) if spread else 0.0) for _ in one.radii]
    _drive(one, draw, follows["thermal"])
    return one


def _place(one: Packing, draw: random.Random, size: float, ratio: float, count: int) -> None:
    """Spheres by chance: each but a few touches another one, none swallows another one's centre."""
    centres: list[np.ndarray] = []
    radii: list[float] = []
    for _ in range(20_000):
        if len(radii) == count:
            break
        radius = size * draw.uniform(1 / ratio, 1)
        margin = 0.8 * radius
        centre = [
            draw.uniform(0, one.side) if joined else draw.uniform(margin, one.side - margin) for joined in one.periodic
        ]
        one.centres, one.radii = np.array([*centres, centre]), np.array([*radii, radius])
        overlaps = [radius + radii[j] - one.distance(len(radii), j) for j in range(len(radii))]
        if any(overlap > 0.35 * min(radius, other) for overlap, other in zip(overlaps, radii)):
            continue
        if not radii or any(overlap > 0 for overlap in overlaps) or draw.random() < 0.02:
            centres.append(np.array(centre))
            radii.append(radius)
    one.centres, one.radii = np.array(centres), np.array(radii)


def _law(draw: random.Random, value: float, start: float, follows: bool) -> Law:
    if not follows:
        return ("constant", value)
    kind = draw.choice(["linear", "table", "sigmoid"])
    if kind == "linear":
        return ("linear", value, draw.uniform(-1e-3, 2e-3), start + draw.uniform(0, 50))
    if kind == "table":
        temperatures = sorted(start + draw.uniform(-200, 400) for _ in range(draw.randint(2, 5)))
        return ("table", temperatures, [value * draw.uniform(0.4, 2.5) for _ in temperatures])
    return ("sigmoid", value, draw.uniform(-0.7, 3), draw.uniform(-0.05, 0.1), start + draw.uniform(-50, 100))


def _layer(draw: random.Random, size: float) -> Layer:
    return draw.choice([None, (size * 10 ** draw.uniform(-3, -1), draw.uniform(0.05, 0.5))])


def _input(draw: random.Random, low: float, high: float, t_end: float) -> Law:
    """A constant, or a table of time, perhaps with a step."""
    if draw.random() < 0.5:
        return ("constant", draw.uniform(low, high))
    times = sorted(draw.uniform(0, t_end) for _ in range(draw.randint(2, 5)))
    if len(times) > 2 and draw.random() < 0.5:
        times[1] = times[0]
    return ("times", times, [draw.uniform(low, high) for _ in times])


def _drive(one: Packing, draw: random.Random, nonlinear: bool) -> None:
    """Inputs of a size that the scene notices, over 2 to 2000 times of its fastest exchange."""
    main = one.fields[0]
    of = [one.materials[m] for m in one.material_of]
    per_mass = [m.specific_heat if main == "thermal" else m.specific_capacity for m in of]
    mass = 4 / 3 * math.pi * one.radii**3 * [m.density for m in of]
    capacity = mass * per_mass
    rate = max(m.typical[main] * radius / c for m, radius, c in zip(of, one.radii, capacity))
    one.t_end = 10 ** draw.uniform(0.3, 3.3) / rate
    ids = list(range(len(one.radii)))
    draw.shuffle(ids)
    low, high = one.start, one.start + 50
    if main == "thermal":
        one.fixed["thermal"] = {k: _input(draw, low, high, one.t_end) for k in ids[: draw.randint(0, 3)]}
        power = float(np.mean(capacity)) * 100 / one.t_end  # W
        one.sources = {k: _input(draw, 0, power, one.t_end) for k in ids[3 : 3 + draw.randint(0, 2)]}
        area = 4 * math.pi * float(np.mean(one.radii)) ** 2
        some = sorted(ids[: draw.randint(1, len(ids))])
        if draw.random() < 0.5:
            coefficient = rate * float(np.mean(capacity)) / area * 10 ** draw.uniform(-3, 0)
            one.convection = (some, coefficient, _input(draw, low, high, one.t_end))
        if nonlinear and one.start > 100 and draw.random() < 0.6:
            one.radiation = (some, draw.uniform(0.1, 1), _input(draw, low, one.start + 400, one.t_end))
    if "electric" in one.fields:
        one.fixed["electric"] = {ids[-1]: ("constant", 0.0), ids[-2]: _input(draw, 0.02, 0.1, one.t_end)}
