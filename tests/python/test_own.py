"""Energies, objectives and heuristics in Python."""

import math

import numpy as np
import pytest
from conftest import grid

import cirque


def leaning_grid(n):
    """A flat grid of nearly equilateral triangles, all edges Delaunay."""
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0))
    V = np.column_stack([(x - 0.5 * y).ravel(), (0.87 * y + 0.1 * np.sin(2 * x)).ravel(),
                         np.zeros(x.size)])
    i = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    return V, np.concatenate([np.column_stack([i, i + 1, i + n + 2]),
                              np.column_stack([i, i + n + 2, i + n + 1])])


class Rosenbrock:
    """Not convex; least at (1, 1)."""

    num_parameters = 2
    is_convex = False

    def evaluate(self, x):
        a, b = 1 - x[0], x[1] - x[0] ** 2
        return a * a + 10 * b * b, np.array([-2 * a - 40 * x[0] * b, 20 * b])

    def hessian(self, x):
        return [0, 1, 1], [0, 0, 1], [2 - 40 * (x[1] - 3 * x[0] ** 2), -40 * x[0], 20]


class Springs:
    """1/2 |x - c|^2 + sum cosh of differences: convex."""

    def __init__(self, c):
        self.c = np.array(c, float)
        self.num_parameters = len(c)

    def evaluate(self, x):
        d = np.diff(x)
        gradient = x - self.c
        gradient[:-1] -= np.sinh(d)
        gradient[1:] += np.sinh(d)
        return 0.5 * np.sum((x - self.c) ** 2) + np.sum(np.cosh(d)), gradient

    def hessian(self, x):
        n, h = len(x), np.cosh(np.diff(x))
        diagonal = np.ones(n)
        diagonal[:-1] += h
        diagonal[1:] += h
        i = np.arange(n)
        return (np.concatenate([i, i[1:]]), np.concatenate([i, i[:-1]]),
                np.concatenate([diagonal, -h]))


def test_every_strategy_minimises_an_own_energy():
    energy = Springs([3, -1, 2, 5])
    result = cirque.minimize(energy, np.zeros(4), gradient_tolerance=1e-10)
    assert result["converged"], result
    value, gradient = energy.evaluate(result["x"])
    assert np.abs(gradient).max() < 1e-10 and result["value"] == pytest.approx(value)
    with pytest.raises(cirque.InvalidInputError, match="did you mean"):
        cirque.minimize(energy, np.zeros(4), "newton", gradient_tolerence=1)


def test_the_audit_judges_an_own_energy():
    findings = cirque.audit(Springs([3, -1, 2]), [np.zeros(3), np.array([1.0, -1, 0.5])],
                            [np.full(3, np.nan)], step=0.1)
    assert {f["check"] for f in findings} >= {"gradient", "hessian", "convexity", "domain"}
    assert all(f["ok"] for f in findings), findings

    class Wrong(Springs):
        def evaluate(self, x):
            value, gradient = super().evaluate(x)
            gradient[0] *= -1
            return value, gradient

    failed = {f["check"] for f in cirque.audit(Wrong([3, -1, 2]), [np.ones(3)], step=0.1)
              if not f["ok"]}
    assert "gradient" in failed

    class NotConvex(Rosenbrock):
        is_convex = True

    failed = {f["check"] for f in cirque.audit(NotConvex(), [np.array([0.0, 3.0])], step=0.01)
              if not f["ok"]}
    assert "convexity" in failed


def test_the_librarys_energies_are_sound():
    findings = cirque.audit()
    assert set(findings) == set(cirque.energies())
    for name, rows in findings.items():
        assert all(f["ok"] for f in rows if f["check"] != "domain"), (name, rows)


def test_a_circle_pattern_is_minimised_and_added_to(square):
    V, F = square
    with pytest.raises(cirque.InvalidInputError, match="not coherent"):
        cirque.energy("circle_pattern", V * [1, 1, 0], F)
    flat, F = leaning_grid(6)
    pattern = cirque.energy("circle_pattern", flat, F)
    result = cirque.minimize(pattern, np.zeros(pattern.num_parameters))
    assert result["converged"]
    x = result["x"] - result["x"].mean()
    edges = [np.linalg.norm(flat[F[:, i]] - flat[F[:, j]], axis=1) for i, j in
             ((1, 2), (2, 0), (0, 1))]
    d1, d2 = flat[F[:, 1]] - flat[F[:, 0]], flat[F[:, 2]] - flat[F[:, 0]]
    area = 0.5 * np.abs(d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0])
    radius = np.log(np.prod(edges, axis=0) / (4 * area))
    assert np.abs(x - (radius - radius.mean())).max() < 1e-6

    class Nearer:
        num_parameters = pattern.num_parameters

        def evaluate(self, x):
            value, gradient = pattern.evaluate(x)
            return value + 0.5 * x @ x, gradient + x

        def hessian(self, x):
            rows, columns, values = pattern.hessian(x)
            i = np.arange(len(x))
            return np.r_[rows, i], np.r_[columns, i], np.r_[values, np.ones(len(x))]

    nearer = cirque.minimize(Nearer(), np.zeros(pattern.num_parameters))
    assert nearer["converged"] and np.ptp(nearer["x"]) < np.ptp(x)


