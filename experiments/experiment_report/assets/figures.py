"""Figures for papers from the tables of experiment_report: figures.py RUNS.json CONVERGENCE.json
FIGURES.json"""
import json
import math
import pathlib
import sys

import matplotlib

matplotlib.use("pdf")
import matplotlib.pyplot as plt

plt.rcParams.update({"font.family": "serif", "font.size": 9, "figure.figsize": (3.4, 2.6),
                     "pdf.fonttype": 42, "savefig.bbox": "tight"})

LEAST = 1e-5  # less distortion is drawn as this


def methods(runs):
    return sorted({run["method"] for run in runs})


def values(runs, *names):
    """The rows of the runs that have numbers in all the named columns."""
    rows = [[run.get(name) for name in names] for run in runs]
    return list(zip(*[row for row in rows if None not in row]))


def save(axes, path, drawn):
    if len(axes.get_legend_handles_labels()[1]) > 1:
        axes.legend(frameon=False, fontsize=7)
    if drawn:
        axes.figure.savefig(path)
        print(f"figure: {path}")
    plt.close(axes.figure)


def scatter(runs, x, y, labels, path):
    axes = plt.figure().add_subplot(xlabel=labels[0], ylabel=labels[1], xscale="log", yscale="log")
    drawn = False
    for marker, method in zip("os^Dv<>ph*" * 10, methods(runs)):
        columns = values([run for run in runs if run["method"] == method], x, y)
        if columns:
            axes.plot(*columns, marker, markersize=3, label=method)
            drawn = True
    save(axes, path, drawn)


def histogram(runs, column, label, path):
    axes = plt.figure().add_subplot(xlabel=label, ylabel="runs", xscale="log")
    data = [values([run for run in runs if run["method"] == m], column) for m in methods(runs)]
    labelled = [(d[0], m) for d, m in zip(data, methods(runs)) if d]
    if labelled:
        everything = [value for d, _ in labelled for value in d]
        low, high = math.log10(min(everything)), math.log10(max(everything))
        bins = [10 ** (low + (high - low + 0.01) * i / 16) for i in range(17)]
        axes.hist([d for d, _ in labelled], bins=bins, stacked=True, label=[m for _, m in labelled])
    save(axes, path, bool(labelled))


def convergence(rows, stage, path):
    axes = plt.figure().add_subplot(xlabel="iteration", ylabel="largest gradient entry", yscale="log")
    curves = {}
    for row in rows:
        if row["stage"] == stage and row["gradient"] is not None:
            curve = curves.setdefault((row["key"], row["strategy"]), ([], []))
            curve[0].append(row["iteration"])
            curve[1].append(row["gradient"])
    colours = {}
    for (_, strategy), curve in sorted(curves.items()):
        label = None if strategy in colours else strategy
        colour = colours.setdefault(strategy, f"C{len(colours)}")
        axes.plot(*curve, color=colour, linewidth=0.8, alpha=0.8, label=label)
    save(axes, path, bool(curves))


def bins_of(figure, number=16):
    """The borders of bins that look equally wide on the figure's axis."""
    values = [x for _, x, _ in figure["points"] if x > 0 or figure["x_scale"] == "linear"] or [1]
    if figure["x_scale"] == "linear":
        return number
    low, high = math.log10(min(values)), math.log10(max(values))
    return [10 ** (low + (high - low + 0.01) * i / number) for i in range(number + 1)]


def asked_for(figure, path):
    """A figure that the config asks for, from its points [series, x, y]."""
    axes = plt.figure().add_subplot(xlabel=figure["x_label"], ylabel=figure["y_label"] or "runs",
                                    xscale=figure["x_scale"], yscale=figure["y_scale"])
    series = {}
    for name, x, y in figure["points"]:
        series.setdefault(name, []).append((x, y))
    if figure["kind"] == "histogram":
        axes.hist([[x for x, _ in points] for points in series.values()], bins=bins_of(figure),
                  stacked=True, label=list(series))
    style = "-" if figure["kind"] == "lines" else ""
    for marker, (name, points) in zip("os^Dv<>ph*" * 10, sorted(series.items())):
        if figure["kind"] != "histogram":
            axes.plot(*zip(*points), marker + style, markersize=3, linewidth=0.8, label=name)
    save(axes, path, bool(series))


def main(runs_path, convergence_path, figures_path):
    runs = json.loads(pathlib.Path(runs_path).read_text())
    rows = json.loads(pathlib.Path(convergence_path).read_text())
    maps = [run for run in runs if run["outcome"] == "ok"]
    for run in maps:  # a ratio that is at least 1: what a logarithmic axis can show is its excess
        ratio = run.get("quasi_conformal_mean")
        run["excess"] = None if ratio is None else max(ratio - 1, LEAST)
    folder = pathlib.Path(runs_path).parent
    for number, figure in enumerate(json.loads(pathlib.Path(figures_path).read_text()), start=1):
        asked_for(figure, folder / f"figure_{number}.pdf")
    ratio = "mean quasi-conformal ratio $-$ 1"
    scatter(maps, "mesh_triangles", "seconds_total", ("triangles", "time [s]"), folder / "time.pdf")
    scatter(maps, "excess", "log_area_ratio_l2", (ratio, "log area ratio, rms"),
            folder / "distortion.pdf")
    histogram(maps, "excess", ratio, folder / "angles.pdf")
    for stage in ("angles", "radii"):
        convergence(rows, stage, folder / f"convergence_{stage}.pdf")


main(*sys.argv[1:])
