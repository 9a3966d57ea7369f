"""From arrays to maps."""

import functools
import inspect
import json
import typing
import warnings

import numpy as np

from . import _arrays, _cirque
from ._errors import CirqueError, InaccurateMapWarning, InvalidInputError

_DOMAINS = _cirque.domains()
_own_heuristics = {}
_own_objectives = {}


def register_heuristic(name, choose):
    """From now on cones=name calls choose(problem), which returns cones: (vertex, angle sum) or
    (vertex, least, greatest), in radians. A name that is taken is refused."""
    _register("cones", name, choose, _own_heuristics)


def register_objective(name, distance):
    """From now on angle_objective=name fits corner angles by distance(reference, x), which returns
    (value, slope, curvature): convex in x, zero at x = reference. It is called with arrays, one entry
    a corner; one written for numbers is called number by number, which is slow."""
    _register("angle_objective", name, distance, _own_objectives)


class _OfArrays:
    """An objective as the library calls it: with arrays, for arrays of doubles."""

    def __init__(self, distance):
        self._distance = distance
        self._takes_arrays = None  # until the first call

    def __call__(self, reference, x):
        if self._takes_arrays is None:
            self._takes_arrays = self._try_arrays(reference, x)
        if self._takes_arrays:
            return self._by_arrays(reference, x)
        return self._by_numbers(reference, x)

    def _try_arrays(self, reference, x):
        """False for a function of numbers: arrays make it raise, numbers do not."""
        try:
            self._by_arrays(reference, x)
        except (TypeError, ValueError):
            self._by_numbers(reference[:1], x[:1])
            return False
        return True

    def _by_arrays(self, reference, x):
        parts = self._distance(reference, x)
        value, slope, curvature = (np.broadcast_to(part, x.shape) for part in parts)
        return value, slope, curvature

    def _by_numbers(self, reference, x):
        jets = [self._distance(r, at) for r, at in zip(reference.tolist(), x.tolist())]
        return tuple(np.array(jets, float).reshape(-1, 3).T)


def _register(option, name, function, table):
    words = next(info for info in _cirque.option_infos() if info["name"] == option)["words"]
    if name in table or name in words:
        raise InvalidInputError(f"{option}: '{name}' is taken")
    table[name] = function


class ExactMap(typing.NamedTuple):
    """The mesh refined so that its map is linear on the triangles that it was solved on: none is
    flipped, no vertex was moved. The first vertices are the input's, the others lie on edges."""
    vertices: np.ndarray       # N x 3
    faces: np.ndarray          # T x 3
    uv: np.ndarray             # M x 2
    f_uv: np.ndarray           # T x 3: rows of uv at the corners
    face_of_input: np.ndarray  # T: in which face of the input each triangle lies
    weight: np.ndarray = None  # M, of pattern="equivalence": w of the homogeneous (w u, w v, w)
    position: np.ndarray = None  # N x 3, of a map to the sphere: points of it; uv, f_uv are empty


