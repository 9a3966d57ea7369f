"""Arrays in, maps out: the same as the program's."""

import json
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import ball, grid, read_obj, run_program, unclean, write_obj

import cirque

CASES = [("plane", {}), ("plane", {"angle_objective": "quadratic", "refine_map": "none"}),
         ("disk", {"centre": 84}), ("rectangle", {"corners": [0, 12, 168, 156]}),
         ("polygon", {"sides": 5}), ("triangle", {}), ("half_plane", {})]


@pytest.mark.parametrize("domain, options", CASES)
def test_results_are_bit_equal_to_the_programs(square, tmp_path, domain, options):
    V, F = square
    write_obj(tmp_path / "in.obj", V, F)
    from_one = {"centre", "corners", "pole", "angle_zero"}
    flags = []
    for name, value in options.items():
        values = np.atleast_1d(value)
        if name in from_one:
            values = values + 1
        flags.append(f"--{name}=" + ",".join(map(str, values)))
    run = run_program("circle_patterns", "-io", tmp_path / "in.obj", "-oo", tmp_path / "out.obj",
                      "-certificate", tmp_path / "out.json", f"--domain={domain}", *flags)
    assert run.returncode == 0, run.stdout + run.stderr
    _, vt, faces, rows = read_obj(tmp_path / "out.obj")
    m = cirque.flatten(V, F, domain=domain, **options)
    assert np.array_equal(m.uv, vt)
    assert np.array_equal(m.f_uv, rows)
    assert np.array_equal(m.faces, faces)
    by_program = json.loads((tmp_path / "out.json").read_text())
    machine = {"peak_memory_mib"}
    for name, value in m.certificate["values"].items():
        if name not in machine:
            assert by_program["values"][name] == value, name


def test_the_sphere_is_bit_equal_to_the_programs(closed, tmp_path):
    V, F = closed
    write_obj(tmp_path / "in.obj", V, F)
    run = run_program("circle_patterns", "-io", tmp_path / "in.obj", "-oo", tmp_path / "out.obj",
                      "--domain=sphere")
    assert run.returncode == 0, run.stdout + run.stderr
    m = cirque.sphere(V, F)
    assert np.array_equal(m.position, read_obj(tmp_path / "out.obj")[0])
    assert np.allclose(np.linalg.norm(m.position, axis=1), 1)
    assert cirque.verify(V, F, m.position)
    with pytest.raises(cirque.InvalidInputError):
        m.as_vertices()


@pytest.mark.parametrize("options", [{}, {"uv": "unit", "scale_pieces": "each"},
                                     {"uv": "scale=3", "repair": "weld:1e-6"}])
def test_several_components_and_faces_to_repair_are_as_the_programs(tmp_path, options):
    V, F = unclean()
    write_obj(tmp_path / "in.obj", V, F)
    flags = [f"--{name}={value}" for name, value in options.items()]
    run = run_program("circle_patterns", "-io", tmp_path / "in.obj", "-oo", tmp_path / "out.obj",
                      *flags)
    assert run.returncode == 0, run.stdout + run.stderr
    _, vt, faces, rows = read_obj(tmp_path / "out.obj")
    m = cirque.flatten(V, F, **options)
    assert np.array_equal(m.uv, vt)
    assert np.array_equal(m.f_uv, rows)
    assert np.array_equal(m.faces, F) and np.array_equal(faces, F)
    assert len(m.certificate["components"]) >= 2
    assert m.certificate["repair"]["split_edges"]
    verdict = cirque.verify(V, F, m.uv, m.f_uv)
    assert verdict, verdict
    assert not cirque.verify(V, F, m.uv * [-1, 1], m.f_uv)
    assert m.measures() == cirque.measures(V, F, m.uv, m.f_uv,
                                           repair=options.get("repair", "safe"))
    assert np.array_equal(cirque.Flattener(V, F)(**options).uv, m.uv)
    vmapping, indices, uvs = m.as_vertices()
    assert np.array_equal(vmapping[indices], F) and np.array_equal(uvs[indices], m.per_corner())


def test_what_has_a_map_comes_with_the_error():
    V, F = grid(4)
    W, G = ball(1)
    both = np.vstack([V, W + [9, 0, 0]]), np.vstack([F, G + len(V)])
    with pytest.raises(cirque.InvalidInputError, match="1 of 2 components without a map") as error:
        cirque.disk(*both)
    partial = error.value.map
    assert len(partial.f_uv) == len(both[1])
    alone = cirque.disk(V, F)
    corners = partial.per_corner()[:len(F)]
    assert np.allclose(np.linalg.norm(corners[:, 1] - corners[:, 0], axis=1) /
                       np.linalg.norm(corners[0, 1] - corners[0, 0]),
                       np.linalg.norm((p := alone.per_corner())[:, 1] - p[:, 0], axis=1) /
                       np.linalg.norm(p[0, 1] - p[0, 0]))
    assert error.value.certificate["values"]["components_failed"] == 1
    with pytest.raises(cirque.InvalidInputError, match="takes one component"):
        cirque.sphere(np.vstack([W, W + [9, 0, 0]]), np.vstack([G, G + len(W)]))
    with pytest.raises(cirque.InvalidInputError) as refused:
        cirque.flatten(*unclean(), repair="none")
    assert refused.value.vertices and refused.value.map is None


