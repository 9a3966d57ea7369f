"""Do the objectives of the angle fit give similar results? The thesis compares `quadratic` and `barrier`."""
import statistics

from tables import records
from tables.records import plt, quantiles, shown, table

OUTPUT = "qp_vs_nonlinear"
OBJECTIVES = ["quadratic", "weighted_quadratic", "barrier", "entropy", "least_squares"]
GROUPS = {"raw": "on the connectivity of the files", "delaunay": "on intrinsic Delaunay connectivity",
          "refined": "on intrinsic Delaunay connectivity with the map refined"}
LEAST = 1e-5  # an excess below is no distortion: ratios of such say nothing
MEASURES = [
    ("quasi_conformal_mean", "Mean quasi-conformal distortion", "{:.4f}"),
    ("quasi_conformal_max", "Largest quasi-conformal distortion", "{:.4g}"),
    ("angle_error_mean", "Mean change of the corner angles [rad]", "{:.4f}"),
    ("log_area_ratio_l2", "L2 norm of the log area ratio", "{:.3f}"),
    ("angle_factorizations", "Factorizations of the angle fit", "{:.0f}"),
]


def capital(text):
    return text[0].upper() + text[1:]


def excess(run):
    return run.value("quasi_conformal_mean") - 1


def pairs(runs, group, objective, base="quadratic"):
    """(run with the objective, run with the base) on every mesh that both map."""
    found = {(run.mesh, run.method["angle_objective"]): run for run in runs if run.group == group and run.ok}
    meshes = records.by_size(runs)
    return [(found[mesh, objective], found[mesh, base]) for mesh in meshes
            if (mesh, objective) in found and (mesh, base) in found]


def ratios(compared, measure):
    return [measure(a) / measure(b) for a, b in compared if measure(a) > LEAST and measure(b) > LEAST]


def outcomes(runs, group, objective):
    """"14 ok, 2 infeasible"."""
    counts = {}
    for run in runs:
        if run.group == group and run.method["angle_objective"] == objective:
            counts[run.outcome] = counts.get(run.outcome, 0) + 1
    return ", ".join(f"{count} {outcome}" for outcome, count in sorted(counts.items(), key=lambda c: (c[0] != "ok", c)))


def against_quadratic(runs, group):
    """Every objective as a multiple of the quadratic one: median (least to greatest) over the meshes that both map."""
    rows = []
    for objective in OBJECTIVES:
        compared = pairs(runs, group, objective)
        rows.append([f"`{objective}`", outcomes(runs, group, objective), quantiles(ratios(compared, excess)),
                     quantiles(ratios(compared, lambda run: run.value("angle_error_mean"))),
                     quantiles(ratios(compared, lambda run: run.value("log_area_ratio_l2"))),
                     quantiles([a.cpu / b.cpu for a, b in compared])])
    return table(["objective", "outcomes", "qc mean - 1", "angle change", "log area ratio", "CPU time"], rows, 2)


def within(values, factor):
    return sum(1 / factor <= value <= factor for value in values)


def verdict(runs):
    sentences = []
    for group, where in GROUPS.items():
        compared = pairs(runs, group, "barrier")
        distortion = ratios(compared, excess)
        if not distortion:
            continue
        sentences.append(
            f"{capital(where)} the nonlinear energy's excess of the mean quasi-conformal distortion over 1 is "
            f"{statistics.median(distortion):.3g} times the quadratic program's (median of {len(distortion)} meshes; "
            f"{min(distortion):.3g} to {max(distortion):.3g}), within 10 % on {within(distortion, 1.1)} and within a "
            f"factor of 2 on {within(distortion, 2)} of them; it takes "
            f"{statistics.median([a.cpu / b.cpu for a, b in compared]):.3g} times the CPU time.")
    return "\n".join(sentences)


def measure_table(runs, group, measure, text):
    found = {(run.mesh, run.method["angle_objective"]): run for run in runs if run.group == group}
    rows = []
    for mesh in records.by_size(runs):
        own = [found.get((mesh, objective)) for objective in OBJECTIVES]
        size = max((run.triangles for run in own if run), default=0)
        rows.append([mesh, size] + [shown(run, run and run.value(measure), text) for run in own])
    return table(["mesh", "triangles"] + [f"`{objective}`" for objective in OBJECTIVES], rows)


def tables(runs):
    text = ["# Quadratic program against nonlinear energy", verdict(runs),
            "Figures below: every objective as a multiple of `quadratic` on the same mesh, median (least to greatest) over "
            "the meshes that both map. CPU time is that of the whole run, read to measures, one thread."]
    for group, where in GROUPS.items():
        text += [f"## {capital(where)}", against_quadratic(runs, group)]
        for measure, title, form in MEASURES:
            text += [f"### {title}, {where}", measure_table(runs, group, measure, form)]
    return "\n\n".join(text)


def draw(runs, path):
    figure, axes = plt.subplots(1, len(GROUPS), figsize=(3.8 * len(GROUPS), 3.6))
    for axis, (group, where) in zip(axes, GROUPS.items()):
        everything = [LEAST]
        for colour, marker, objective in zip(records.COLOURS, "os^D", OBJECTIVES[1:]):
            points = [(max(excess(b), LEAST), max(excess(a), LEAST)) for a, b in pairs(runs, group, objective)]
            everything += [x for point in points for x in point]
            if points:
                axis.plot(*zip(*points), marker, color=colour, markersize=4, label=objective)
        ends = [min(everything), max(everything)]
        axis.plot(ends, ends, color="#888888", linewidth=0.8)
        axis.set(xscale="log", yscale="log", title=where.replace(" with ", "\nwith "), xlabel="mean qc - 1, quadratic", ylabel="mean qc - 1")
        axis.legend()
    records.save(figure, path)
