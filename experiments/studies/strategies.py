"""Iterations, factorizations and time of every strategy against the size of the mesh."""
from studies import records
from studies.records import plt, power_fit, shown, table

OUTPUT = "strategies_by_size"
PROBLEMS = {
    "log radii": ("radii", lambda run: run.group.startswith("radii"), lambda run: run.method["strategy"]),
    "angles, quadratic": ("angle", lambda run: run.group.startswith("angles") and
                          run.method["angle_fit"] == "quadratic", lambda run: run.method["angle_strategy"]),
    "angles, barrier": ("angle", lambda run: run.group.startswith("angles") and run.method["angle_fit"] == "barrier",
                        lambda run: run.method["angle_strategy"]),
}
STAGE = {"radii": "radii", "angle": "angles"}


def problem_runs(runs, problem):
    """{(mesh, strategy): run} and the strategies in order."""
    _, belongs, strategy = PROBLEMS[problem]
    own = [run for run in runs if belongs(run)]
    return {(run.mesh, strategy(run)): run for run in own}, records.in_order(strategy(run) for run in own)


def cell(run, stage):
    """"iterations / factorizations / seconds of the stage"."""
    if run is None:
        return ""
    if not run.ok:
        return run.outcome
    factorizations = run.value(f"{stage}_factorizations")
    return (f"{run.value(f'{stage}_iterations'):.0f} / {shown(run, factorizations, '{:.0f}')} / "
            f"{run.seconds(STAGE[stage]):.3g}")


def growth(found, strategy, meshes, stage):
    """The exponent of the stage's time over triangles on the generated family."""
    own = [found[mesh, strategy] for mesh in meshes
           if (mesh, strategy) in found and found[mesh, strategy].ok and
           found[mesh, strategy].family == "bumpy_terrain"]
    fit = power_fit([run.triangles for run in own], [run.seconds(STAGE[stage]) for run in own])
    return "-" if fit is None else f"{fit[0]:.2f}"


def problem_table(runs, problem):
    stage = PROBLEMS[problem][0]
    found, strategies = problem_runs(runs, problem)
    meshes = [mesh for mesh in records.by_size(runs) if any((mesh, strategy) in found for strategy in strategies)]
    size = {mesh: run.triangles for (mesh, _), run in found.items()}
    rows = [[mesh, size[mesh]] + [cell(found.get((mesh, strategy)), stage) for strategy in strategies]
            for mesh in meshes]
    rows.append(["exponent of the time", ""] + [growth(found, strategy, meshes, stage) for strategy in strategies])
    return table(["mesh", "triangles"] + [f"`{strategy}`" for strategy in strategies], rows)


def tables(runs):
    text = ["# Strategies against size",
            "Cells: iterations / factorizations / wall time of the stage [s], or the outcome of a run without a map. "
            "The last row: the exponent p of time = c triangles^p on `bumpy_terrain`, by least squares of the logarithms."]
    for problem in PROBLEMS:
        text += [f"## {problem.capitalize()}", problem_table(runs, problem)]
    return "\n\n".join(text)


def draw(runs, path):
    figure, axes = plt.subplots(1, len(PROBLEMS), figsize=(3.3 * len(PROBLEMS), 3), squeeze=False)
    for axis, (problem, (stage, _, _)) in zip(axes.flat, PROBLEMS.items()):
        found, strategies = problem_runs(runs, problem)
        for colour, marker, strategy in zip(records.COLOURS, "os^Dv<", strategies):
            points = sorted((run.triangles, run.value(f"{stage}_iterations")) for (_, name), run in found.items()
                            if name == strategy and run.ok)
            if points:
                axis.plot(*zip(*points), marker + "-", color=colour, markersize=3, linewidth=0.8, label=strategy)
        axis.set(xscale="log", yscale="log", title=problem, xlabel="triangles", ylabel="iterations")
        axis.legend(fontsize=6)
    records.save(figure, path)