def test_cones_find_their_component(closed):
    V, F = grid(4)
    W, G = closed
    both = np.vstack([V, W + [9, 0, 0]]), np.vstack([F, G + len(V)])
    m = cirque.flatten(*both, cones={len(V) + v: np.pi for v in range(4)})
    parts = m.certificate["components"]
    assert [part["values"].get("cones", 0) for part in parts] == [0, 4]
    assert cirque.Flattener(*both).components == 2


def test_every_domain_is_a_function(square):
    names = {name for name in cirque.options() for name in [name["name"]] if name == "domain"}
    assert names == {"domain"}
    words = next(o["words"] for o in cirque.options() if o["name"] == "domain")
    for name in words:
        assert callable(getattr(cirque, name)) and name in cirque.__all__
    V, F = square
    uv = cirque.disk(V, F).uv
    boundary = np.unique(F[:, [0, 1, 2]])  # all vertices; those of the rim have |uv| = 1
    assert len(boundary) == len(uv)
    assert np.isclose(np.linalg.norm(uv, axis=1).max(), 1, atol=1e-12)


@pytest.mark.parametrize("dtype", [np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32,
                                   np.int64, np.uint64])
def test_integers_of_any_width(dtype):
    V, F = grid(4)
    assert np.array_equal(cirque.flatten(V, F.astype(dtype)).uv, cirque.flatten(V, F).uv)


def test_layouts_and_lists_are_the_same():
    V, F = grid(4)
    uv = cirque.flatten(V, F).uv
    assert np.array_equal(cirque.flatten(np.asfortranarray(V), F[:, ::1]).uv, uv)
    assert np.array_equal(cirque.flatten(V.tolist(), F.tolist()).uv, uv)
    flat = cirque.flatten(V[:, :2], F)
    assert flat.uv.shape == uv.shape


def test_polygons():
    V, _ = grid(3)
    quads = [[i + 4 * j, i + 1 + 4 * j, i + 5 + 4 * j, i + 4 + 4 * j]
             for j in range(3) for i in range(3)]
    m = cirque.flatten(V, np.array(quads))
    assert m.f_uv.shape == (9, 4) and np.array_equal(m.faces, quads)
    mixed = quads[:-1] + [quads[-1][:3], [quads[-1][0], quads[-1][2], quads[-1][3]]]
    m = cirque.flatten(V, mixed)
    assert [len(face) for face in m.f_uv] == [4] * 8 + [3, 3]
    assert len(m.per_corner()) == 10
    assert cirque.verify(V, mixed, m.uv, m.f_uv)


def test_forms_of_the_map(closed):
    V, F = closed
    m = cirque.flatten(V, F)
    assert m.f_uv.shape == F.shape and m.f_uv.dtype == np.int32
    assert np.array_equal(m.per_corner(), m.uv[m.f_uv])
    vmapping, indices, uvs = m.as_vertices()
    assert np.array_equal(vmapping[indices], F)
    assert len(uvs) == len(vmapping) > len(V)
    assert np.array_equal(uvs[indices], m.per_corner())
    assert not m.uv.flags.writeable
    uv = m.uv
    del m
    assert np.isfinite(uv).all()  # the view keeps what it looks at


def test_arrays_of_other_threads_and_views_are_not_touched(square):
    V, F = square
    before = V.copy(), F.copy()
    V.flags.writeable = F.flags.writeable = False
    cirque.flatten(V, F)
    assert np.array_equal(V, before[0]) and np.array_equal(F, before[1])


def test_cones_of_every_kind(closed):
    V, F = closed
    cones = {v: np.pi for v in range(4)}
    m = cirque.flatten(V, F, cones=cones)
    same = cirque.flatten(V, F, cones=[(v, np.pi, np.pi) for v in range(4)])
    sums = np.full(len(V), 2 * np.pi)
    sums[:4] = np.pi
    assert np.array_equal(m.uv, same.uv)
    assert np.array_equal(m.uv, cirque.flatten(V, F, angle_sums=sums).uv)
    assert cirque.flatten(V, F, cones="greedy", cone_budget=10).status == "ok"
    with pytest.raises(cirque.InvalidInputError, match="one way"):
        cirque.flatten(V, F, cones=cones, angle_sums=sums)
    with pytest.raises(cirque.InvalidInputError, match="cones"):
        cirque.flatten(V, F, cones=[(1,)])


