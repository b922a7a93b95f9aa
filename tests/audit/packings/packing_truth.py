"""Physics of a packing and its solution, by NumPy and SciPy: nothing of the program is used.

Necks and conductances: Rojek & Nisar 2026, eqs 31-39, and the constant-volume neck of two spheres; heat and current:
eqs 1-7 there; pipe model: Zohdi 2014, eqs 33-34; sigmoid: eq. 50 without its field.
"""

from __future__ import annotations

import math
from typing import Callable

import numpy as np
from random_packing import Law, Packing
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

STEFAN_BOLTZMANN = 5.670374419e-8  # W/(m2 K4)
Contact = tuple[int, int, float, float]  # ends, neck radius [m], distance [m]


def neck_radius(one: Packing, i: int, j: int, distance: float) -> float:
    """0 where the two do not touch."""
    a, b = float(one.radii[i]), float(one.radii[j])
    overlap, reduced = a + b - distance, 2 * a * b / (a + b)
    if not overlap > -one.gap:
        return 0.0
    radius = 0.0
    if overlap > 0:
        factor = {"hertz": 0.5, "plastic": one.hardening, "coble": 2.0}.get(one.neck)
        if factor is not None:
            radius = math.sqrt(factor * reduced * overlap)
        elif one.neck == "geometric":
            radius = math.sqrt(max(a**2 - ((distance - (b**2 - a**2) / distance) / 2) ** 2, 0.0))
        else:
            radius = math.sqrt(_square_of_constant_volume(a, b, overlap))
    return min(max(radius, one.bond_radius), a, b)


def _square_of_constant_volume(a: float, b: float, overlap: float) -> float:
    def excess(square: float) -> float:
        heights = [(r, math.sqrt(max(r**2 - square, 0.0))) for r in (a, b)]
        return square * sum((r + 2 * z) / (3 * (r + z) ** 2) for r, z in heights) - overlap

    largest = min(a, b) ** 2
    return largest if excess(largest) <= 0 else brentq(excess, 0.0, largest, xtol=1e-18 * largest, rtol=1e-15)


def contacts_of(one: Packing) -> list[Contact]:
    found = []
    for i in range(len(one.radii)):
        for j in range(i + 1, len(one.radii)):
            distance = one.distance(i, j)
            if (radius := neck_radius(one, i, j, distance)) > 0:
                found.append((i, j, radius, distance))
    return found


def law_at(law: Law, temperature: float) -> float:
    kind, *rest = law
    if kind == "linear":
        value, coefficient, reference = rest
        return value * max(1 + coefficient * (temperature - reference), 0.01)  # what "clamp" promises
    if kind == "table":
        return float(np.interp(temperature, *rest))
    if kind == "sigmoid":
        value, amplitude, steepness, reference = rest
        return value * (1 + amplitude / (1 + math.exp(-steepness * (temperature - reference))))
    return rest[0]


def input_at(law: Law, t: float) -> float:
    """At a step the value behind it."""
    if law[0] == "constant":
        return law[1]
    _, times, values = law
    if t < times[0]:
        return values[0]
    if t >= times[-1]:
        return values[-1]
    k = max(i for i, instant in enumerate(times) if instant <= t)
    return values[k] + (values[k + 1] - values[k]) * (t - times[k]) / (times[k + 1] - times[k])


