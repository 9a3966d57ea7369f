"""Energies: the library's, one's own, and what is done with either."""

import numpy as np

from . import _cirque
from ._errors import InvalidInputError
from ._flatten import _text
from ._judge import _prepared


def energies():
    """The names of the library's energies."""
    return _cirque.energy_names()


def energy(name, V, F, angles=None):
    """The library's energy of that name for a mesh: an object with num_parameters, evaluate(x) and
    hessian(x), like one's own. angles: coherent angles, one a corner; none: the mesh's own."""
    angles = None if angles is None else np.ascontiguousarray(angles, np.float64).ravel()
    return _cirque.energy(name, _prepared(V, F), angles)


def minimize(energy, x, strategy="auto", progress=None, **options):
    """Minimises an energy, the library's or one's own, from x by a strategy of the library. An own one
    has
      num_parameters   an int
      evaluate(x)      (value, gradient), or None outside its domain
      hessian(x)       (rows, columns, values), triplets of its lower triangle; None outside
    and may have is_convex and gauge_parameters. Returns a dict: x, value, converged, ..."""
    texts = {name: _text(value) for name, value in options.items()}
    return _cirque.minimize(energy, np.array(x, np.float64), strategy, texts, progress)


def audit(energy=None, inside=(), outside=(), step=1e-2):
    """Judges an energy at points inside and outside its domain: gradient, Hessian, symmetry,
    convexity, domain. `step`: a length over which it is smooth. Returns a list of findings. Without
    an energy: a dict of the findings of all that the library has, on a small flat disk."""
    if energy is not None:
        if not len(inside):
            raise InvalidInputError("inside: a point at which to audit is needed")
        as_points = [[np.array(x, np.float64) for x in points] for points in (inside, outside)]
        return _cirque.audit(energy, *as_points, step)
    V, F = _small_disk()
    findings = {}
    for name in energies():
        own = _cirque.energy(name, _prepared(V, F), None)
        point = _usual_point(own, V, F)
        findings[name] = _cirque.audit(own, [point], [np.full(len(point), np.nan)], 1e-3)
    return findings


def _small_disk():
    """A hexagon around a point, flat; its angles are coherent."""
    turn = np.arange(6) * np.pi / 3
    ring = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(6)])
    V = np.vstack([np.zeros(3), ring + [0.1, 0.05, 0]]) + [0, 0, 1]
    return V, np.array([[0, 1 + i, 1 + (i + 1) % 6] for i in range(6)])


def _usual_point(energy, V, F):
    """Near 0; where an energy is one of angles, pi/3 everywhere."""
    near_zero = 1e-2 * np.cos(np.arange(energy.num_parameters))
    if energy.evaluate(near_zero) is not None:
        return near_zero
    return np.full(energy.num_parameters, np.pi / 3) + near_zero