def test_cuts(square):
    V, F = square
    m = cirque.flatten(V, F, cut=[[0, 1], [1, 2]], seams="rigid")
    assert m.status == m.certificate["outcome"] == "ok"
    path = cirque.flatten(V, F, cut_paths=[[0, 84]])
    assert len(path.uv) > len(V)
    with pytest.raises(cirque.InvalidInputError, match="no edge joins the vertices 0 and 50"):
        cirque.flatten(V, F, cut=[[0, 50]])


def test_a_flattener_gives_the_same(closed):
    V, F = closed
    f = cirque.Flattener(V, F)
    for cones in ({v: np.pi for v in range(4)}, {v: 1.5 * np.pi for v in range(8)}):
        assert np.array_equal(f(cones=cones).uv, cirque.flatten(V, F, cones=cones).uv)
    assert "258 vertices" in f.report or str(len(V)) in f.report


def test_errors_say_what_was_meant_and_where(square, closed):
    V, F = square
    with pytest.raises(cirque.InvalidInputError, match="did you mean 'centre'"):
        cirque.disk(V, F, center=3)
    with pytest.raises(cirque.InvalidInputError, match="did you mean 'cut_paths'"):
        cirque.flatten(V, F, cutpaths=[[0, 1]])
    with pytest.raises(ValueError, match="epsilon = '7'"):
        cirque.flatten(V, F, epsilon=7)
    with pytest.raises(cirque.InvalidInputError, match="takes no seams"):
        cirque.disk(V, F, seams="free")
    with pytest.raises(cirque.InvalidInputError, match="vertex 169"):
        cirque.flatten(V, np.vstack([F, [0, 1, len(V)]]))
    with pytest.raises(cirque.InvalidInputError, match="vertex -1"):
        cirque.flatten(V, np.vstack([F, [0, 1, -1]]))
    with pytest.raises(cirque.InvalidInputError, match="integers"):
        cirque.flatten(V, F.astype(float))
    with pytest.raises(cirque.InvalidInputError, match="32 bits"):
        cirque.flatten(V, F.astype(np.int64) + 2**40)
    with pytest.raises(cirque.InvalidInputError, match="N x 3"):
        cirque.flatten(V[:, :1], F)
    with pytest.raises(cirque.InvalidInputError):
        cirque.flatten(V, np.zeros((0, 3), int))
    with pytest.raises(cirque.CirqueError) as refused:
        cirque.disk(*closed)
    assert refused.value.certificate["outcome"] == "invalid_input"


def test_a_mesh_that_is_no_surface_says_where():
    V = np.vstack([np.eye(3), [[1, 1, 1], [2, 2, 0]]])
    V[0] = np.nan
    with pytest.raises(cirque.InvalidInputError) as error:
        cirque.flatten(V, [[0, 1, 2], [1, 0, 3]])
    assert error.value.vertices == [0] and error.value.map is None


def test_infeasible_angles_come_with_their_proof():
    # Across the edge between 0 and 2 lie the vertices 1 and 3, whose angles must stay below pi.
    V = [[0, -0.3, 0], [1, 0, 0], [0, 0.3, 0], [-1, 0, 0]]
    F = [[0, 1, 2], [0, 2, 3]]
    sums = np.pi * np.array([0.1, 0.9, 0.1, 0.9])
    with pytest.raises(cirque.InfeasibleError) as error:
        cirque.flatten(V, F, angle_sums=sums, strict=True)
    proof = error.value.certificate["infeasibility"]
    assert len(proof["face_multiplier"]) == 2 and proof["margin"] > 0
    assert error.value.faces or error.value.vertices


def test_progress_is_told_and_may_cancel(square):
    seen = []
    cirque.flatten(*square, progress=lambda *what: seen.append(what))
    assert {stage for stage, *_ in seen} & {"angles", "radii"}
    assert all(seconds >= 0 for *_, seconds in seen)
    with pytest.raises(cirque.CancelledError):
        cirque.flatten(*square, progress=lambda *what: False)

    def fails(*what):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        cirque.flatten(*square, progress=fails)


def test_other_threads_run_meanwhile():
    V, F = grid(100)
    ticks, stop = [], threading.Event()

    def tick():
        while not stop.is_set():
            ticks.append(0)
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    cirque.flatten(V, F)
    stop.set()
    thread.join()
    assert len(ticks) > 10


