"""Arrays and lists of the caller's as the compiled module takes them. Nothing is copied that fits."""

import numpy as np

from ._errors import InvalidInputError

_MOST = np.iinfo(np.int32).max
NONE = np.zeros(0, np.int32)


def indices(values, what):
    """A contiguous array of 32-bit integers: of any integers that fit into them."""
    array = np.asarray(values)
    if array.size == 0:
        array = array.astype(np.int32)
    if array.dtype.kind not in "iu":
        raise InvalidInputError(f"{what}: integers are needed, not {array.dtype}")
    if array.size and (array.max() > _MOST or array.min() < -_MOST):
        raise InvalidInputError(f"{what}: {array.max()} is more than 32 bits can number")
    return np.ascontiguousarray(array, np.int32)


def rows(values, width, what):
    """An N x width array of doubles in rows."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu" or array.ndim != 2 or array.shape[1] != width:
        raise InvalidInputError(
            f"{what}: an N x {width} array of numbers is needed, not {array.dtype} {array.shape}")
    return np.ascontiguousarray(array, np.float64)


def points(values):
    """V x 3; a flat mesh may have two columns."""
    array = np.asarray(values)
    if array.ndim == 2 and array.shape[1] == 2:
        array = np.column_stack([array, np.zeros(len(array))])
    return rows(array, 3, "V")


def polygons(faces, what="F"):
    """(corners, first_corner): of an F x n array, or of a list of polygons of any length."""
    try:
        array = np.asarray(faces)
    except ValueError:  # rows of different lengths
        array = np.zeros(0, object)
    if array.dtype.kind in "iu" and array.ndim == 2 and array.shape[1] >= 3:
        corners = indices(array, what).ravel()
        if array.shape[1] == 3:
            return corners, NONE
        return corners, np.arange(len(array) + 1, dtype=np.int32) * np.int32(array.shape[1])
    lengths = [len(polygon) for polygon in faces] if array.ndim else []
    if not lengths:
        raise InvalidInputError(f"{what}: an F x 3 array or a list of polygons is needed")
    corners = indices([corner for polygon in faces for corner in polygon], what)
    return corners, np.cumsum([0] + lengths, dtype=np.int32)


def pairs(values, what):
    """N x 2 indices."""
    array = indices(values, what)
    if array.size and (array.ndim != 2 or array.shape[1] != 2):
        raise InvalidInputError(f"{what}: pairs of vertices are needed, N x 2")
    return array