def test_a_heuristic_is_a_function(closed):
    V, F = closed

    def even(problem):
        chosen = problem.candidates[:: len(problem.candidates) // 8][:8]
        return [(v, 2 * np.pi - problem.total_curvature / 8) for v in chosen]

    by_function = cirque.flatten(V, F, cones=even, strict=True)
    given = {v: 1.5 * np.pi for v in np.arange(len(V))[:: len(V) // 8][:8]}
    assert np.array_equal(by_function.uv, cirque.flatten(V, F, cones=given, strict=True).uv)
    cirque.register_heuristic("even", even)
    assert np.array_equal(cirque.flatten(V, F, cones="even", strict=True).uv, by_function.uv)
    with pytest.raises(cirque.InvalidInputError, match="taken"):
        cirque.register_heuristic("even", even)


def test_what_a_heuristic_raises_is_raised(closed):
    kept = []

    def fails(problem):
        kept.append(problem)
        assert problem.curvature.sum() == pytest.approx(problem.total_curvature)
        assert problem.solve(problem.curvature).shape == (len(closed[0]),)
        return {}["mine"]

    with pytest.raises(KeyError, match="mine"):
        cirque.flatten(*closed, cones=fails)
    with pytest.raises(ValueError, match="as long as"):
        kept[0].area
    with pytest.raises(ValueError, match="a cone is"):
        cirque.flatten(*closed, cones=lambda problem: [(1, 2, 3, 4)])
    with pytest.raises(cirque.InvalidInputError):
        cirque.flatten(*closed, cones=lambda problem: [(0, 1.0)])  # Gauss-Bonnet


def quadratic(reference, x):
    return 0.5 * (x - reference) ** 2, x - reference, 1.0


def test_an_objective_is_a_function_of_arrays():
    V, F = grid(4)
    sizes = []

    def mine(reference, x):
        sizes.append((reference.shape, x.shape))
        return quadratic(reference, x)

    own = cirque.flatten(V, F, angle_objective=mine, refine_map="none")
    library = cirque.flatten(V, F, angle_objective="quadratic", refine_map="none")
    assert np.abs(own.uv - library.uv).max() < 1e-9
    other = cirque.flatten(V, F, angle_objective="entropy", refine_map="none")
    assert np.abs(own.uv - other.uv).max() > 1e-9
    assert all(r == x for r, x in sizes) and max(x for _, x in sizes) == (F.size,)
    few = len(sizes)
    cirque.flatten(*grid(16), angle_objective=mine, refine_map="none")
    assert len(sizes) - few < 4 * few  # of sixteen times the corners

    def fails(reference, x):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        cirque.flatten(V, F, angle_objective=fails)
    with pytest.raises(ValueError):
        cirque.flatten(V, F, angle_objective=lambda reference, x: (x, x))


def test_an_objective_of_numbers_is_called_number_by_number():
    V, F = grid(3)

    def of_numbers(reference, x):
        return math.pow(x - reference, 2) / 2, float(x - reference), 1.0

    by_arrays = cirque.flatten(V, F, angle_objective=quadratic, refine_map="none")
    by_numbers = cirque.flatten(V, F, angle_objective=of_numbers, refine_map="none")
    assert np.abs(by_arrays.uv - by_numbers.uv).max() < 1e-12


def test_an_energy_that_answers_nonsense_is_told_so():
    class Short(Springs):
        def evaluate(self, x):
            return 0.0, x[:-1]

    with pytest.raises(ValueError, match="gradient has 1 entries"):
        cirque.minimize(Short([1, 2]), np.zeros(2))

    class Outside(Springs):
        def hessian(self, x):
            return [5], [0], [1.0]

    with pytest.raises(IndexError, match="outside"):
        cirque.minimize(Outside([1, 2]), np.zeros(2), "newton")
    with pytest.raises(ValueError, match="entries"):
        cirque.minimize(Springs([1, 2]), np.zeros(3))