class Map:
    """A map. To the plane: uv and f_uv; to the sphere: position."""

    def __init__(self, made, points, repair):
        self._made = made
        self._points = points
        self._repair = repair
        self._certificate = None

    @property
    def uv(self):
        """N x 2: every point of the map once (libigl's TC). Read-only, not copied."""
        return self._made.uv

    @property
    def f_uv(self):
        """Per face the rows of uv at its corners (libigl's FTC): F x n, or a list of arrays where
        the faces are polygons of different lengths."""
        return self._by_face(self._made.f_uv)

    @property
    def faces(self):
        """The faces that f_uv is about: all of the input's, in its order. (A polygon that is torn
        along a diagonal comes as its triangles; a face that the repair set aside has no area in
        the map.)"""
        return self._by_face(self._made.corners)

    @property
    def position(self):
        """V x 3: points of the unit sphere; None for a map to the plane."""
        return self._made.position if len(self._made.position) else None

    @property
    def exact(self):
        """With exact=True the ExactMap, else None. Read-only, not copied."""
        made = self._made
        if not made.has_exact:
            return None
        return ExactMap(made.exact_vertices, made.exact_faces.reshape(-1, 3), made.exact_uv,
                        made.exact_f_uv.reshape(-1, 3), made.exact_face_of_input,
                        made.exact_weight if len(made.exact_weight) else None,
                        made.exact_position if len(made.exact_position) else None)

    @property
    def certificate(self):
        """The evidence of the run, a dict (docs/certificate.md)."""
        if self._certificate is None:
            self._certificate = json.loads(self._made.certificate)
        return self._certificate

    @property
    def status(self):
        """"ok", or "inaccurate": without flips, but not held by doubles to 1e-8."""
        return self._made.outcome

    def per_corner(self):
        """F x 3 x 2: a point for every corner."""
        f_uv = self.f_uv
        return [self.uv[row] for row in f_uv] if isinstance(f_uv, list) else self.uv[f_uv]

    def as_vertices(self):
        """(vmapping, indices, uvs), as xatlas gives them: a mesh of its own, whose vertex i is the
        input's vertex vmapping[i] and lies at uvs[i]; seams have vertices on both sides."""
        if self.position is not None:
            raise InvalidInputError("a map to the sphere has no seams: see position")
        vmapping = np.zeros(len(self.uv), np.uint32)
        vmapping[self._made.f_uv] = self._made.corners
        f_uv = self.f_uv
        if isinstance(f_uv, list):
            return vmapping, f_uv, self.uv
        return vmapping, f_uv.astype(np.uint32), self.uv

    def measures(self, faces=False):
        """The quality figures of a map to the plane by name; with faces=True a pair of them and of
        values per triangle that has a map."""
        mesh = _cirque.prepare(self._points, self._made.corners, self._made.first_corner,
                               self._repair)
        figures, values = _cirque.measure(mesh, self._made.uv, self._made.f_uv, faces)
        return (figures, values) if faces else figures

    def __repr__(self):
        where = "the sphere" if self.position is not None else f"{len(self.uv)} points of the plane"
        return f"<cirque.Map to {where}, {self.status}>"

    def _by_face(self, values):
        first = self._made.first_corner
        lengths = np.diff(first)
        if len(lengths) and (lengths == lengths[0]).all():
            return values.reshape(len(lengths), lengths[0])
        return np.split(values, first[1:-1])


class Flattener:
    """A mesh, checked, repaired and taken apart once for many maps: of other cones, cuts or domains.

    What is kept are the surfaces: checks, repair and topology. Triangulations and factorizations
    depend on the options, and the library makes them anew in every call: the order of elimination,
    which is all that maps of other cones have in common, is an eighth of a map's time (97,000
    triangles). `repair` as in flatten(); a call with another one prepares the mesh anew.
    """

    def __init__(self, V, F, repair="safe"):
        self._points = _arrays.points(V)
        self._repair = repair
        corners, first = _arrays.polygons(F)
        self._mesh = _cirque.prepare(self._points, corners, first, repair)

    @property
    def report(self):
        """What was found about the mesh and done to it, for people."""
        return self._mesh.report

    @property
    def components(self):
        """How many components the mesh has."""
        return self._mesh.components

    def __call__(self, *, progress=None, threads=0, **options):
        """The map that the options ask for; see flatten()."""
        given = _cirque.Given()
        given.progress = progress
        given.threads = threads
        given.heuristic = given.objective = None
        given.cones = []
        given.angle_sums = np.zeros(0)
        given.cut = given.cut_paths = _arrays.NONE
        texts = {}
        for name, value in options.items():
            if not _take(name, value, given, len(self._points)) and value is not None:
                texts[name] = _text(value)
        repair = texts.setdefault("repair", self._repair)
        try:
            result = Map(_cirque.map(self._mesh, texts, given), self._points, repair)
        except CirqueError as error:
            if error.map is not None:
                error.map = Map(error.map, self._points, repair)
            raise
        if result.status == "inaccurate":
            warnings.warn(result.certificate["message"], InaccurateMapWarning, stacklevel=3)
        return result


