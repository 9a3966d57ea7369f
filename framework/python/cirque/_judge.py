"""Judging maps, anybody's."""

import json

import numpy as np

from . import _arrays, _cirque
from ._errors import InvalidInputError
from ._flatten import Map, _text


class Verdict:
    """What the judge says; true where the map is valid."""

    def __init__(self, valid, verdict, errors, report):
        self.valid = valid
        self.verdict = verdict
        self.errors = errors
        self.report = json.loads(report)

    def __bool__(self):
        return self.valid

    def __repr__(self):
        return f"<cirque.Verdict: {self.verdict}>"


def _prepared(V, F, repair="safe"):
    corners, first = _arrays.polygons(F)
    return _cirque.prepare(_arrays.points(V), corners, first, repair)


def _uv(uv, f_uv, F):
    """The points of a map and a row for every corner. Without f_uv: a point per vertex."""
    uv = _arrays.rows(uv, 2, "uv")
    corners, first = _arrays.polygons(F if f_uv is None else f_uv, "f_uv")
    of_faces, first_of_faces = _arrays.polygons(F)
    if len(corners) != len(of_faces) or not np.array_equal(first, first_of_faces):
        raise InvalidInputError("f_uv: a row of uv for every corner of every face is needed")
    if len(corners) and not 0 <= corners.min() <= corners.max() < len(uv):
        raise InvalidInputError(f"f_uv: there are {len(uv)} points, counted from 0")
    return uv, corners


def verify(V, F, uv, f_uv=None, **options):
    """What the independent judge, the program verify_map, says of a map: of this library's or of any
    other. uv N x 2 with f_uv per face its rows (none: a point per vertex); or uv V x 3 on the
    sphere. Options are the flags of verify_map: domain ("disk": the boundary lies on the circle),
    require_injective, angle_tolerance, ..."""
    mesh = _cirque.Polygons(_arrays.points(V), *_arrays.polygons(F))
    texts = {name: _text(value) for name, value in options.items()}
    if np.ndim(uv) == 2 and np.shape(uv)[1] == 3:
        return Verdict(*_cirque.judge_sphere(mesh, _arrays.rows(uv, 3, "uv"), texts))
    return Verdict(*_cirque.judge(mesh, *_uv(uv, f_uv, F), texts))


def measures(V, F, uv, f_uv=None, faces=False, repair="safe"):
    """The quality figures of a map to the plane by name; with faces=True a pair: they, and by measure
    a value per triangle that the repair leaves."""
    figures, values = _cirque.measure(_prepared(V, F, repair), *_uv(uv, f_uv, F), faces)
    return (figures, values) if faces else figures


def transfer(V, F, source, target, image, size=None, margin=4):
    """An image painted for one map of a mesh as it is for another one. Both are Maps or pairs
    (uv, f_uv) within the unit square (uv="unit" of the program), image rows x columns (x channels)
    over that square, its first row on top. size: rows and columns of the result; margin: texels
    that are filled around it, so that sampling at seams finds no empty ones."""
    mesh = _prepared(V, F)
    corners = []
    for given in (source, target):
        pair = (given.uv, given.f_uv) if isinstance(given, Map) else given
        corners.append(_cirque.corners_of(mesh, *_uv(*pair, F)))
    image = np.asarray(image)
    if image.ndim not in (2, 3) or 0 in image.shape:
        raise InvalidInputError("image: rows x columns, or rows x columns x channels")
    rows, columns = image.shape[:2] if size is None else size
    values = np.ascontiguousarray(image[::-1].reshape(*image.shape[:2], -1), np.float64)
    moved = _cirque.transfer(mesh, *corners, values, int(columns), int(rows), int(margin))[::-1]
    moved = moved.reshape(moved.shape[:2] + image.shape[2:])
    if np.issubdtype(image.dtype, np.integer):
        moved = np.rint(moved)
    return moved.astype(image.dtype)


__all__ = ["Map", "Verdict", "verify", "measures", "transfer"]
