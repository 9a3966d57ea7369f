"""Meshes of the tests."""

import os
import pathlib
import subprocess

import numpy as np
import pytest

PROGRAMS = pathlib.Path(os.environ["CIRQUE_PROGRAMS"])
PROJECT = pathlib.Path(__file__).resolve().parents[2]


def grid(n, height=0.3):
    """A bumpy square of 2 n^2 triangles."""
    x, y = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1), indexing="xy")
    z = height * np.sin(3 * x) * np.cos(4 * y)
    V = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    row, column = (a.ravel() for a in np.divmod(np.arange(n * n).reshape(n, n), n))
    a = row * (n + 1) + column
    b, c, d = a + 1, a + n + 2, a + n + 1
    # Diagonals run into the four corners, so that no triangle has two sides on the boundary.
    into = ((row < n / 2) == (column < n / 2))[:, None]
    F = np.concatenate([np.where(into, np.column_stack([a, b, c]), np.column_stack([a, b, d])),
                        np.where(into, np.column_stack([a, c, d]), np.column_stack([b, c, d]))])
    return V, F


def ball(times=3):
    """An octahedron, subdivided and pushed out to an ellipsoid."""
    V = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    F = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(times):
        middle, finer = {}, []

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(V)
                V.append(tuple((p + q) / 2 for p, q in zip(V[a], V[b])))
            return middle[key]

        for a, b, c in F:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        F = finer
    V = np.array(V, float)
    V /= np.linalg.norm(V, axis=1, keepdims=True)
    return V * [1, 1.2, 1.5], np.array(F)


def unclean():
    """A square and a ball, the first face of each twice, and a third face on an inner edge of the
    square."""
    V, F = grid(4)
    W, G = ball(1)
    G = G + len(V)
    fin = [F[20, 0], F[20, 1], len(V) + len(W)]
    points = np.vstack([V, W + [9, 0, 0], V[F[20, 0]] + [0, 0, 1]])
    return points, np.vstack([F, G, F[:1], G[:1], [fin]])


def write_obj(path, V, faces):
    with open(path, "w") as file:
        for x in V:
            file.write("v " + " ".join(repr(float(c)) for c in x) + "\n")
        for face in faces:
            file.write("f " + " ".join(str(int(v) + 1) for v in face) + "\n")


def read_obj(path):
    """(V, vt, F, FT)"""
    V, vt, F, FT = [], [], [], []
    for line in open(path):
        word, *rest = line.split() or [""]
        if word == "v":
            V.append([float(x) for x in rest])
        elif word == "vt":
            vt.append([float(x) for x in rest])
        elif word == "f":
            corners = [corner.split("/") for corner in rest]
            F.append([int(c[0]) - 1 for c in corners])
            if len(corners[0]) > 1 and corners[0][1]:
                FT.append([int(c[1]) - 1 for c in corners])
    return np.array(V), np.array(vt), F, FT


def run_program(*arguments):
    return subprocess.run([PROGRAMS / arguments[0], *map(str, arguments[1:])],
                          capture_output=True, text=True)


@pytest.fixture
def square():
    return grid(12)


@pytest.fixture
def closed():
    return ball()
