"""Every strategy on every registered energy: how often it ends at the minimum, from where, in how many steps and how long."""
import statistics

from tables import records
from tables.records import median_interval, number, plt, power_fit, table

OUTPUT = "energies"
BASE = "newton"
FAMILY = "bumpy_terrain"  # whose sizes growth is fitted on
STARTS = {"own": "where the pipeline would start", "near": "up to 0.1 from newton's minimiser in every parameter",
          "solution": "at newton's minimiser"}
SHORT = {"ceres_trust_region": "ceres LM", "ceres_trust_region:trust_region=dogleg": "ceres dogleg",
         "ceres_line_search:max_iterations=300": "ceres L-BFGS, 300"}


def energy(run):
    return run.method["energy"]


def solver(run):
    return run.method["energy_solver"]


def short(name):
    return SHORT.get(name, name)


def of(runs, start):
    return [run for run in runs if run.method["energy_start"] == start]


def attempted(runs):
    """Runs that a strategy had a chance in: the energy has a minimum here and the form that it needs."""
    return [run for run in runs if run.outcome not in ("infeasible", "invalid_input", "unsupported") and
            not run.record.get("message", "").startswith(f"{BASE}, by whose minimiser")]


def middle(values, text="{:.3g}"):
    return number(statistics.median(values), text) if values else "-"


def paired(runs, found):
    """CPU time over newton's on the same mesh, median with its interval."""
    ratios = [run.cpu / found[run.mesh, BASE].cpu for run in runs
              if run.ok and run.cpu and (run.mesh, BASE) in found and found[run.mesh, BASE].cpu]
    if not ratios:
        return "-"
    low, high = median_interval(ratios)
    return f"{statistics.median(ratios):.3g} ({low:.3g} to {high:.3g})"


def growth(runs):
    own = [run for run in runs if run.ok and run.family == FAMILY]
    fit = power_fit([run.triangles for run in own], [run.cpu for run in own])
    return "-" if fit is None else f"{fit[0]:.2f}"


def steps(runs):
    values = [run.value("energy_iterations") for run in runs if run.ok]
    return f"{statistics.median(values):.0f} ({min(values):.0f} to {max(values):.0f})" if values else "-"


def energy_table(runs, name):
    own = [run for run in runs if energy(run) == name]
    found = {(run.mesh, solver(run)): run for run in own if run.ok}
    rows = []
    for strategy in records.in_order(solver(run) for run in own):
        mine = [run for run in own if solver(run) == strategy]
        tried = attempted(mine)
        good = [run for run in tried if run.ok]
        if not tried:
            rows.append([f"`{short(strategy)}`", "no such form", "", "", "", "", "", ""])
            continue
        rows.append([f"`{short(strategy)}`", f"{len(good)} of {len(tried)}", steps(good),
                     middle([run.value("energy_factorizations") for run in good], "{:.0f}"),
                     middle([run.cpu for run in good]), paired(good, found), growth(good),
                     number(max([run.value("energy_difference") for run in good], default=None), "{:.1e}")])
    return table(["strategy", "converged", "iterations (least to most)", "factorizations", "CPU s", "CPU over newton (95 %)", "growth",
                  "farthest from newton's"], rows, 2)


def share(runs, start, strategy):
    tried = attempted([run for run in of(runs, start) if solver(run) == strategy])
    return sum(run.ok for run in tried), len(tried)


def verdict(runs):
    strategies = records.in_order(solver(run) for run in of(runs, "own"))
    said = []
    for strategy in strategies:
        good, tried = share(runs, "own", strategy)
        if tried:
            said.append(f"`{short(strategy)}` {good} of {tried}")
    meshes = {run.mesh for run in runs}
    newton = [run for run in attempted(of(runs, "own")) if solver(run) == BASE and run.ok]
    most = max(newton, key=lambda run: run.value("energy_iterations"), default=None)
    text = f"On {len(meshes)} meshes, minima reached from the pipeline's start: {', '.join(said)}."
    if newton:
        text += (f" `{BASE}` takes {steps(newton)} iterations, the most on {most.mesh} ({energy(most)}), and its CPU time grows like the "
                 f"triangles to the power {growth(newton_only(newton))} (circle_pattern, `{FAMILY}`).")
    at_solution = [run for run in attempted(of(runs, "solution"))]
    if at_solution:
        few = sum(run.ok and run.value("energy_iterations") <= 1 for run in at_solution)
        text += f" Started at its own minimiser it stops within one step in {few} of {len(at_solution)}."
    return text


def newton_only(runs):
    return [run for run in runs if energy(run) == "circle_pattern"]


def failures(runs):
    """Outcomes of the runs that did not end at a minimum, by energy and strategy."""
    counts = {}
    for run in runs:
        if not run.ok:
            reason = run.record.get("message", "").split(":")[0] if run.outcome == "not_converged" else run.outcome
            key = (energy(run), short(solver(run)), run.method["energy_start"], reason)
            counts.setdefault(key, []).append(run.mesh)
    rows = [[f"`{key[0]}`", f"`{key[1]}`", key[2], key[3], len(meshes), ", ".join(meshes[:4]) + (", ..." if len(meshes) > 4 else "")]
            for key, meshes in sorted(counts.items()) if key[3] != "unsupported"]
    return table(["energy", "strategy", "start", "ended by", "runs", "meshes"], rows, 4)


def tables(runs):
    question = runs[0].record.get("provenance", {}).get("question", "")
    text = ["# Strategies on energies", f"**Question.** {question}", f"**Answer.** {verdict(runs)}", "![Iterations and time against size](energies.svg)",
            "Every run minimises one energy on one surface, whose vertices are flat (of a closed surface all have the same share of its "
            "curvature). *converged*: runs that met the gradient test, of those where there is a minimum to find (a fit has angles, newton "
            "ends at all) and the energy has the form that the strategy needs; the other columns are of those runs: iterations, median of "
            "factorizations and of the solve's CPU time, its ratio to newton's on the same mesh with the 95 % interval of the median, "
            f"exponent of CPU time over triangles on `{FAMILY}`, largest distance of a minimiser from newton's [rad, log radii]."]
    for start, where in STARTS.items():
        own = of(runs, start)
        if not own:
            continue
        text.append(f"## Start `{start}`: {where}")
        for name in records.in_order(energy(run) for run in own):
            text += [f"### {name}", energy_table(own, name)]
    text += ["## What did not converge", failures(runs)]
    return "\n\n".join(text)


def draw(runs, path):
    own = attempted(of(runs, "own"))
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6))
    for axis, label, measure in zip(axes, ["iterations", "CPU time [s]"],
                                    [lambda run: run.value("energy_iterations"), lambda run: run.cpu]):
        for colour, marker, strategy in zip(records.COLOURS, "os^Dv<", records.in_order(solver(run) for run in own)):
            points = [(run.triangles, measure(run)) for run in own if solver(run) == strategy and run.ok and measure(run)]
            if points:
                axis.plot(*zip(*points), marker, color=colour, markersize=2, alpha=0.5, label=short(strategy),
                          rasterized=True)
        axis.set(xscale="log", yscale="log", xlabel="triangles", ylabel=label)
        axis.legend(fontsize=6, markerscale=2)
    records.save(figure, path)