class Truth:
    """Right-hand side and solution of a packing. `final` and `span` are by field, all particles."""

    def __init__(self, one: Packing) -> None:
        self.one, self.contacts = one, contacts_of(one)
        self.n = len(one.radii)
        self.first = np.array([c[0] for c in self.contacts], dtype=int)
        self.second = np.array([c[1] for c in self.contacts], dtype=int)
        volume = 4 / 3 * math.pi * one.radii**3
        of = [one.materials[m] for m in one.material_of]
        self.area = 4 * math.pi * one.radii**2
        self.capacity = {
            "thermal": volume * [m.density * m.specific_heat for m in of],
            "electric": volume * [m.density * m.specific_capacity for m in of],
        }
        self.reached = self._reached_by_current() if "electric" in one.fields else []
        self.stepped = [name for name in one.fields if not (name == "electric" and one.kind == "steady")]

    @property
    def conducts(self) -> bool:
        """Whether both electrodes share a cluster."""
        return "electric" not in self.one.fields or self._electrodes_meet

    def _reached_by_current(self) -> list[int]:
        neighbours: list[list[int]] = [[] for _ in range(self.n)]
        for i, j, *_ in self.contacts:
            neighbours[i].append(j)
            neighbours[j].append(i)

        def cluster(seeds: list[int]) -> set[int]:
            seen, frontier = set(seeds), list(seeds)
            while frontier:
                for other in neighbours[frontier.pop()]:
                    if other not in seen:
                        seen.add(other)
                        frontier.append(other)
            return seen

        electrodes = list(self.one.fixed["electric"])
        self._electrodes_meet = electrodes[1] in cluster(electrodes[:1])
        return sorted(cluster(electrodes) - set(electrodes))

    def conductances(self, name: str, temperature: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Of all contacts [W/K or S], and the part of their Joule heat that the first end takes."""
        one = self.one
        bulk = [law_at(one.materials[m].conductivity[name], T) for m, T in zip(one.material_of, temperature)]
        total, part = np.empty(len(self.contacts)), np.empty(len(self.contacts))
        for k, (i, j, radius, distance) in enumerate(self.contacts):
            section = math.pi * radius**2
            if one.conductance == "pipe":
                resistance = distance / ((bulk[i] + bulk[j]) / 2 * section)
            else:
                resistance = 1 / (1.08 * math.pi * radius * bulk[i]) + 1 / (1.08 * math.pi * radius * bulk[j])
            layer = one.grain_boundary.get(name)
            if {one.material_of[i], one.material_of[j]} == {0, 1} and one.interface.get(name):
                layer = one.interface[name]
            if layer:
                thickness, reduction = layer
                resistance += thickness / (reduction * 2 * bulk[i] * bulk[j] / (bulk[i] + bulk[j]) * section)
            total[k], part[k] = 1 / resistance, bulk[j] / (bulk[i] + bulk[j])
        return total, part

    def _spread(self, to_first: np.ndarray, to_second: np.ndarray) -> np.ndarray:
        return np.bincount(self.first, to_first, self.n) + np.bincount(self.second, to_second, self.n)

    def values(self, t: float, y: np.ndarray) -> dict[str, np.ndarray]:
        """Of every particle, by field, held and steady ones included."""
        one = self.one
        out = {"thermal": np.full(self.n, one.start), "electric": np.zeros(self.n)}
        for k, name in enumerate(self.stepped):
            out[name] = y[k * self.n : (k + 1) * self.n].copy()
        for name, held in one.fixed.items():
            for particle, law in held.items():
                out[name][particle] = input_at(law, t)
        if one.kind == "steady":
            self._solve_steady(out)
        return out

    def _solve_steady(self, out: dict[str, np.ndarray]) -> None:
        conductance, _ = self.conductances("electric", out["thermal"])
        matrix = np.zeros((self.n, self.n))
        for i, j, g in zip(self.first, self.second, conductance):
            matrix[[i, j], [i, j]] += g
            matrix[[i, j], [j, i]] -= g
        held, free = list(self.one.fixed["electric"]), self.reached
        if free:
            load = -matrix[np.ix_(free, held)] @ out["electric"][held]
            out["electric"][free] = np.linalg.solve(matrix[np.ix_(free, free)], load)

    def derivative(self, t: float, y: np.ndarray) -> np.ndarray:
        one, value = self.one, self.values(t, y)
        flow = {"thermal": np.zeros(self.n), "electric": np.zeros(self.n)}
        for name in one.fields:
            conductance, part = self.conductances(name, value["thermal"])
            difference = value[name][self.second] - value[name][self.first]
            flow[name] += self._spread(conductance * difference, -conductance * difference)
            if name == "electric":
                heat = conductance * difference**2
                flow["thermal"] += self._spread(heat * part, heat * (1 - part))
        for particle, law in one.sources.items():
            flow["thermal"][particle] += input_at(law, t)
        for exchange, power in ((one.convection, 1), (one.radiation, 4)):
            if exchange:
                some, coefficient, ambient = exchange
                factor = coefficient * (STEFAN_BOLTZMANN if power == 4 else 1)
                flow["thermal"][some] += factor * self.area[some] * (
                    input_at(ambient, t) ** power - value["thermal"][some] ** power
                )
        for name, held in one.fixed.items():
            flow[name][list(held)] = 0
        return np.concatenate([flow[name] / self.capacity[name] for name in self.stepped])

    def knots(self) -> list[float]:
        laws = [law for held in self.one.fixed.values() for law in held.values()] + list(self.one.sources.values())
        laws += [exchange[2] for exchange in (self.one.convection, self.one.radiation) if exchange]
        inside = {t for law in laws if law[0] == "times" for t in law[1] if t < self.one.t_end}
        return sorted(inside | {0.0, self.one.t_end})

    def solve(self) -> None:
        """Radau from knot to knot, five digits below what is asked of methods."""
        start = {"thermal": np.array(self.one.initial), "electric": np.zeros(self.n)}
        scale = {"thermal": 60.0, "electric": 0.1}
        y = np.concatenate([start[name] for name in self.stepped])
        tolerance = np.concatenate([np.full(self.n, 1e-10 * scale[name]) for name in self.stepped])
        seen: list[dict[str, np.ndarray]] = []
        knots = self.knots()
        for begin, end in zip(knots, knots[1:]):
            last = np.nextafter(end, begin)  # a step at the end belongs to the next piece
            piece: Callable = lambda t, y, begin=begin, last=last: self.derivative(min(max(t, begin), last), y)
            result = solve_ivp(piece, (begin, end), y, method="Radau", rtol=1e-9, atol=tolerance)
            if not result.success:
                raise ArithmeticError(result.message)
            seen += [self.values(min(t, last), state) for t, state in zip(result.t, result.y.T)]
            y = result.y[:, -1]
        self.final = self.values(self.one.t_end, y)
        seen.append(self.final)
        self.span = {
            name: max(v[name].max() for v in seen) - min(v[name].min() for v in seen) for name in self.one.fields
        }
