"""The exceptions: one for each kind of outcome that is not a map."""

import json


class CirqueError(Exception):
    """What went wrong, and where.

    vertices, faces: those that it is about, counted from 0; empty where none are known. (The text,
    made for people and files, counts them from 1.)
    certificate: a dict, as far as the stages came; None where they did not begin.
    map: of a mesh of several components the Map of those that have one, the others' faces without
    area; None where none has.
    """

    def __init__(self, message, certificate=None, vertices=(), faces=()):
        super().__init__(message)
        self.certificate = certificate
        self.map = None
        self.vertices = list(vertices)
        self.faces = list(faces)


class InvalidInputError(CirqueError, ValueError):
    """Arrays, options or cones that fit no map."""


class InfeasibleError(CirqueError):
    """It is proven that no map exists; certificate["infeasibility"] is the proof."""


class UnrepresentableError(CirqueError):
    """A map exists but exceeds what doubles hold in one chart."""


class NotConvergedError(CirqueError):
    """A limit of iterations, time or floating point was met first."""


class CancelledError(CirqueError):
    """The progress callback returned False."""


class ResourceError(CirqueError):
    """The machine failed: no memory, a full disk."""


class InaccurateMapWarning(UserWarning):
    """The map has no flipped triangle, but doubles do not hold it to 1e-8."""


_BY_CODE = {
    "invalid_input": InvalidInputError,
    "infeasible": InfeasibleError,
    "unrepresentable": UnrepresentableError,
    "not_converged": NotConvergedError,
    "cancelled": CancelledError,
    "resource": ResourceError,
}


def error_of(code, message, certificate, vertices, faces, made):
    """The exception of a status; called by the compiled module. `made` is a map of some components,
    which becomes a Map where the exception passes the Flattener."""
    error = _BY_CODE.get(code, CirqueError)(
        message, json.loads(certificate) if certificate else None, vertices, faces)
    error.map = made
    return error