def _take(name, value, given, num_vertices):
    """Whether this was an option that is no text."""
    if name == "cones" and (callable(value) or value in _own_names(_own_heuristics, value)):
        given.heuristic = value if callable(value) else _own_heuristics[value]
    elif name == "cones" and not isinstance(value, str) and value is not None:
        given.cones = _cones(value)
    elif name == "angle_objective" and (callable(value) or
                                        value in _own_names(_own_objectives, value)):
        given.objective = _OfArrays(value if callable(value) else _own_objectives[value])
    elif name == "angle_sums" and value is not None:
        given.angle_sums = np.ascontiguousarray(value, np.float64)
        if given.angle_sums.shape != (num_vertices,):
            raise InvalidInputError(
                f"angle_sums: one a vertex is needed, {num_vertices}, not {given.angle_sums.shape}")
    elif name in ("cut", "cut_paths") and value is not None:
        setattr(given, name, _arrays.pairs(value, name))
    else:
        return name in ("angle_sums", "cut", "cut_paths")
    return True


def _own_names(table, value):
    return table if isinstance(value, str) else ()


def _cones(value):
    """{vertex: angle sum}, {vertex: (least, greatest)}, or rows of vertex, angle or least, greatest;
    in radians."""
    rows = [(v, *np.atleast_1d(a)) for v, a in value.items()] if hasattr(value, "items") else value
    cones = []
    for row in rows:
        if not 2 <= len(row) <= 3 or int(row[0]) != row[0]:
            raise InvalidInputError(
                f"cones: (vertex, angle) or (vertex, least, greatest) is needed, not {row}")
        cones.append((int(row[0]), float(row[1]), float(row[-1])))
    return cones


def _text(value):
    """As a flag would say it."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, (list, tuple, np.ndarray)) and np.ndim(value) == 1:
        return ",".join(str(int(v)) for v in value)
    return str(value)


def flatten(V, F, **options):
    """Maps a mesh conformally: V (N x 3), F (M x 3, M x n or a list of polygons) to a Map. Several
    components come side by side, and what is no surface is repaired as far as `repair` allows.

    Options are those of the program's flags and the YAML keys, under the same names; vertices count
    from 0. Beside them:
      cones           also {vertex: angle sum} in radians, rows (vertex, least, greatest), or a
                      function of a ConeProblem
      angle_sums      the angle sum of every vertex, in radians
      cut, cut_paths  pairs of vertices: edges to open, ends of shortest paths to open
      angle_objective also a function (reference, x) -> (value, slope, curvature) of arrays
      progress        called as progress(stage, iteration, gradient, seconds); False cancels
      threads         the most threads of loops; 0: all cores
    """
    return Flattener(V, F, options.get("repair") or "safe")(**options)


def _into(name, help_text):
    @functools.wraps(flatten)
    def map_into(V, F, **options):
        return flatten(V, F, domain=name, **options)

    map_into.__name__ = map_into.__qualname__ = name
    map_into.__doc__ = f"Maps a mesh to {help_text}: flatten(V, F, domain={name!r}, ...)."
    del map_into.__wrapped__
    return map_into


DOMAIN_FUNCTIONS = {name: _into(name, text) for name, (text, _) in _DOMAINS.items()}


def options(domain=None):
    """What flatten takes by name, a list of dicts: name, help, default, expectation, unit, group; of
    one domain: what that reads."""
    infos = _cirque.option_infos()
    if domain is None:
        return infos
    if domain not in _DOMAINS:
        raise InvalidInputError(f"unknown domain '{domain}'; known: {', '.join(_DOMAINS)}")
    by_some = {name for _, reads in _DOMAINS.values() for name in reads}
    return [i for i in infos if i["name"] not in by_some or i["name"] in _DOMAINS[domain][1]]
