"""What studies have in common: records as they read them, figures, and the pages they write."""
import json
import math
import os
import pathlib
import statistics

import matplotlib

from tables.runs import (BadRecords, Run, by_choice, by_size, in_order, median_interval, number, quantiles, read,  # noqa: F401
                         shown, table, value_table)

matplotlib.use("svg")
import matplotlib.pyplot as plt

plt.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "cirque", "font.size": 8, "axes.grid": True,
                     "grid.alpha": 0.3, "legend.frameon": False})

COLOURS = ["#1b6ca8", "#c8553d", "#4a8c5c", "#8a5a9e", "#b8860b", "#5f6b73"]


def power_fit(sizes, values):
    """(exponent, factor) of values = factor sizes^exponent by least squares of the logarithms; None where there are
    fewer than three sizes."""
    points = [(math.log(x), math.log(y)) for x, y in zip(sizes, values) if y and y > 0]
    if len({x for x, _ in points}) < 3:
        return None
    mean_x = statistics.fmean(x for x, _ in points)
    mean_y = statistics.fmean(y for _, y in points)
    slope = sum((x - mean_x) * (y - mean_y) for x, y in points) / sum((x - mean_x) ** 2 for x, _ in points)
    return slope, math.exp(mean_y - slope * mean_x)


def origin(runs):
    """By what code, when, where and for how long the runs were made."""
    of = [run.record.get("provenance", {}) for run in runs]

    def named(key):
        return ", ".join(sorted({str(one[key]) for one in of if key in one})) or "unknown"

    days = sorted(one["started"][:10] for one in of if "started" in one)
    when = "" if not days else f" on {days[0]}" if days[0] == days[-1] else f" from {days[0]} to {days[-1]}"
    cpu = sum(run.cpu or 0 for run in runs)
    return f"{len(runs)} runs of commit {named('commit')}, {cpu:.0f} s of CPU time ({named('cpu')}){when}."


def is_everywhere(run):
    """Whether every machine with Debian's packages has the mesh."""
    source = run.record["mesh"].get("source", "")
    return source.startswith("/usr/share/doc/libcgal-dev/") or (not source.startswith("/") and "triangles=" in source)


def figure_of(run):
    """What tells whether a run comes out as it did: (name, value)."""
    name = "energy_value" if run.value("quasi_conformal_mean") is None else "quasi_conformal_mean"
    return name, run.value(name)


def sample(runs, count=3):
    """The run of least time, of a map with some distortion or a minimum, of each of the first methods: what a test makes
    again to see whether the page is of today."""
    chosen = {}
    for run in sorted((r for r in runs if r.ok and is_everywhere(r)), key=lambda r: (r.cpu or 0, r.mesh)):
        name, value = figure_of(run)
        if value and (name != "quasi_conformal_mean" or value > 1.001):
            chosen.setdefault(run.record["method"]["name"], run)
    return list(chosen.values())[:count]


def sample_line(run):
    name, value = figure_of(run)
    cell = {"mesh": run.mesh, "method": run.record["method"]["name"], name: float(f"{value:.9g}")}
    return f"<!-- sample {json.dumps(cell)} -->"


def write(path, study, text, runs):
    """The whole page or nothing. Ends with where it comes from, and with cells that tell whether it is of today's code."""
    head = f"<!-- Written by `experiments/scripts/make_study {study}` from the records of configs/{study}.yaml. -->\n\n"
    foot = "\n".join(["", f"Made of {origin(runs)}", "", *map(sample_line, sample(runs))])
    path = pathlib.Path(path)
    temporary = path.with_name(path.name + f".tmp.{os.getpid()}")
    temporary.write_text(head + text.rstrip() + "\n" + foot.rstrip() + "\n")
    temporary.replace(path)


def save(figure, path):
    figure.savefig(path, metadata={"Date": None}, bbox_inches="tight")
    plt.close(figure)
