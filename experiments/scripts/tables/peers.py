"""Our program beside others, mesh by mesh: maps, flips, time and memory of whole processes."""
import statistics

from tables import records
from tables.records import median_interval, plt, power_fit, shown, table

OUTPUT = "peers"
BASE = "circle_patterns"
INSIDE = "inside"
LEAST = 1e-5


def name(run):
    return run.record["method"]["name"]


def programs(runs):
    return records.in_order(name(run) for run in runs)


def excess(run):
    value = run.value("quasi_conformal_mean")
    return None if value is None else value - 1


def wall(run):
    return run.seconds("total")


def cpu(run):
    return run.cpu


def memory(run):
    return run.memory


def area(run):
    return run.value("log_area_ratio_l2")


def ratios(runs, program, measure):
    """The measure of a program over that of ours, on every mesh that both map."""
    found = {(run.mesh, name(run)): run for run in runs if run.ok}
    pairs = [(measure(found[mesh, program]), measure(found[mesh, BASE])) for mesh in records.by_size(runs)
             if (mesh, program) in found and (mesh, BASE) in found]
    return [a / b for a, b in pairs if a is not None and b is not None and a > LEAST and b > LEAST]


def with_interval(values):
    if not values:
        return "-"
    low, high = median_interval(values)
    return f"{statistics.median(values):.3g} ({low:.3g} to {high:.3g})"


def outcomes(runs, program):
    counts = {}
    for run in runs:
        if name(run) == program:
            counts[run.outcome] = counts.get(run.outcome, 0) + 1
    return ", ".join(f"{count} {outcome}" for outcome, count in sorted(counts.items(), key=lambda item: -item[1]))


def flips(runs, program):
    return sum((run.value("flipped_triangles") or 0) > 0 for run in runs if name(run) == program)


def program_table(runs):
    rows = []
    for program in programs(runs):
        fit = power_fit([run.triangles for run in runs if name(run) == program and run.ok],
                        [wall(run) for run in runs if name(run) == program and run.ok])
        rows.append([f"`{program}`", outcomes(runs, program), flips(runs, program), with_interval(ratios(runs, program, excess)),
                     with_interval(ratios(runs, program, area)), with_interval(ratios(runs, program, wall)), with_interval(ratios(runs, program, cpu)),
                     with_interval(ratios(runs, program, memory)), "-" if fit is None else f"{fit[0]:.2f}"])
    return table(["program", "outcomes", "meshes with flips", "qc - 1", "area distortion", "time", "CPU time", "memory", "growth"], rows, 2)


def verdict(runs):
    said = []
    for program in programs(runs):
        if program in (BASE, INSIDE):
            continue
        distortion, time = ratios(runs, program, excess), ratios(runs, program, wall)
        if not time:
            continue
        good = sum(run.ok for run in runs if name(run) == program)
        said.append(f"`{program}` maps {good} of {len({run.mesh for run in runs})} meshes, with {statistics.median(distortion):.3g} times the mean "
                    f"quasi-conformal distortion less 1 and {statistics.median(time):.3g} times the time of `{BASE}` (medians of {len(time)})")
    own = [run for run in runs if name(run) == BASE]
    lead = (f"`{BASE}` maps {sum(run.ok for run in own)} of {len(own)} meshes, none with a flipped triangle" if not flips(runs, BASE) else
            f"`{BASE}` maps {sum(run.ok for run in own)} of {len(own)} meshes, {flips(runs, BASE)} with flipped triangles")
    return "; ".join([lead] + said) + "."


def mesh_table(runs):
    found = {(run.mesh, name(run)): run for run in runs}
    others = [program for program in programs(runs) if program != INSIDE]
    rows = []
    for mesh in records.by_size(runs):
        own = [found.get((mesh, program)) for program in others]
        size = max((run.triangles for run in own if run), default=0)
        rows.append([mesh, size] + [shown(run, run and run.value("quasi_conformal_mean"), "{:.4f}") for run in own] +
                    [shown(run, run and wall(run), "{:.3f}") for run in own] + [shown(run, run and memory(run), "{:.0f}") for run in own])
    heads = [f"{what} `{program}`" for what in ("qc", "s", "MiB") for program in others]
    return table(["mesh", "triangles"] + heads, rows)


def tables(runs):
    question = runs[0].record.get("provenance", {}).get("question", "")
    return "\n\n".join([
        "# Beside other programs", f"**Question.** {question}", f"**Answer.** {verdict(runs)}", "![Time against size](peers.svg)",
        f"Whole processes, one thread, each mesh read from and written to .obj; their maps are judged by `cirque/verify`: a map that is none counts as "
        f"`invalid_map`. Columns: multiples of `{BASE}` on the same mesh, median with its 95 % interval; growth is the exponent of time over triangles. "
        f"`{INSIDE}` is our pipeline without process, .obj and writing. A program is added by a line `peer` of the config; BFF's is there, and is left "
        "out where it is not installed.", program_table(runs), "## Mesh by mesh", mesh_table(runs)])


def draw(runs, path):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6))
    for axis, label, measure in zip(axes, ["time [s]", "memory [MiB]"], [wall, memory]):
        for colour, marker, program in zip(records.COLOURS, "os^Dv<", programs(runs)):
            points = [(run.triangles, measure(run)) for run in runs if name(run) == program and run.ok and measure(run)]
            if points:
                axis.plot(*zip(*points), marker, color=colour, markersize=3, alpha=0.6, label=program)
        axis.set(xscale="log", yscale="log", xlabel="triangles", ylabel=label)
        axis.legend(fontsize=6)
    records.save(figure, path)