def test_ctrl_c_cancels():
    script = ("import cirque, numpy as np, sys\n"
              f"sys.path.insert(0, {os.path.dirname(__file__)!r})\n"
              "from conftest import grid\n"
              "V, F = grid(300)\n"
              "def tell(stage, *rest): print('begun', flush=True)\n"
              "try:\n"
              "    while True: cirque.flatten(V, F, progress=tell)\n"
              "except KeyboardInterrupt:\n"
              "    print('interrupted')\n")
    process = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n"
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=60)
    assert output.endswith("interrupted\n") and process.returncode == 0


def test_measures_and_the_judge(square):
    V, F = square
    m = cirque.disk(V, F)
    figures = m.measures()
    assert figures == cirque.measures(V, F, m.uv, m.f_uv)
    _, values = m.measures(faces=True)
    assert all(len(value) == len(F) for value in values.values())
    assert cirque.verify(V, F, m.uv, m.f_uv, domain="disk", require_injective=True)
    flipped = m.uv * [-1, 1]
    verdict = cirque.verify(V, F, flipped, m.f_uv)
    assert not verdict and verdict.errors and "INVALID" in verdict.verdict
    with pytest.raises(cirque.InvalidInputError, match="did you mean"):
        cirque.verify(V, F, m.uv, m.f_uv, angle_tolerence=1)
    with pytest.raises(cirque.InvalidInputError, match="f_uv"):
        cirque.verify(V, F, m.uv, m.f_uv[:-1])
    with pytest.raises(cirque.InvalidInputError, match="points"):
        cirque.measures(V, F, m.uv[:-1], m.f_uv)


def test_the_judge_takes_a_point_per_vertex(square):
    V, F = square
    assert cirque.verify(V, F, V[:, :2])


def test_an_exact_map_refines_the_mesh(square):
    V, F = square
    sheared = V @ np.array([[1, 0, 0], [2.3, 1, 0], [0, 0, 1]])
    assert cirque.flatten(sheared, F).exact is None
    exact = cirque.flatten(sheared, F, exact=True, refine_map="none").exact
    assert np.array_equal(exact.vertices[:len(V)], sheared)
    assert len(exact.faces) > len(F) and len(exact.faces) == len(exact.face_of_input)
    assert set(exact.face_of_input) == set(range(len(F)))
    edges = exact.uv[exact.f_uv] - np.roll(exact.uv[exact.f_uv], 1, axis=1)
    lengths = exact.vertices[exact.faces] - np.roll(exact.vertices[exact.faces], 1, axis=1)
    if np.ptp(V[:, 2]) == 0:  # flat: an isometry
        assert np.allclose(np.linalg.norm(edges, axis=2), np.linalg.norm(lengths, axis=2))
    assert (edges[..., 0, 0] * edges[..., 1, 1] - edges[..., 0, 1] * edges[..., 1, 0] > 0).all()
    in_disk = cirque.disk(V, F, exact=True).exact
    assert set(in_disk.face_of_input) == set(range(len(F)))
    assert np.hypot(*in_disk.uv.T).max() <= 1 + 1e-12


def test_an_exact_map_to_the_sphere_has_points_of_it(closed):
    V, F = closed
    stretched = V * [1, 1, 3]
    exact = cirque.sphere(stretched, F, exact=True).exact
    assert len(exact.uv) == 0 and len(exact.position) == len(exact.vertices) > len(V)
    assert np.allclose(np.linalg.norm(exact.position, axis=1), 1, atol=1e-15)
    assert (np.linalg.det(exact.position[exact.faces]) > 0).all()
    assert cirque.verify(exact.vertices, exact.faces, exact.position)
    assert cirque.flatten(stretched, F, exact=True).exact.position is None


def test_a_texture_moves_from_one_map_to_another(square):
    V, F = square
    maps = []
    for domain in ("rectangle", "disk"):
        m = cirque.flatten(V, F, domain=domain)
        low, high = m.uv.min(axis=0), m.uv.max(axis=0)
        maps.append(((m.uv - low) / (high - low).max(), m.f_uv))
    y, x = np.mgrid[0:64, 0:64]
    image = np.stack([(x + 0.5) / 64, 1 - (y + 0.5) / 64], axis=2)  # the place in the first map
    moved = cirque.transfer(V, F, *maps, image, size=(40, 50), margin=0)
    assert moved.shape == (40, 50, 2)
    back = cirque.transfer(V, F, maps[1], maps[0],
                           cirque.transfer(V, F, *maps, image, size=(512, 512)), size=(64, 64))
    inside = np.s_[8:56, 8:56]
    assert np.abs(back[inside] - image[inside]).max() < 5e-3
    assert cirque.transfer(V, F, *maps, (255 * image).astype(np.uint8)).dtype == np.uint8
    with pytest.raises(cirque.InvalidInputError, match="image"):
        cirque.transfer(V, F, *maps, np.zeros(3))
