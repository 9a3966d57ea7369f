"""Does every real disk end in a certified map?"""
import statistics

from tables import records
from tables.records import number, plt, table

OUTPUT = "disks"
COLUMNS = [
    ("smallest angle", "smallest_angle", "{:.1e}"), ("smallest theta", "smallest_theta", "{:.1e}"),
    ("angle factorizations", "angle_factorizations", "{:.0f}"), ("radii factorizations", "radii_factorizations", "{:.0f}"),
    ("vertex sums", "vertex_sum_residual", "{:.0e}"), ("gradient", "radii_gradient", "{:.0e}"), ("angle gap", "angle_gap", "{:.0e}"),
    ("radii gap", "radii_gap", "{:.0e}"), ("flips", "flipped_triangles", "{:.0f}"), ("qc mean", "quasi_conformal_mean", "{:.4f}"),
    ("qc max", "quasi_conformal_max", "{:.4g}"),
]


def largest(runs, name):
    return max((run.value(name) for run in runs if run.value(name) is not None), default=None)


def paired(runs):
    """(input, delaunay) on every disk that both map."""
    found = {(run.mesh, run.group): run for run in runs if run.ok}
    return [(found[mesh, "input"], found[mesh, "delaunay"]) for mesh in records.by_size(runs)
            if (mesh, "input") in found and (mesh, "delaunay") in found]


def verdict(runs):
    meshes = records.by_size(runs)
    good = [run for run in runs if run.ok]
    lost = [f"{run.mesh} ({run.group}: {run.outcome})" for run in runs if not run.ok]
    less = [(a.value("quasi_conformal_mean") - 1, b.value("quasi_conformal_mean") - 1) for a, b in paired(runs)]
    ratios = [b / a for a, b in less if a > 1e-5 and b > 1e-5]
    yes = "Yes" if not lost else "No"
    return (f"{yes}: {len(good)} of {len(runs)} runs on {len(meshes)} disks end in a map" + (f", without are {', '.join(lost)}" if lost else "") +
            f". {largest(good, 'flipped_triangles'):.0f} triangles of any map are flipped; the largest gradient of the radii is "
            f"{number(largest(good, 'radii_gradient'), '{:.0e}')} rad, the largest duality gap of the angles {number(largest(good, 'angle_gap'), '{:.0e}')}; at most "
            f"{number(largest(good, 'angle_factorizations'), '{:.0f}')} factorizations fit the angles. Delaunay flips leave {statistics.median(ratios):.2g} times "
            f"the mean quasi-conformal distortion less 1 (median of {len(ratios)}; {min(ratios):.2g} to {max(ratios):.2g}).")


def tables(runs):
    found = {(run.mesh, run.group): run for run in runs}
    rows = []
    for mesh in records.by_size(runs):
        for group in ("input", "delaunay"):
            run = found.get((mesh, group))
            if run:
                rows.append([mesh, run.triangles, group, run.outcome, run.record["overlap"]] +
                            [number(run.value(name), text) for _, name, text in COLUMNS])
    question = runs[0].record.get("provenance", {}).get("question", "")
    head = ["mesh", "triangles", "triangulation", "outcome", "overlap"] + [name for name, _, _ in COLUMNS]
    return "\n\n".join(["# Disks", f"**Question.** {question}", f"**Answer.** {verdict(runs)}",
                        "On the connectivity of the files (`input`) and after intrinsic Delaunay flips (`delaunay`). Where `input` is much more "
                        "distorted, that is the price of raw connectivity: edges that are not Delaunay are made so by force.", table(head, rows)])


def draw(runs, path):
    pairs = [(max(a.value("quasi_conformal_mean") - 1, 1e-6), max(b.value("quasi_conformal_mean") - 1, 1e-6)) for a, b in paired(runs)]
    figure, axis = plt.subplots(figsize=(4, 3.6))
    if pairs:
        axis.plot(*zip(*pairs), "o", color=records.COLOURS[0], markersize=4)
        ends = [min(min(pair) for pair in pairs), max(max(pair) for pair in pairs)]
        axis.plot(ends, ends, color="#888888", linewidth=0.8)
    axis.set(xscale="log", yscale="log", xlabel="mean qc - 1 on the files' connectivity", ylabel="after Delaunay flips")
    records.save(figure, path)
